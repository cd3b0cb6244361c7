//! Random declarations, generated: every module passes its judge, and nothing that is not declared leaves a trace.

#[path = "support/random.rs"]
mod random;

use std::collections::BTreeSet;

use cssm_codegen::{Generated, dsl, generate};
use cssm_core::LightCase;
use cssm_core::case::{Axes, Casters};
use cssm_core::table::{BindingKind, ShaderKind};

use random::Random;

/// Cases drawn until `wanted` of them are sound.
fn cases(seed: u64, wanted: usize) -> Vec<LightCase> {
    let mut random = Random(seed);
    let texts = (0..100 * wanted).map(|_| random::declaration(&mut random, "Drawn"));
    let cases: Vec<_> =
        texts.filter_map(|text| dsl::parse_file("drawn", &text).ok()).flatten().take(wanted).collect();
    assert_eq!(cases.len(), wanted, "too few drawn declarations are sound");
    cases
}

#[test]
fn what_is_not_declared_leaves_no_trace() {
    const SEED: u64 = 11;
    const CASES: usize = 400;
    let mut drawn = BTreeSet::new();
    for case in cases(SEED, CASES) {
        let generated = generate(&case).unwrap_or_else(|error| panic!("{error}\n{}", dsl::print(&case)));
        let table = &generated.table;
        let (clipped, tested) = (table.clips > 0, case.casters == Casters::AlphaTested);
        drawn.insert((clipped, tested, table.may_reverse_depth, table.axes == Axes::World));
        for (declared, trace) in
            [(clipped, "clips"), (tested, "alpha_cutoff"), (table.may_reverse_depth, "depth_sign")]
        {
            assert_eq!(
                !modules_with(&generated, trace).is_empty(),
                declared,
                "{trace}\n{}",
                dsl::print(&case)
            );
            let record = generated.json.contains(&format!("\"name\": \"{trace}\""));
            assert_eq!(record, declared, "{trace}\n{}", dsl::print(&case));
        }

        // Clip distances stand where the pipeline cuts, and only there.
        let pipeline = [ShaderKind::Capture, ShaderKind::CaptureTested];
        let cut = modules_with(&generated, "enable clip_distances;");
        let expected = pipeline.into_iter().filter(|shader| clipped && table.pass(*shader).is_some());
        assert_eq!(cut, expected.map(ShaderKind::name).collect::<Vec<_>>(), "{}", dsl::print(&case));
        let has = |shader| table.pass(shader).is_some();
        let exact = has(ShaderKind::CaptureBent);
        assert_eq!(has(ShaderKind::CaptureTested), tested && !exact, "{}", dsl::print(&case));
        assert_eq!(has(ShaderKind::CaptureBentTested), tested && exact, "{}", dsl::print(&case));

        // Resolving needs the sign wherever it compares: in every filter and in every clamp.
        for name in modules_with(&generated, "_held_depth(") {
            let signed = modules_with(&generated, "shadow.depth_sign").contains(&name);
            assert_eq!(signed, table.may_reverse_depth, "{}", dsl::print(&case));
        }
        assert!(has_groups_of_its_passes(&generated), "{}", dsl::print(&case));
    }

    // Draw enough to see every combination that the techniques allow.
    for clipped in [false, true] {
        for tested in [false, true] {
            for world in [false, true] {
                assert!(drawn.contains(&(clipped, tested, true, world)), "{clipped} {tested} {world}");
            }
            assert!(drawn.iter().any(|drawn| drawn.1 == tested && !drawn.2), "a fixed order, {tested}");
        }
    }
}

/// Names of the modules whose text holds a part.
fn modules_with(generated: &Generated, part: &str) -> Vec<&'static str> {
    let shaders = generated.table.shaders.iter().filter(|shader| shader.wgsl.contains(part));
    shaders.map(|shader| shader.kind.name()).collect()
}

/// Whether exactly the tested passes bind a mask.
fn has_groups_of_its_passes(generated: &Generated) -> bool {
    let table = &generated.table;
    table.passes.iter().all(|pass| {
        let groups = table.groups.iter().filter(|group| group.shader == pass.shader);
        let masks = groups.flat_map(|group| group.bindings.iter()).filter(|binding| {
            matches!(binding.kind, BindingKind::CasterMask | BindingKind::CasterMaskSampler)
        });
        let tested = matches!(
            pass.shader,
            ShaderKind::CaptureTested | ShaderKind::CaptureTestedClamped | ShaderKind::CaptureBentTested
        );
        masks.count() == if tested { 2 } else { 0 }
    })
}
