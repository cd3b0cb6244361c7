//! Capture shaders around an engine's own functions: what is composed, as text to read, and what is refused, as the
//! report that a person sees.

use std::process::Command;

use cssm_codegen::{CasterEntry, CasterError, dsl};
use cssm_core::LightCase;
use cssm_core::table::{CasterSpace, CasterTable, ShaderKind};

/// An engine's skinning: four joints to a vertex, palettes in one storage buffer.
const SKINNED: &str = "// The engine's skinning. This comment belongs to the file.

struct Vertex {
    @location(0) position: vec3<f32>,
    @location(1) normal: vec3<f32>,
    @location(2) joints: vec4<u32>,
    @location(3) weights: vec4<f32>,
}

/// Joint matrices of all skeletons.
@group(1) @binding(0) var<storage, read> palette: array<mat4x4<f32>>;
@group(1) @binding(1) var<uniform> camera: mat4x4<f32>;

const JOINTS: u32 = 64u;

/// Blends four joints of a skeleton.
fn skin(vertex: Vertex, skeleton: u32) -> mat4x4<f32> {
    var matrix = mat4x4<f32>();
    for (var slot = 0u; slot < 4u; slot += 1u) {
        matrix += palette[skeleton * JOINTS + vertex.joints[slot]] * vertex.weights[slot];
    }
    return matrix;
}

/// Where a vertex of a skinned caster lies, in object space.
fn skinned_position(vertex: Vertex, @builtin(instance_index) instance: u32) -> vec3<f32> {
    return (skin(vertex, instance) * vec4<f32>(vertex.position, 1.0)).xyz;
}

/// Not part of any capture.
@vertex
fn engine_vertex(vertex: Vertex) -> @builtin(position) vec4<f32> {
    return camera * vec4<f32>(skinned_position(vertex, 0u), 1.0);
}
";

/// An engine's foliage: displaced by wind, cut out by a texture.
const LEAVES: &str = "struct Leaf {
    position: vec3<f32>,
    uv: vec2<f32>,
}
@group(1) @binding(2) var<uniform> wind: vec4<f32>;
@group(1) @binding(3) var leaves: texture_2d<f32>;
@group(1) @binding(4) var leaves_sampler: sampler;

fn leaf(
    @location(0) position: vec3<f32>, // in the crown
    @location(1) uv: vec2<f32>,
    @location(5) layer: u32,
) -> Leaf {
    let sway = wind.xyz * sin(wind.w + position.y);
    return Leaf(position + sway, uv * vec2<f32>(0.25, 1.0));
}

fn leaf_alpha(uv: vec2<f32>, layer: u32) -> f32 {
    return textureSample(leaves, leaves_sampler, uv + vec2<f32>(0.25 * f32(layer), 0.0)).a;
}
";

fn case(body: &str) -> LightCase {
    let text = format!("pub case Sun {{ {body} }}");
    dsl::parse_file("case", &text).unwrap_or_else(|report| panic!("{report}")).remove(0)
}

fn skinned() -> CasterEntry {
    CasterEntry::new("skinned", "skinned_position").source("skinned.wgsl", SKINNED)
}

fn leaves() -> CasterEntry {
    CasterEntry::new("leaves", "leaf").alpha("leaf_alpha", 0.5).source("leaves.wgsl", LEAVES)
}

fn composed(entry: &CasterEntry, case: &LightCase) -> CasterTable {
    entry.compose(case).unwrap_or_else(|error| panic!("{error}"))
}

/// The report of an entry that does not compose.
fn report(entry: &CasterEntry) -> String {
    match entry.compose(&case("")) {
        Err(CasterError::Source(report)) => {
            // Every fault says what to do, and where, in a file that it names.
            for finding in report.findings() {
                assert!(!finding.remedy.is_empty() && !finding.message.ends_with('.'), "{finding:?}");
                for (place, _) in &finding.places {
                    let (_, text) = report.file(place).unwrap();
                    assert!(text.get(place.bytes.clone()).is_some(), "{finding:?}");
                }
            }
            report.render()
        }
        Err(error) => panic!("{error}"),
        Ok(_) => panic!("it composes"),
    }
}

/// The report of one source under the names that the tests give their functions.
fn fault(source: &str) -> String {
    report(&CasterEntry::new("bad", "caster_position").source("bad.wgsl", source))
}

#[test]
fn a_skinned_caster_in_object_space() {
    let table = composed(&skinned(), &case(""));
    assert_eq!(table.space, CasterSpace::Object { first_location: 4 });
    assert_eq!(table.bindings.len(), 1, "the camera is not reached: {:?}", table.bindings);
    let locations: Vec<_> = table.attributes.iter().map(|attribute| attribute.location).collect();
    assert_eq!(locations, [0, 1, 2, 3]);
    insta::assert_snapshot!("skinned.capture.wgsl", table.shader(ShaderKind::Capture).unwrap().wgsl);
    insta::assert_snapshot!(
        "skinned.capture_clamped.wgsl",
        table.shader(ShaderKind::CaptureClamped).unwrap().wgsl
    );
}

#[test]
fn leaves_with_holes_in_facets_that_share_tiles() {
    let case = case("configurations: [four_plane]");
    let table = composed(&leaves().world(1, 0), &case);
    assert_eq!(table.space, CasterSpace::World { group: 1, binding: 0 });
    for shader in table.shaders.iter() {
        insta::assert_snapshot!(format!("leaves.{}.wgsl", shader.kind.name()), shader.wgsl);
        assert!(shader.fragment.is_some() && !shader.spirv.is_empty());
    }
}

#[test]
fn every_case_and_every_space_composes() {
    let cases = [
        "",
        "configurations: [four_plane]",
        "light: omni",
        "light: spot, configurations: [light_projection]",
        "casters: alpha_tested, prefix: low_sun",
        "configurations: [one_plane], distribution: perspective, stretch: vertex",
        "configurations: [one_plane], distribution: logarithmic, stretch: vertex",
        "technique: standard, shadow_distance: 100 m",
    ];
    for case in cases.map(case) {
        for entry in [skinned(), leaves()] {
            for entry in
                [entry.clone(), entry.clone().rows_at(9), entry.clone().world(2, 7), entry.capture_axes()]
            {
                let table = composed(&entry, &case);
                assert_eq!(table, composed(&entry, &case), "same bytes on every run");
                assert_eq!(table.shaders.len(), 2);
                for shader in table.shaders.iter() {
                    // Prefixes apart, lines are as long as the library's.
                    let prefix = format!("{}_", case.prefix);
                    let long = shader.wgsl.lines().find(|line| line.replace(&prefix, "").len() > 120);
                    assert_eq!(long, None);
                    assert!(shader.wgsl.contains(&*shader.vertex));
                    assert!(!shader.wgsl.contains("engine_vertex") && !shader.wgsl.contains("cssm_engine"));
                    assert_eq!(shader.spirv[..4], 0x0723_0203_u32.to_le_bytes());
                }
            }
        }
    }
}

#[test]
fn spirv_val_accepts_every_variant() {
    if Command::new("spirv-val").arg("--version").output().is_err() {
        eprintln!("SKIPPED: spirv-val is not installed; install Debian's spirv-tools");
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    for case in ["", "configurations: [four_plane]"].map(case) {
        for table in [composed(&skinned(), &case), composed(&leaves().world(1, 0), &case)] {
            for shader in table.shaders.iter() {
                let path = folder.path().join("module.spv");
                std::fs::write(&path, &shader.spirv).unwrap();
                let output =
                    Command::new("spirv-val").args(["--target-env", "vulkan1.1"]).arg(&path).output();
                let output = output.unwrap();
                let complaint = String::from_utf8_lossy(&output.stderr);
                assert!(output.status.success(), "{}: {complaint}", shader.kind.name());
            }
        }
    }
}

#[test]
fn names_of_the_library_are_free_for_the_engine() {
    // Unprefixed, they are the engine's: as functions, as members, as locals.
    let source = "struct CasterVertex { @location(0) capture: vec3<f32>, @location(1) tile: vec2<f32>,
            @location(2) w: f32, @location(3) placed: f32 }
        fn tile_position(vertex: CasterVertex) -> vec3<f32> { return vertex.capture; }
        fn is_hole(tile: vec2<f32>, w: f32, placed: f32) -> bool { return tile.x * w > placed; }
        fn vertex() -> f32 { return 1.0; }";
    for body in ["", "configurations: [four_plane]"] {
        let entry = CasterEntry::new("odd", "tile_position").hole("is_hole").source("odd.wgsl", source);
        composed(&entry, &case(body));
    }
    let source = "fn vertex(vertex: vec3<f32>) -> vec3<f32> { return vertex; }
        fn position(@location(0) position: vec3<f32>) -> vec3<f32> { return vertex(position); }";
    composed(&CasterEntry::new("odd", "position").source("odd.wgsl", source), &case(""));
}

#[test]
fn files_are_one_module() {
    let (types, functions) = SKINNED.split_at(SKINNED.find("const JOINTS").unwrap());
    let entry = CasterEntry::new("skinned", "skinned_position")
        .source("functions.wgsl", functions)
        .source("types.wgsl", types);
    let table = composed(&entry, &case(""));
    assert!(table.shaders[0].wgsl.contains("functions.wgsl, types.wgsl"));
}

#[test]
fn names_equal_to_the_generated_ones() {
    insta::assert_snapshot!(fault(
        "struct SunCapture { a: f32 }

fn sun_tile_position(position: vec3<f32>) -> SunCapture {
    return SunCapture(position.x);
}
fn caster_position(@location(0) position: vec3<f32>) -> vec3<f32> {
    return position * sun_tile_position(position).a;
}
"
    ));
}

#[test]
fn names_of_the_language_declared_anew() {
    insta::assert_snapshot!(fault(
        "fn dot(a: vec3<f32>, b: vec3<f32>) -> f32 { return a.x * b.x; }
fn caster_position(@location(0) position: vec3<f32>) -> vec3<f32> { return position * dot(position, position); }
"
    ));
}

#[test]
fn recursion_and_includes() {
    insta::assert_snapshot!(
        "recursion",
        fault(
            "fn once(a: f32) -> f32 { return twice(a); }
fn twice(a: f32) -> f32 { return once(a) + once(a); }
fn caster_position(@location(0) position: vec3<f32>) -> vec3<f32> { return position * once(1.0); }
"
        )
    );
    insta::assert_snapshot!(
        "includes",
        fault(
            "#include \"bad.wgsl\"
  #import engine::skinning
fn caster_position(@location(0) position: vec3<f32>) -> vec3<f32> { return position; } // # of no matter
"
        )
    );
    let twice = skinned().source("again.wgsl", SKINNED);
    insta::assert_snapshot!("a_file_twice", report(&twice).lines().take(12).collect::<Vec<_>>().join("\n"));
}

#[test]
fn missing_functions() {
    let wrong = CasterEntry::new("bad", "skined_position").hole("is_hole").source("skinned.wgsl", SKINNED);
    insta::assert_snapshot!(report(&wrong));
}

#[test]
fn wrong_results() {
    for (name, result, value) in [
        ("four", "vec4<f32>", "vec4<f32>(position, 1.0)"),
        ("number", "f32", "position.x"),
        ("structure", "Caster", "Caster(position)"),
    ] {
        insta::assert_snapshot!(
            format!("wrong_result_{name}"),
            fault(&format!(
                "struct Caster {{ place: vec3<f32> }}
fn caster_position(@location(0) position: vec3<f32>) -> {result} {{
    return {value};
}}
"
            ))
        );
    }
    insta::assert_snapshot!("no_result", fault("fn caster_position(@location(0) position: vec3<f32>) {}\n"));
}

#[test]
fn wrong_parameters() {
    insta::assert_snapshot!(fault(
        "struct Vertex {
    @location(0) position: vec3<f32>,
    @location(1) @interpolate(flat) index: u32,
    @location(1) weight: f32,
    @builtin(front_facing) front: bool,
    scale: f32,
}
fn caster_position(vertex: Vertex, @location(4) matrix: mat3x3<f32>, time: f32) -> vec3<f32> {
    return vertex.position * vertex.scale * time;
}
"
    ));
    insta::assert_snapshot!(
        "no_parameters",
        fault("fn caster_position() -> vec3<f32> { return vec3<f32>(); }\n")
    );
}

#[test]
fn bindings_in_the_facet_group_and_overrides() {
    insta::assert_snapshot!(fault(
        "@group(0) @binding(3) var<uniform> bones: array<mat4x4<f32>, 64>;
@group(2) @binding(1) var<uniform> wind: vec4<f32>;
@group(2) @binding(1) var<uniform> gust: vec4<f32>;
override scale: f32 = 1.0;
fn caster_position(@location(0) position: vec3<f32>) -> vec3<f32> {
    return (bones[0] * vec4<f32>(position * scale, 1.0)).xyz + wind.xyz + gust.xyz;
}
"
    ));
}

#[test]
fn rows_that_meet_the_engine() {
    insta::assert_snapshot!("rows_at_taken_locations", report(&skinned().rows_at(2)));
    let bound = leaves().world(1, 2);
    insta::assert_snapshot!("rows_at_a_taken_binding", report(&bound));
    let error = skinned().world(0, 1).compose(&case("")).unwrap_err();
    assert!(matches!(error, CasterError::RowsInFacetGroup { group: 0, .. }), "{error}");
}

#[test]
fn an_alpha_function_without_its_coordinates() {
    let source =
        "fn caster_position(@location(0) position: vec3<f32>, @location(1) layer: u32) -> vec3<f32> {
    return position;
}
fn alpha(uv: vec2<f32>, layer: f32) -> f32 {
    return uv.x * layer;
}
fn hole(position: vec3<f32>) -> f32 {
    return position.x;
}
";
    let entry = CasterEntry::new("bad", "caster_position").source("bad.wgsl", source);
    insta::assert_snapshot!("alpha_without_uv", report(&entry.clone().alpha("alpha", 0.5)));
    insta::assert_snapshot!("hole_that_is_alpha", report(&entry.hole("hole")));
}

#[test]
fn two_files_with_one_fault_each() {
    let one = "fn swayed(position: vec3<f32>) -> vec3<f32> {
    return position + wnd.xyz;
}
";
    let two = "fn caster_position(@location(0) position: vec3<f32>) -> vec3<f32> {
    return swayed(position) * turned(position);
}
fn turned(position: vec3<f32>) -> f32 {
    let turn: vec3<f32> = position.xy;
    return turn.x;
}
";
    let entry = CasterEntry::new("bad", "caster_position").source("one.wgsl", one).source("two.wgsl", two);
    insta::assert_snapshot!(report(&entry));
}

#[test]
fn faults_that_only_the_stage_shows() {
    // Derivatives do not exist where vertices are placed.
    insta::assert_snapshot!(
        "derivative_in_the_vertex_stage",
        fault(
            "fn caster_position(@location(0) position: vec3<f32>) -> vec3<f32> {
    return position + dpdx(position);
}
"
        )
    );
    insta::assert_snapshot!(
        "implicit_levels_and_discards",
        report(&CasterEntry::new("bad", "caster_position").hole("hole").source(
            "bad.wgsl",
            "@group(1) @binding(0) var heights: texture_2d<f32>;
@group(1) @binding(1) var heights_sampler: sampler;
fn height(at: vec2<f32>) -> f32 {
    return textureSample(heights, heights_sampler, at).x;
}
fn near() {
    discard;
}
fn caster_position(@location(0) position: vec3<f32>) -> vec3<f32> {
    near();
    return position * height(position.xz);
}
fn hole(position: vec3<f32>) -> bool {
    return height(position.xz) > 0.5;
}
"
        ))
    );
    insta::assert_snapshot!(
        "unfinished",
        fault("fn caster_position(@location(0) position: vec3<f32>) -> vec3<f32> { return")
    );
    insta::assert_snapshot!(
        "directive",
        fault(
            "enable f16;\nfn caster_position(@location(0) position: vec3<f32>) -> vec3<f32> { return position; }\n"
        )
    );
}

#[test]
fn entries_that_need_no_source_to_be_refused() {
    let sun = case("");
    let refused = |entry: CasterEntry, case: &LightCase| entry.compose(case).unwrap_err().to_string();
    let exact = case("configurations: [one_plane], distribution: two_segment");
    let error = skinned().compose(&exact).map(|table| table.name).unwrap_err();
    assert!(matches!(error, CasterError::Exact { .. }));
    insta::assert_snapshot!(
        [
            error.to_string(),
            refused(CasterEntry::new("Skinned", "position").source("a.wgsl", ""), &sun),
            refused(CasterEntry::new("skinned", "position"), &sun),
            refused(leaves().alpha("leaf_alpha", f32::NAN), &sun),
        ]
        .join("\n")
    );
}

#[test]
fn no_text_panics() {
    // Cut a valid source anywhere, and take any letter out of it.
    let case = case("");
    let finished = SKINNED.find("/// Not part").unwrap();
    for (at, _) in SKINNED.char_indices().step_by(7) {
        let cut = CasterEntry::new("cut", "skinned_position").source("cut.wgsl", &SKINNED[..at]);
        assert!(cut.compose(&case).is_err() || at + 2 >= finished, "{at}");
        let mut less = SKINNED.to_owned();
        less.remove(at);
        let _ = CasterEntry::new("less", "skinned_position").source("less.wgsl", &less).compose(&case);
    }
}
