//! Code generation as users meet it: every door gives the same bytes, every declaration gives valid shaders, the
//! committed tables are current and compile.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use cssm::LightCase;
use cssm::core::schema::Word;
use cssm::core::table::{CaseTable, ShaderKind};
use cssm_codegen::{Build, Generated, Target, dsl, generate, macro_expand};
use cssm_tests::{generated, random};
use naga::valid::Capabilities;

#[path = "support/judge.rs"]
mod judge;

use judge::{
    capabilities, judge, passes_spirv_val, passes_tint, spirv_val, spirv_val_is_there, tint, tint_is_there,
    with_stage,
};

/// Shipped declaration files, and what the tests crate has compiled from each.
fn shipped() -> [(&'static str, &'static CaseTable, LightCase); 11] {
    [
        ("sun", &generated::sun::TABLE, generated::sun::case()),
        ("sun_log", &generated::sun_log::TABLE, generated::sun_log::case()),
        ("sun_stretched", &generated::sun_stretched::TABLE, generated::sun_stretched::case()),
        ("lamp", &generated::lamp::TABLE, generated::lamp::case()),
        ("spot", &generated::spot::TABLE, generated::spot::case()),
        ("one_plane", &generated::one_plane::TABLE, generated::one_plane::case()),
        ("four_plane", &generated::four_plane::TABLE, generated::four_plane::case()),
        ("planes", &generated::planes::TABLE, generated::planes::case()),
        ("standard", &generated::standard::TABLE, generated::standard::case()),
        ("pssm4_log", &generated::pssm_log::TABLE, generated::pssm_log::case()),
        ("pssm4_practical", &generated::pssm_practical::TABLE, generated::pssm_practical::case()),
    ]
}

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

fn case_file(stem: &str) -> PathBuf {
    root().join(format!("shaders-gen/cases/{stem}.cssm"))
}

fn parse(path: &Path) -> Vec<LightCase> {
    let text = std::fs::read_to_string(path).unwrap();
    dsl::parse_file(&path.display().to_string(), &text).unwrap_or_else(|report| panic!("{report}"))
}

fn generate_file(stem: &str) -> Generated {
    generate(&parse(&case_file(stem))[0]).unwrap()
}

#[test]
fn committed_tables_are_current() {
    for (stem, _, _) in shipped() {
        let generated = generate_file(stem);
        let path = root().join(format!("tests/src/generated/{}.rs", generated.table.prefix));
        let committed = std::fs::read_to_string(&path).unwrap_or_default();
        assert!(committed == generated.rust, "{} is not current; run `cargo xtask gen`", path.display());
    }
}

#[test]
fn every_shipped_case_is_compiled_here() {
    let folder = std::fs::read_dir(root().join("shaders-gen/cases")).unwrap();
    let stems = folder.map(|entry| entry.unwrap().path().file_stem().unwrap().to_string_lossy().into_owned());
    let compiled: BTreeSet<_> = shipped().into_iter().map(|(stem, _, _)| stem.to_owned()).collect();
    assert_eq!(stems.collect::<BTreeSet<_>>(), compiled);
}

#[test]
fn compiled_tables_are_the_generated_ones() {
    for (stem, table, case) in shipped() {
        assert!(*table == generate_file(stem).table, "{stem}");
        assert!(case == parse(&case_file(stem))[0], "{stem}");
    }
}

mod by_macro {
    cssm::light_case! {
        /// Sun over an open world: face columns of eight bands follow the viewing camera to infinity, so shadows need no
        /// shadow distance and texels stay the same size on the screen, near and far.
        pub case Sun {
            light: directional,
            view: perspective { far: infinite },
            technique: camera_space,
            configurations: [face_columns],
            distribution: bands(8),
            map: { size: 2048 x 2048, columns: auto, format: depth32float, gutter: auto },
            filter: gather_2x2,
            bias: receiver_plane,
            resolve: [mask, function { group: 2 }],
            prefix: sun,
        }
    }

    cssm::light_case! {
        #![crate_path(::cssm)]
        case Least {
            technique: standard,
            shadow_distance: 100 m,
            filter: none,
            bias: slope,
            resolve: [function { group: 0 }],
            prefix: match,
        }
    }

    /// The table of the private case, whose prefix is a keyword.
    pub(super) const LEAST: &cssm::core::table::CaseTable = &r#match::TABLE;
}

#[test]
fn the_macro_compiles_to_the_same_module() {
    assert!(by_macro::sun::TABLE == generated::sun::TABLE);
    assert!(by_macro::sun::case() == generated::sun::case());
    assert_eq!(by_macro::sun::SUN_MAP_SIZE, generated::sun::SUN_MAP_SIZE);
    assert!(by_macro::LEAST.shader(ShaderKind::Function).is_some());
    assert_eq!(size_of::<by_macro::sun::SunShadow>(), size_of::<generated::sun::SunShadow>());
}

#[test]
fn macro_tokens_print_as_the_emitted_file() {
    for (stem, _, _) in shipped() {
        let text = std::fs::read_to_string(case_file(stem)).unwrap();
        let tokens = macro_expand(text.parse().unwrap());
        let printed = prettyplease::unparse(&syn::parse2(tokens).unwrap());
        assert!(generate_file(stem).rust.ends_with(&format!("\n\n{printed}")), "{stem}");
    }
}

#[test]
fn the_build_script_door_writes_the_same_file() {
    let folder = tempfile::tempdir().unwrap();
    for (stem, _, _) in shipped() {
        let build = Build::new().file(case_file(stem)).out_dir(folder.path());
        let written = build.compile().unwrap();
        assert_eq!(written, [folder.path().join(format!("{stem}.rs"))]);
        assert!(std::fs::read_to_string(&written[0]).unwrap() == generate_file(stem).rust, "{stem}");
    }
}

#[test]
fn the_command_line_writes_the_same_files() {
    let folder = tempfile::tempdir().unwrap();
    for (stem, _, _) in shipped() {
        let path = case_file(stem).display().to_string();
        let out = folder.path().display().to_string();
        let arguments = ["shaders-gen", "emit", path.as_str(), "--out", out.as_str()];
        let code = shaders_gen::main(arguments, &mut Vec::new(), &mut Vec::new());
        assert_eq!(format!("{code:?}"), format!("{:?}", ExitCode::SUCCESS));
        for file in generate_file(stem).files(&Target::ALL) {
            assert!(std::fs::read(folder.path().join(&file.name)).unwrap() == file.bytes, "{}", file.name);
        }
    }
}

#[test]
fn the_rust_builder_gives_the_same_bytes() {
    let doc = parse(&case_file("sun"))[0].doc.clone();
    let sun = LightCase::builder("Sun").doc(&doc).bands(8, 1e5).map_size_texels(2048, 2048).build().unwrap();
    assert!(generate(&sun).unwrap() == generate_file("sun"));

    let doc = parse(&case_file("standard"))[0].doc.clone();
    let standard = LightCase::builder("Standard").doc(&doc).technique(Word::plain("standard"));
    let standard = standard.shadow_distance_metres(1000.0).build().unwrap();
    assert!(generate(&standard).unwrap() == generate_file("standard"));
}

/// Random declarations, each judged here once more, with options that the generator does not use.
#[test]
fn random_declarations_emit_valid_minimal_modules() {
    const SEED: u64 = 0x5eed;
    const CASES: usize = 500;
    let (mut words, mut texts) = (BTreeSet::new(), BTreeSet::new());
    for case in random::cases(SEED, CASES) {
        let generated = generate(&case).unwrap_or_else(|error| panic!("{error}\n{}", dsl::print(&case)));
        for shader in generated.table.shaders.iter() {
            let text = with_stage(&shader.wgsl, &generated.table, shader.kind);
            match judge(&text, capabilities(&generated.table, shader.kind)) {
                Ok(written) => words.insert(written),
                Err(error) => panic!("{}: {error}\n{}\n{text}", shader.kind.name(), dsl::print(&case)),
            };
            texts.insert(text);
            if !shader.spirv.is_empty() {
                words.insert(shader.spirv.to_vec());
            }
        }
    }
    println!("{CASES} cases, {} different modules", words.len());
    spirv_val(&words.into_iter().collect::<Vec<_>>());
    tint(&texts.into_iter().collect::<Vec<_>>());
}

#[test]
fn the_judges_of_the_random_test_catch_mutants() {
    let sun = generate_file("sun");
    let text = &sun.table.shader(ShaderKind::Mask).unwrap().wgsl;
    let judge = |text: &str| judge(text, Capabilities::empty());
    assert!(judge(text).is_ok());
    let unused = format!("{text}\nfn unused() -> f32 {{ return 1.0; }}");
    assert!(judge(&unused).unwrap_err().contains("compact"));
    assert!(judge(&text.replace("receiver.gradient", "receiver.texels")).is_err());
    assert!(judge(&text.replace("corner == 2u", "corner == 2.0")).is_err());

    if spirv_val_is_there() {
        // A module that claims another result type for its first addition.
        let mut mutant = sun.table.shader(ShaderKind::Mask).unwrap().spirv.to_vec();
        let at = mutant.chunks(4).position(|word| word == [0x81, 0x00, 0x05, 0x00]).unwrap();
        mutant[4 * at + 4] = mutant[4 * at + 4].wrapping_add(1);
        assert!(!passes_spirv_val(&mutant, &tempfile::tempdir().unwrap().path().join("mutant.spv")));
    }
    if tint_is_there() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("mutant.wgsl");
        assert!(passes_tint(text, &path));
        assert!(!passes_tint(&text.replace("receiver.gradient", "receiver.texels"), &path));
    }
}

#[test]
fn random_declarations_survive_their_own_text() {
    for case in random::cases(7, 100) {
        let text = dsl::print(&case);
        let read = dsl::parse_file("printed", &text).unwrap_or_else(|report| panic!("{report}"));
        assert_eq!(read, [case]);
    }
}
