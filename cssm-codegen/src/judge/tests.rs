//! Negative controls: the judge catches every kind of wrong module.

use cssm_core::LightCase;
use cssm_core::table::{CaseTable, ShaderKind};

use super::{JudgeError, judge};

fn mask() -> (CaseTable, String) {
    let case = LightCase::builder("Sun").build().unwrap();
    let table = crate::generate(&case).unwrap().table;
    let text = table.shader(ShaderKind::Mask).unwrap().wgsl.to_string();
    (table, text)
}

/// What the judge says about the mask module after one change.
fn verdict(from: &str, to: &str) -> Result<(), JudgeError> {
    let (table, text) = mask();
    assert!(text.contains(from), "`{from}` is not in the module");
    judge(&text.replacen(from, to, 1), &table, ShaderKind::Mask).map(|_| ())
}

#[test]
fn the_module_itself_passes() {
    assert_eq!(verdict("sun_visibility", "sun_visibility"), Ok(()));
}

#[test]
fn a_syntax_error_is_caught() {
    assert!(matches!(verdict("let facet =", "let facet"), Err(JudgeError::Parse(_))));
}

#[test]
fn a_capability_beyond_the_core_is_caught() {
    let wrong = verdict("@builtin(vertex_index) corner: u32", "@builtin(view_index) corner: u32");
    assert!(matches!(wrong, Err(JudgeError::Parse(_) | JudgeError::Validate(_))), "{wrong:?}");
}

#[test]
fn something_unused_is_caught() {
    for unused in [
        "fn unused() -> f32 { return 1.0; }",
        "struct Unused { a: f32 }",
        "@group(3) @binding(0) var unused: sampler;",
    ] {
        let wrong = verdict("/// The view.\n@group", &format!("{unused}\n/// The view.\n@group"));
        assert!(matches!(wrong, Err(JudgeError::Unused(_))), "{unused}: {wrong:?}");
    }
}

#[test]
fn a_moved_binding_is_caught() {
    let wrong = verdict("@group(1) @binding(1)", "@group(1) @binding(5)");
    assert!(matches!(wrong, Err(JudgeError::Table(_))), "{wrong:?}");
}

#[test]
fn a_renamed_entry_point_is_caught() {
    let wrong = verdict("fn sun_mask_vertex", "fn sun_mask_corner");
    assert!(matches!(wrong, Err(JudgeError::Table(_))), "{wrong:?}");
}

#[test]
fn a_changed_record_is_caught() {
    let swapped = verdict(
        "row_x: vec4<f32>,\n    /// Clip y of the tile, upwards.\n    row_y",
        "row_y: vec4<f32>,\n    /// Clip y of the tile, upwards.\n    row_x",
    );
    assert!(matches!(swapped, Err(JudgeError::Table(_))), "{swapped:?}");
    let grown = verdict("facets: array<SunFacet, 32>", "facets: array<SunFacet, 33>");
    assert!(matches!(grown, Err(JudgeError::Table(_))), "{grown:?}");
}

#[test]
fn clip_distances_are_refused_where_the_table_has_no_clips() {
    let case = LightCase::builder("Sun").build().unwrap();
    let table = crate::generate(&case).unwrap().table;
    let text = table.shader(ShaderKind::Capture).unwrap().wgsl.to_string();
    assert!(judge(&text, &table, ShaderKind::Capture).is_ok());
    let head = "fn sun_capture_vertex(vertex: SunCasterVertex) -> @builtin(position) vec4<f32> {";
    assert!(text.contains(head));
    let cut = "struct Cut { @builtin(position) p: vec4<f32>, @builtin(clip_distances) c: array<f32, 2> }\n";
    let wrong = format!(
        "enable clip_distances;\n{}{cut}",
        text.replace(head, &head.replace("@builtin(position) vec4<f32>", "Cut")).replace(
            "return sun_tile_position(sun_capture_position(vertex));",
            "return Cut(sun_tile_position(sun_capture_position(vertex)), array<f32, 2>(1.0, 1.0));"
        )
    );
    let refused = judge(&wrong, &table, ShaderKind::Capture);
    assert!(matches!(refused, Err(JudgeError::Parse(_) | JudgeError::Validate(_))), "{refused:?}");

    // Where the table has clips, the same text passes.
    let clipped = CaseTable { clips: 2, ..table };
    assert!(judge(&wrong, &clipped, ShaderKind::Capture).is_ok());
}
