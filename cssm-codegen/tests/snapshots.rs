//! What is generated, as text to read: the cases that ship, and one variant for each alternative of a slot.
//!
//! The variants lock only the modules in which they differ.

use cssm_codegen::{Generated, dsl, generate};
use cssm_core::LightCase;
use cssm_core::table::{GroupContent, ShaderKind};

fn shipped(file: &str) -> Generated {
    let path = format!("{}/../shaders-gen/cases/{file}.cssm", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(&path).unwrap();
    let cases = dsl::parse_file(file, &text).unwrap();
    generate(&cases[0]).unwrap()
}

fn declared(body: &str) -> Generated {
    let text = format!("pub case Sun {{ {body} }}");
    let cases: Vec<LightCase> = dsl::parse_file("variant", &text).unwrap_or_else(|report| panic!("{report}"));
    generate(&cases[0]).unwrap()
}

fn wgsl(generated: &Generated, kind: ShaderKind) -> &str {
    generated.table.shader(kind).map_or("", |shader| &shader.wgsl)
}

#[test]
fn sun() {
    let sun = shipped("sun");
    insta::assert_snapshot!("sun.capture.wgsl", wgsl(&sun, ShaderKind::Capture));
    insta::assert_snapshot!("sun.capture_clamped.wgsl", wgsl(&sun, ShaderKind::CaptureClamped));
    insta::assert_snapshot!("sun.mask.wgsl", wgsl(&sun, ShaderKind::Mask));
    insta::assert_snapshot!("sun.function.wgsl", wgsl(&sun, ShaderKind::Function));
    insta::assert_snapshot!("sun.json", sun.json);
    insta::assert_snapshot!("sun.explain", sun.explain);
}

#[test]
fn four_planes_and_alpha_masks() {
    let variant = declared(
        "technique: camera_space, configurations: [one_plane, four_plane], casters: alpha_tested, axes: world, \
         filter: hardware_2x2, bias: constant(5 cm)",
    );
    for shader in variant.table.shaders.iter() {
        insta::assert_snapshot!(format!("four_plane.{}.wgsl", shader.kind.name()), shader.wgsl);
    }
    insta::assert_snapshot!("four_plane.json", variant.json);
    insta::assert_snapshot!("four_plane.explain", variant.explain);
}

#[test]
fn alpha_masks_in_tiles_of_their_own() {
    let variant = declared("casters: alpha_tested");
    for shader in [ShaderKind::CaptureTested, ShaderKind::CaptureTestedClamped] {
        insta::assert_snapshot!(format!("tested.{}.wgsl", shader.name()), wgsl(&variant, shader));
    }
}

#[test]
fn parallel_split() {
    let pssm = shipped("pssm4_log");
    insta::assert_snapshot!("pssm4_log.function.wgsl", wgsl(&pssm, ShaderKind::Function));
    insta::assert_snapshot!("pssm4_log.json", pssm.json);
    insta::assert_snapshot!("pssm4_log.explain", pssm.explain);
    insta::assert_snapshot!("pssm4_practical.explain", shipped("pssm4_practical").explain);
}

#[test]
fn standard() {
    let standard = shipped("standard");
    insta::assert_snapshot!("standard.function.wgsl", wgsl(&standard, ShaderKind::Function));
    insta::assert_snapshot!("standard.explain", standard.explain);
}

#[test]
fn least() {
    let least = declared(
        "technique: standard, shadow_distance: 100 m, filter: none, bias: none, resolve: [function { group: 0 }]",
    );
    insta::assert_snapshot!("least.function.wgsl", wgsl(&least, ShaderKind::Function));
    insta::assert_snapshot!("least.json", least.json);
    insta::assert_snapshot!("least.explain", least.explain);
}

#[test]
fn linear_depth_and_normals_from_the_engine() {
    let variant = declared("resolve: [mask { depth: linear, normal: texture }], filter: hardware_2x2");
    insta::assert_snapshot!("linear_texture_hardware_plane.mask.wgsl", wgsl(&variant, ShaderKind::Mask));
    insta::assert_snapshot!("linear_texture_hardware_plane.explain", variant.explain);
}

#[test]
fn sectors_without_bands_and_world_texel_bias() {
    let variant = declared(
        "distribution: bands(1), bias: world_texel { a: 1 cm, b: 1.5 texels }, filter: hardware_2x2, \
         resolve: [mask { depth: linear }]",
    );
    insta::assert_snapshot!("sectors_world_texel_hardware.mask.wgsl", wgsl(&variant, ShaderKind::Mask));
}

#[test]
fn slope_bias_and_no_filter() {
    let variant =
        declared("bias: slope(2 texels), filter: none, resolve: [function], distribution: bands(5)");
    insta::assert_snapshot!("slope_none.function.wgsl", wgsl(&variant, ShaderKind::Function));
    insta::assert_snapshot!("slope_none.json", variant.json);
}

#[test]
fn constant_bias_and_gather() {
    let variant = declared("bias: constant(5 cm), filter: gather_2x2, resolve: [function]");
    insta::assert_snapshot!("constant_gather.function.wgsl", wgsl(&variant, ShaderKind::Function));
}

#[test]
fn boxes_of_a_fixed_width() {
    let variant = declared("filter: pcf_3x3, resolve: [function]");
    insta::assert_snapshot!("pcf_texels.function.wgsl", wgsl(&variant, ShaderKind::Function));
    insta::assert_snapshot!("pcf_texels.explain", variant.explain);
}

#[test]
fn boxes_of_a_width_in_metres_under_a_flat_bias() {
    let variant = declared(
        "filter: pcf_5x5 { kernel: metres(5 cm) }, bias: constant, resolve: [function], axes: world",
    );
    insta::assert_snapshot!("pcf_metres.function.wgsl", wgsl(&variant, ShaderKind::Function));
}

#[test]
fn boxes_of_a_width_in_pixels() {
    let variant = declared("filter: pcf_7x7 { kernel: pixels(3 px) }, resolve: [function]");
    insta::assert_snapshot!("pcf_pixels.function.wgsl", wgsl(&variant, ShaderKind::Function));
    insta::assert_snapshot!("pcf_pixels.json", variant.json);
}

#[test]
fn soft_edges() {
    let variant = declared("filter: pcss, resolve: [function]");
    insta::assert_snapshot!("pcss.function.wgsl", wgsl(&variant, ShaderKind::Function));
    insta::assert_snapshot!("pcss.explain", variant.explain);
}

#[test]
fn soft_edges_of_a_light_that_stands_near() {
    let variant = declared("light: spot, filter: pcss { radius: 2 cm }, bias: none, resolve: [function]");
    insta::assert_snapshot!("pcss_spot.function.wgsl", wgsl(&variant, ShaderKind::Function));
}

#[test]
fn moments() {
    let variant = declared("filter: evsm_2, resolve: [function]");
    for shader in [ShaderKind::PrefilterRows, ShaderKind::PrefilterColumns, ShaderKind::Function] {
        insta::assert_snapshot!(format!("evsm.{}.wgsl", shader.name()), wgsl(&variant, shader));
    }
    insta::assert_snapshot!("evsm.json", variant.json);
    insta::assert_snapshot!("evsm.explain", variant.explain);
}

#[test]
fn masks_of_planes() {
    let variant = declared("filter: ground_masks { planes: 2, blur: 20 cm }, resolve: [function]");
    for shader in [ShaderKind::PrefilterRows, ShaderKind::PrefilterColumns, ShaderKind::Function] {
        insta::assert_snapshot!(format!("ground_masks.{}.wgsl", shader.name()), wgsl(&variant, shader));
    }
    insta::assert_snapshot!("ground_masks.json", variant.json);
    insta::assert_snapshot!("ground_masks.explain", variant.explain);

    // Triangles that share a tile are told apart.
    let shared = declared(
        "filter: ground_masks, resolve: [function], technique: camera_space, \
         configurations: [four_plane]",
    );
    insta::assert_snapshot!(
        "ground_masks_shared.prefilter_rows.wgsl",
        wgsl(&shared, ShaderKind::PrefilterRows)
    );
}

#[test]
fn receiver_plane_and_no_filter() {
    let variant = declared("bias: receiver_plane, filter: none, resolve: [function]");
    insta::assert_snapshot!("plane_none.function.wgsl", wgsl(&variant, ShaderKind::Function));
}

#[test]
fn shadow_bindings_in_a_group_of_the_engine() {
    let variant = declared(
        "resolve: [mask, function { group: 0, first_binding: 7 }], filter: hardware_2x2, prefix: low_sun",
    );
    let bindings = |kind: ShaderKind| {
        let groups = variant.table.groups.iter().filter(|group| group.shader == kind);
        let shadow = groups.filter(|group| group.content == GroupContent::Shadow);
        shadow.flat_map(|group| group.bindings.iter().map(|binding| (group.group, binding.binding))).collect()
    };
    // The mask's group is its own, but shares its layout.
    let (function, mask): (Vec<_>, Vec<_>) = (bindings(ShaderKind::Function), bindings(ShaderKind::Mask));
    assert_eq!(function, [(0, 7), (0, 8), (0, 9)]);
    assert_eq!(mask, [(1, 7), (1, 8), (1, 9)]);
    let text = wgsl(&variant, ShaderKind::Function);
    assert!(text.contains("@group(0) @binding(7)\nvar<uniform> low_sun_shadow"), "{text}");
    assert!(wgsl(&variant, ShaderKind::Mask).contains("@group(1) @binding(9)\nvar low_sun_map_sampler"));
    let rust: String = variant.rust.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(rust.contains("Resolve::Function { group: 0, first_binding: 7"), "the door's case is the same");
    assert!(variant.json.contains("\"binding\": 9"));

    // Without a choice they begin at 0.
    let plain = declared("resolve: [function { group: 3 }]");
    assert!(wgsl(&plain, ShaderKind::Function).contains("@group(3) @binding(0)"));
    let refused = dsl::parse_file("case", "case Sun { resolve: [function { first_binding: 1000 }] }");
    assert!(refused.unwrap_err().to_string().contains("990"));
}

#[test]
fn measured_depth() {
    let variant = declared("fit: histogram, resolve: [mask]");
    insta::assert_snapshot!("measured.fit.wgsl", wgsl(&variant, ShaderKind::Fit));
    insta::assert_snapshot!("measured.json", variant.json);
    insta::assert_snapshot!("measured.explain", variant.explain);
    let linear = declared("fit: depth_min_max, resolve: [mask { depth: linear }]");
    insta::assert_snapshot!("measured_linear.fit.wgsl", wgsl(&linear, ShaderKind::Fit));
}
