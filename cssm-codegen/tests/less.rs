//! A case that needs less emits strictly less: functions, bindings, record bytes and words.

use cssm_codegen::{Generated, dsl, generate};
use cssm_core::table::{RecordKind, ShaderKind};

fn declared(body: &str) -> Generated {
    let cases = dsl::parse_file("case", &format!("pub case Sun {{ {body} }}"));
    generate(&cases.unwrap_or_else(|report| panic!("{report}"))[0]).unwrap()
}

/// What one shader of a case holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Size {
    functions: usize,
    bindings: usize,
    constants: usize,
    words: usize,
    record_bytes: u32,
}

fn size(generated: &Generated, kind: ShaderKind) -> Size {
    let table = &generated.table;
    let shader = table.shader(kind).unwrap();
    let count = |start: &str| shader.wgsl.lines().filter(|line| line.starts_with(start)).count();
    Size {
        functions: count("fn "),
        bindings: count("@group"),
        constants: count("const "),
        words: shader.spirv.len() / 4,
        record_bytes: table.record(RecordKind::Shadow).unwrap().size_bytes,
    }
}

fn mask(body: &str) -> Size {
    size(&declared(body), ShaderKind::Mask)
}

#[test]
fn fewer_kinds_of_selection_are_fewer_functions_constants_and_words() {
    let walk_and_bands = mask("technique: camera_space");
    let walk = mask("technique: camera_space, distribution: bands(1)");
    let bands = mask("technique: parallel_split, shadow_distance: 1 km");
    let one = mask("technique: standard, shadow_distance: 1 km");
    for (more, less) in [(walk_and_bands, walk), (walk_and_bands, bands), (walk, one), (bands, one)] {
        assert!(more.functions >= less.functions, "{more:?} {less:?}");
        assert!(more.constants > less.constants, "{more:?} {less:?}");
        assert!(more.words > less.words, "{more:?} {less:?}");
        assert!(more.record_bytes > less.record_bytes, "{more:?} {less:?}");
        assert_eq!(more.bindings, less.bindings);
    }
    assert!(walk_and_bands.functions > one.functions);
}

#[test]
fn no_filter_is_no_sampler() {
    let none = mask("filter: none");
    for filter in ["hardware_2x2", "gather_2x2"] {
        let filtered = mask(&format!("filter: {filter}"));
        assert_eq!(filtered.bindings, none.bindings + 1, "{filter}");
        assert_eq!(filtered.constants, none.constants + 1, "{filter}");
        assert!(filtered.words > none.words, "{filter}");
    }
}

#[test]
fn a_kernel_that_measures_less_is_smaller() {
    let gather = mask("filter: gather_2x2");
    let texels = mask("filter: pcf_5x5");
    let metres = mask("filter: pcf_5x5 { kernel: metres(5 cm) }");
    let pixels = mask("filter: pcf_5x5 { kernel: pixels(3 px) }");
    for (less, more) in [(gather, texels), (texels, metres), (metres, pixels)] {
        assert!(less.functions <= more.functions && less.words < more.words, "{less:?} {more:?}");
        assert_eq!(less.bindings, more.bindings);
    }
    let soft = mask("filter: pcss");
    assert!(metres.words < soft.words && metres.functions < soft.functions);

    // Pixels need the view; nothing else asks for more than the facet.
    assert_eq!(gather.record_bytes, metres.record_bytes);
    assert!(metres.record_bytes < pixels.record_bytes);
}

#[test]
fn a_bias_that_reads_less_is_smaller() {
    let words = |bias: &str| mask(&format!("bias: {bias}, filter: gather_2x2"));
    let (none, constant, world_texel, slope, plane) =
        (words("none"), words("constant"), words("world_texel"), words("slope"), words("receiver_plane"));
    assert!(none.words < constant.words && constant.words < world_texel.words);
    assert!(world_texel.words < slope.words && slope.words < plane.words);
    assert!(none.record_bytes < constant.record_bytes);
    assert!(none.functions < plane.functions);

    // Without a normal there is nothing to reconstruct.
    let fetches = |bias: &str| {
        let generated = declared(&format!("bias: {bias}"));
        generated.table.shader(ShaderKind::Mask).unwrap().wgsl.matches("sun_inverse_depth_at(").count()
    };
    assert_eq!((fetches("constant"), fetches("slope")), (2, 6));
}

#[test]
fn an_interface_that_is_not_declared_is_not_there() {
    let both = declared("");
    let mask = declared("resolve: [mask]");
    let function = declared("resolve: [function]");
    assert!(mask.table.shader(ShaderKind::Function).is_none());
    assert!(function.table.shader(ShaderKind::Mask).is_none());
    assert!(
        function.table.record(RecordKind::Mask).is_none() && function.table.pass(ShaderKind::Mask).is_none()
    );
    assert!(mask.rust.len() < both.rust.len() && function.rust.len() < both.rust.len());
    assert!(mask.json.len() < both.json.len() && function.json.len() < both.json.len());
}

#[test]
fn depth_is_measured_only_where_it_is_declared() {
    let measured = declared("fit: histogram, resolve: [mask]");
    assert!(measured.table.reduction.is_some() && measured.table.shader(ShaderKind::Fit).is_some());
    for body in ["resolve: [mask]", "fit: bounds, resolve: [mask]", "fit: histogram, resolve: [function]"] {
        let table = declared(body).table;
        assert!(table.reduction.is_none() && table.record(RecordKind::Fit).is_none(), "{body}");
        assert!(table.groups.iter().all(|group| group.shader != ShaderKind::Fit), "{body}");
    }
}

#[test]
fn a_depth_in_metres_needs_no_decoding_record() {
    let reversed = declared("resolve: [mask]");
    let linear = declared("resolve: [mask { depth: linear }]");
    let bytes = |generated: &Generated| generated.table.record(RecordKind::Mask).unwrap().size_bytes;
    assert!(bytes(&linear) < bytes(&reversed));
}

#[test]
fn fewer_bands_are_fewer_bytes_and_other_tables() {
    let (eight, five) = (declared("distribution: bands(8)"), declared("distribution: bands(5)"));
    let (eight_size, five_size) = (size(&eight, ShaderKind::Mask), size(&five, ShaderKind::Mask));
    assert!(eight_size.record_bytes > five_size.record_bytes);
    assert_ne!(eight.table.fingerprint, five.table.fingerprint);
    assert_ne!(eight.json, five.json);
}

#[test]
fn opaque_casters_need_no_alpha_mask() {
    let (opaque, tested) = (declared(""), declared("casters: alpha_tested"));
    let masks = [ShaderKind::CaptureTested, ShaderKind::CaptureTestedClamped];
    for shader in masks {
        assert!(opaque.table.shader(shader).is_none() && opaque.table.pass(shader).is_none());
        assert!(tested.table.shader(shader).is_some() && tested.table.pass(shader).is_some());
    }
    assert!(opaque.table.record(RecordKind::CasterMask).is_none());
    assert!(tested.table.record(RecordKind::CasterMask).is_some());
    for output in [&opaque.rust, &opaque.json] {
        let output = output.to_ascii_lowercase();
        assert!(
            !output.contains("caster_mask") && !output.contains("castermask") && !output.contains("tested")
        );
    }

    // A case with masks pays for them in the tested shaders alone.
    for shader in opaque.table.shaders.iter() {
        let other = tested.table.shader(shader.kind).unwrap();
        assert_eq!(shader.spirv, other.spirv, "{}", shader.kind.name());
        assert!(!other.wgsl.contains("uv") && !other.wgsl.contains("caster_mask"), "{}", shader.kind.name());
    }
    let words = |shader| tested.table.shader(shader).unwrap().spirv.len();
    assert!(words(ShaderKind::Capture) < words(ShaderKind::CaptureTested));
    assert!(words(ShaderKind::CaptureClamped) < words(ShaderKind::CaptureTestedClamped));
}

#[test]
fn a_tested_capture_writes_no_depth_of_its_own_where_depth_stays_unclipped() {
    let tested = declared("casters: alpha_tested");
    let writes = |shader| tested.table.shader(shader).unwrap().wgsl.contains("frag_depth");
    assert!(!writes(ShaderKind::CaptureTested) && writes(ShaderKind::CaptureTestedClamped));
}

#[test]
fn a_fixed_depth_order_has_no_sign() {
    for filter in ["none", "hardware_2x2", "gather_2x2"] {
        for bias in ["none", "constant", "slope", "world_texel", "receiver_plane"] {
            let fixed = declared(&format!(
                "technique: standard, shadow_distance: 1 km, filter: {filter}, bias: {bias}, resolve: [mask, function]"
            ));
            assert!(
                !fixed.rust.contains("depth_sign") && !fixed.json.contains("depth_sign"),
                "{filter} {bias}"
            );
            let chosen = declared(&format!("filter: {filter}, bias: {bias}, resolve: [mask, function]"));
            for shader in [ShaderKind::Mask, ShaderKind::Function] {
                let text = &chosen.table.shader(shader).unwrap().wgsl;
                assert!(
                    text.matches("sun_shadow.depth_sign").count() >= 2,
                    "{filter} {bias}: compare and clamp"
                );
            }
        }
    }
}

#[test]
fn tiles_of_one_facet_are_not_cut() {
    for body in ["", "technique: standard, shadow_distance: 1 km", "casters: alpha_tested"] {
        let rectangles = declared(body);
        for shader in rectangles.table.shaders.iter() {
            assert!(!shader.wgsl.contains("clips") && !shader.wgsl.contains("enable"), "{body}");
        }
        assert!(!rectangles.json.contains("\"name\": \"clips\""), "{body}");
    }
}

#[test]
fn without_a_shear_the_axes_change_comments_alone() {
    let of = |axes: &str| declared(&format!("technique: standard, shadow_distance: 1 km, axes: {axes}"));
    let (camera, world) = (of("camera"), of("world"));
    let said = "// Positions and normals are relative to the eye, in world axes.\n";
    for shader in camera.table.shaders.iter() {
        let other = world.table.shader(shader.kind).unwrap();
        assert!(shader.spirv == other.spirv, "{}", shader.kind.name());
        let resolves = matches!(shader.kind, ShaderKind::Mask | ShaderKind::Function);
        assert_eq!(other.wgsl.contains(said), resolves, "{}", shader.kind.name());
        assert!(!shader.wgsl.contains("world axes"), "{}", shader.kind.name());
    }
}

#[test]
fn only_camera_axes_that_texels_follow_are_sheared() {
    let sheared = |body: &str| {
        let generated = declared(body);
        let shaders = generated.table.shaders.iter().any(|shader| shader.wgsl.contains("shadow.shear"));
        assert_eq!(shaders, generated.json.contains("\"name\": \"shear\""), "{body}");
        shaders
    };
    assert!(sheared("") && sheared("configurations: [four_plane]"));
    assert!(!sheared("axes: world") && !sheared("technique: standard, shadow_distance: 1 km"));
}
