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
