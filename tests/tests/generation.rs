//! Code generation as users meet it: every door gives the same bytes, every declaration gives valid shaders, the
//! committed tables are current and compile.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};

use cssm::LightCase;
use cssm::core::schema::Word;
use cssm::core::table::{CaseTable, ShaderKind};
use cssm_codegen::{Build, Generated, Target, dsl, generate, macro_expand};
use cssm_tests::{generated, random};
use naga::valid::Capabilities;

/// Shipped declaration files, and what the tests crate has compiled from each.
fn shipped() -> [(&'static str, &'static CaseTable, LightCase); 7] {
    [
        ("sun", &generated::sun::TABLE, generated::sun::case()),
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
    let mut words = BTreeSet::new();
    for case in random::cases(SEED, CASES) {
        let generated = generate(&case).unwrap_or_else(|error| panic!("{error}\n{}", dsl::print(&case)));
        for shader in generated.table.shaders.iter() {
            let text = with_stage(&shader.wgsl, &generated.table, shader.kind);
            match judge(&text, capabilities(&generated.table, shader.kind)) {
                Ok(written) => words.insert(written),
                Err(error) => panic!("{}: {error}\n{}\n{text}", shader.kind.name(), dsl::print(&case)),
            };
            if !shader.spirv.is_empty() {
                words.insert(shader.spirv.to_vec());
            }
        }
    }
    println!("{CASES} cases, {} different modules", words.len());
    spirv_val(&words.into_iter().collect::<Vec<_>>());
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
}

#[test]
fn random_declarations_survive_their_own_text() {
    for case in random::cases(7, 100) {
        let text = dsl::print(&case);
        let read = dsl::parse_file("printed", &text).unwrap_or_else(|report| panic!("{report}"));
        assert_eq!(read, [case]);
    }
}

/// A module with an entry point: the function module is called from a fragment stage.
fn with_stage(wgsl: &str, table: &CaseTable, kind: ShaderKind) -> String {
    if kind != ShaderKind::Function {
        return wgsl.to_owned();
    }
    let prefix = &table.prefix;
    let call = if wgsl.contains("normal: vec3<f32>) -> f32") { "(p, n)" } else { "(p)" };
    format!(
        "{wgsl}\n@fragment fn stage(@location(0) p: vec3<f32>, @location(1) n: vec3<f32>) -> @location(0) \
         vec4<f32> {{ return vec4<f32>({prefix}_visibility{call}); }}"
    )
}

/// What a module may need beyond WebGPU's core: clip distances, where facets share tiles and the pipeline cuts.
fn capabilities(table: &CaseTable, kind: ShaderKind) -> Capabilities {
    match kind {
        ShaderKind::Capture | ShaderKind::CaptureTested if table.clips > 0 => Capabilities::CLIP_DISTANCES,
        _ => Capabilities::empty(),
    }
}

/// Validates a module, checks that compaction removes nothing, and returns its words.
fn judge(wgsl: &str, capabilities: Capabilities) -> Result<Vec<u8>, String> {
    use naga::compact::{KeepUnused, compact};
    use naga::front::wgsl::{Frontend, Options};
    use naga::valid::{ValidationFlags, Validator};
    let mut frontend = Frontend::new_with_options(Options { parse_doc_comments: false, capabilities });
    let module = frontend.parse(wgsl).map_err(|error| error.emit_to_string(wgsl))?;
    let mut validator = Validator::new(ValidationFlags::all(), capabilities);
    let info = validator.validate(&module).map_err(|error| error.emit_to_string(wgsl))?;
    let mut kept = module.clone();
    compact(&mut kept, KeepUnused::No);
    let named_types = |module: &naga::Module| module.types.iter().filter(|(_, ty)| ty.name.is_some()).count();
    let counts = |module: &naga::Module| {
        (module.functions.len(), module.global_variables.len(), module.constants.len(), named_types(module))
    };
    if counts(&module) != counts(&kept) {
        return Err(format!("compact leaves {:?} of {:?}", counts(&kept), counts(&module)));
    }
    let options = naga::back::spv::Options { lang_version: (1, 3), ..Default::default() };
    let words =
        naga::back::spv::write_vec(&module, &info, &options, None).map_err(|error| error.to_string())?;
    Ok(words.iter().flat_map(|word| word.to_le_bytes()).collect())
}

fn spirv_val_is_there() -> bool {
    let there = Command::new("spirv-val").arg("--version").output().is_ok();
    if !there {
        eprintln!("SKIPPED: spirv-val is not installed; install Debian's spirv-tools");
    }
    there
}

/// Runs spirv-val over every module, on as many threads as there are cores.
fn spirv_val(modules: &[Vec<u8>]) {
    if !spirv_val_is_there() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    std::thread::scope(|scope| {
        for thread in 0..threads {
            let path = folder.path().join(format!("{thread}.spv"));
            scope.spawn(move || {
                for module in modules.iter().skip(thread).step_by(threads) {
                    assert!(passes_spirv_val(module, &path), "spirv-val refuses a module");
                }
            });
        }
    });
}

fn passes_spirv_val(module: &[u8], path: &Path) -> bool {
    std::fs::write(path, module).unwrap();
    let output = Command::new("spirv-val").args(["--target-env", "vulkan1.1"]).arg(path).output().unwrap();
    if !output.status.success() {
        eprintln!("{}", String::from_utf8_lossy(&output.stdout));
        eprintln!("{}", String::from_utf8_lossy(&output.stderr));
    }
    output.status.success()
}
