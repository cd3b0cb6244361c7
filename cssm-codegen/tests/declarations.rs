//! The declaration language: what is read, what is refused, and how a refusal reads.

use std::fs;
use std::path::{Path, PathBuf};

use cssm_codegen::dsl::{self, Report};
use cssm_core::LightCase;
use cssm_core::case::{Bias, FIELDS, FarKind, Filter, MaskDepth, MaskNormal, Resolve};
use cssm_core::schema::{Choice, Default, Field, Kind, Value, Word};
use cssm_core::technique::TECHNIQUES;

#[path = "support/random.rs"]
mod random;

use quote::ToTokens;
use random::Random;

const SUN: &str = include_str!("../../shaders-gen/cases/sun.cssm");

fn parse(text: &str) -> Vec<LightCase> {
    dsl::parse_file("test.cssm", text).unwrap_or_else(|report| panic!("{report}"))
}

fn parse_one(text: &str) -> LightCase {
    let [case] = <[LightCase; 1]>::try_from(parse(text)).expect("one case");
    case
}

fn refuse(text: &str) -> Report {
    dsl::parse_file("test.cssm", text).expect_err(text)
}

fn files(folder: &str) -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
    let entries = fs::read_dir(&folder).expect("folder of declarations");
    let mut paths: Vec<_> = entries.map(|entry| entry.expect("entry").path()).collect();
    paths.retain(|path| path.extension().is_some_and(|extension| extension == "cssm"));
    paths.sort();
    paths
}

/// Compares with the snapshot of a name, which lies beside the declarations.
fn lock(name: &str, text: &str) {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path("declarations");
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| insta::assert_snapshot!(name, text));
}

/// Every file of `tests/declarations` holds faults; its rendered report is a snapshot of its own.
#[test]
fn every_refusal_reads_as_locked() {
    let paths = files("tests/declarations");
    assert!(paths.len() >= 20, "only {} reports are locked", paths.len());
    for path in paths {
        let stem = path.file_stem().and_then(|stem| stem.to_str()).expect("ASCII name");
        let text = fs::read_to_string(&path).expect("readable");
        let report = dsl::parse_file(&format!("{stem}.cssm"), &text).expect_err(stem);
        for finding in report.findings() {
            let first = finding.message.chars().next().expect("a message");
            assert!(!first.is_uppercase() && !finding.message.ends_with('.'), "{stem}: {}", finding.message);
            assert!(!finding.remedy.is_empty(), "{stem}: {} has no remedy", finding.message);
            assert!(text.get(finding.bytes.clone()).is_some(), "{stem}: place outside the file");
            assert!(
                !finding.bytes.is_empty() || stem == "empty_file",
                "{stem}: {} has no place",
                finding.message
            );
        }
        lock(stem, &report.render());
    }
}

#[test]
fn a_report_is_also_json() {
    let report =
        refuse("/// \u{fc}ber\ncase Sun {\n    filter: nnoe,\n    bias: none,\n    bias: none,\n}\n");
    lock("report_json", &report.to_json());
}

#[test]
fn a_file_reports_all_its_faults() {
    let text = fs::read_to_string(
        files("tests/declarations")
            .into_iter()
            .find(|path| path.ends_with("many_faults_at_once.cssm"))
            .expect("file"),
    )
    .expect("readable");
    assert_eq!(refuse(&text).findings().len(), 6);
}

#[test]
fn the_empty_case_has_every_default() {
    let case = parse_one("case Sun {}");
    assert_eq!(case.technique, Word::plain("camera_space"));
    assert_eq!(case.configurations, [Word::plain("face_columns")]);
    let bands = [("count", Value::Count(8)), ("horizon", Value::Number(1e5))];
    assert_eq!(case.distribution, Some(Word::with("bands", bands)));
    assert_eq!(
        (case.map.width, case.map.height, case.map.columns, case.map.gutter),
        (2048, 2048, None, None)
    );
    assert_eq!(
        (case.filter, case.bias, case.far),
        (Filter::Gather2x2, Bias::ReceiverPlane, FarKind::Infinite)
    );
    assert_eq!(case.resolve.len(), 2);
    assert_eq!((case.shadow_distance_metres, case.scene_bounds), (None, false));
    assert_eq!((case.prefix.as_str(), case.public), ("sun", false));
}

/// Each default's text, read by the grammar, is the value the schema fills in.
#[test]
fn default_texts_mean_what_they_say() {
    fn fields(kind: &Kind) -> Vec<&'static Field> {
        match *kind {
            Kind::Group(fields) => fields.iter().collect(),
            Kind::Choice(choices) | Kind::ChoiceList(choices) => {
                choices.iter().flat_map(|choice| choice.arguments).collect()
            }
            _ => Vec::new(),
        }
    }
    fn nested(field: &Field) -> Vec<Default> {
        fields(&field.kind).into_iter().flat_map(nested).chain([field.default]).collect()
    }
    for field in FIELDS {
        for default in nested(field) {
            assert_ne!(default, Default::Value(""), "{}", field.name);
        }
        if let Default::Value(text) = field.default {
            let mut written = parse_one(&format!("case Sun {{ {}: {text} }}", field.name));
            let left_out = parse_one("case Sun {}");
            written.prefix.clone_from(&left_out.prefix);
            assert_eq!(written, left_out, "{}: {text}", field.name);
        }
    }
    for technique in TECHNIQUES {
        if let Some(text) = technique.distribution {
            let name = technique.choice.name;
            let head = format!("shadow_distance: 1 km, technique: {name}");
            let written = parse_one(&format!("case Sun {{ {head}, distribution: {text} }}"));
            assert_eq!(written, parse_one(&format!("case Sun {{ {head} }}")), "{text}");
        }
        for variant in technique.variants {
            let case = parse_one(&format!("case Sun {{ shadow_distance: 1 km, technique: {variant} }}"));
            assert_eq!(case.technique.name, technique.choice.name, "{variant}");
        }
        for argument in technique.choice.arguments {
            let Default::Value(text) = argument.default else {
                continue;
            };
            let head = format!("shadow_distance: 1 km, technique: {}", technique.choice.name);
            let written = parse_one(&format!("case Sun {{ {head} {{ {}: {text} }} }}", argument.name));
            assert_eq!(written, parse_one(&format!("case Sun {{ {head} }}")), "{}: {text}", argument.name);
        }
    }
}

#[test]
fn spellings_of_one_declaration_are_one_case() {
    let spellings = [
        "case Sun { map: { size: 2048 x 1024 }, distribution: bands(8), shadow_distance: 20 m }",
        "case Sun { map: { size: 2048x1024 }, distribution: bands { count: 8 }, shadow_distance: 20m }",
        "case Sun { shadow_distance: 2e3 cm, map: { size: 2_048 x1024 }, distribution: bands() }",
        "case Sun { shadow_distance: 0.02 km, map: { size: 2048x 1024, }, distribution: bands(count: 8), }",
        "/* sun */ case Sun { // low\n shadow_distance: 20_000mm, map: { size: 2048 x 1024 },\n light: directional }",
        "\u{feff}case Sun { map: { size: 2048 x 1024 }, distribution: bands(8, horizon: 100 km), shadow_distance: 20 m }",
    ];
    let cases: Vec<_> = spellings.iter().map(|text| parse_one(text)).collect();
    for (case, text) in cases.iter().zip(spellings) {
        assert_eq!(*case, cases[0], "{text}");
    }
    assert_ne!(parse_one("case Sun { map: { size: 2048 x 1024 }, shadow_distance: 21 m }"), cases[0]);
}

#[test]
fn tokens_and_text_give_the_same_cases() {
    let tokens = SUN.parse().expect("tokens");
    assert_eq!(dsl::parse_tokens(tokens).expect("cases"), parse(SUN));
}

#[test]
fn a_builder_says_the_same_as_the_text() {
    let built = LightCase::builder("Sun")
        .doc("Low sun.\n\nSecond paragraph.")
        .far(FarKind::Finite)
        .shadow_distance_metres(250.0)
        .scene_bounds(true)
        .technique(Word::with("parallel_split", [("splits", Value::Count(3))]))
        .configurations(&["slabs"])
        .map_size_texels(1024, 512)
        .map_columns(2)
        .map_gutter_texels(3)
        .filter(Filter::Hardware2x2)
        .bias(Bias::Slope { texels: 2.5 })
        .resolve(&[
            Resolve::Function { group: 1, first_binding: 0 },
            Resolve::Mask { depth: MaskDepth::Linear, normal: MaskNormal::Texture },
        ])
        .prefix("low_sun")
        .build()
        .expect("sound");
    let text = "
        /// Low sun.
        ///
        /// Second paragraph.
        pub case Sun {
            view: perspective { far: finite },
            shadow_distance: 250 m,
            bounds: scene,
            technique: parallel_split(3),
            configurations: [slabs],
            map: { size: 1024 x 512, columns: 2, gutter: 3 },
            filter: hardware_2x2,
            bias: slope(2.5 texels),
            resolve: [function(1), mask { depth: linear, normal: texture }],
            prefix: low_sun,
        }";
    assert_eq!(built, parse_one(text));
}

#[test]
fn the_rust_door_reports_all_faults_too() {
    let errors = LightCase::builder("Sun")
        .map_size_texels(1 << 20, 16)
        .shadow_distance_metres(f64::NAN)
        .technique(Word::plain("magic"))
        .configurations(&["slabs"])
        .bands(99, 1e3)
        .prefix("sun2")
        .build()
        .expect_err("faults");
    let mut fields: Vec<_> = errors.iter().map(|error| error.field.as_str()).collect();
    fields.sort_unstable();
    assert_eq!(fields, ["distribution.count", "map.size", "prefix", "shadow_distance", "technique"]);
    assert!(errors.iter().all(|error| !error.remedy.is_empty()));
}

#[test]
fn docs_come_through_untouched() {
    let case = parse_one("/** Block\n  * of *stars*.\n  */\ncase Sun {}");
    assert_eq!(case.doc, "Block\nof *stars*.");
    let case = parse_one("///   indented\n/// /x ////\n///\n/// \u{df}\ncase Sun {}");
    assert_eq!(case.doc, "  indented\n/x ////\n\n\u{df}");
    assert_eq!(parse_one(&dsl::print(&case)), case);
}

#[test]
fn the_canonical_text_is_locked_and_reads_back() {
    let text = dsl::print(&parse_one(SUN));
    lock("sun_canonical", &text);
    assert_eq!(parse_one(&text), parse_one(SUN));
}

#[test]
fn the_reference_page_names_every_field_and_choice() {
    let page = dsl::reference();
    for field in FIELDS {
        assert!(page.contains(&format!("### `{}`", field.name)), "{}", field.name);
        if let Kind::Choice(choices) | Kind::ChoiceList(choices) = field.kind {
            for Choice { name, .. } in choices {
                assert!(page.contains(&format!("| `{name}` |")), "{name}");
            }
        }
    }
    lock("reference", &page);
}

/// Declarations drawn at random until `wanted` of them are sound.
fn drawn(seed: u64, wanted: usize) -> Vec<(String, LightCase)> {
    let mut random = Random(seed);
    let mut cases = Vec::new();
    for _ in 0..100 * wanted {
        let text = random::declaration(&mut random, "Drawn");
        if let Ok(sound) = dsl::parse_file("drawn.cssm", &text) {
            cases.extend(sound.into_iter().map(|case| (text.clone(), case)));
        }
        if cases.len() == wanted {
            break;
        }
    }
    assert_eq!(cases.len(), wanted, "too few drawn declarations are sound");
    cases
}

#[test]
fn canonical_texts_of_random_cases_read_back() {
    let cases = drawn(1, 900);
    for (text, case) in &cases {
        let printed = dsl::print(case);
        assert_eq!(parse_one(&printed), *case, "{text}\n{printed}");
        assert_eq!(dsl::print(&parse_one(&printed)), printed);
        let arguments = case.to_arguments();
        let again = LightCase::from_arguments(&case.name, &case.doc, case.public, &arguments);
        assert_eq!(again.as_ref(), Ok(case));
    }
    // The draw reaches all over the schema.
    for technique in TECHNIQUES {
        let name = technique.choice.name;
        assert!(cases.iter().any(|(_, case)| case.technique.name == name), "{name} is never drawn");
    }
    let biases: std::collections::BTreeSet<_> = cases.iter().map(|(_, case)| case.bias.name()).collect();
    assert_eq!(biases.len(), 5);
}

/// Breaks declarations in thousands of ways: letters and pieces deleted, doubled, swapped and inserted.
#[test]
fn no_declaration_panics() {
    const PIECES: &[&str] = &[
        "{",
        "}",
        "[",
        "]",
        "(",
        ")",
        ",",
        ":",
        ";",
        "=",
        "-",
        "::",
        "#",
        "#[doc = 1]",
        "//",
        "/*",
        "*/",
        "///",
        "\"",
        "'",
        "'a",
        "r#\"",
        "b\"x\"",
        "0x",
        "0x2048",
        "1e",
        "1e999",
        "20ev",
        "x",
        "2048x",
        "x2048",
        "-1",
        ".5",
        "1.",
        "_",
        "auto",
        "none",
        "case",
        "pub",
        "Sun",
        "bands",
        "map",
        "m",
        "km",
        "\u{d7}",
        "\u{202e}",
        "\u{feff}",
        "\0",
        "\\",
        "\n",
        "\r",
        "$x",
        "r#type",
        "99999999999999999999",
        "1_000",
        "..",
        "@",
        "\u{1f31e}",
    ];
    let mut sources: Vec<String> = drawn(2, 10).into_iter().map(|(text, _)| text).collect();
    sources.push(SUN.into());
    sources
        .extend(files("tests/declarations").iter().map(|path| fs::read_to_string(path).expect("readable")));
    let mut random = Random(3);
    let (mut accepted, mut refused) = (0, 0);
    for round in 0..20_000 {
        let mut letters: Vec<char> = random.pick(&sources).chars().collect();
        for _ in 0..1 + random.below(4) {
            let at = random.below(letters.len() + 1);
            let end = (at + random.below(12)).min(letters.len());
            match random.below(4) {
                0 => drop(letters.drain(at..end)),
                1 => {
                    let piece: Vec<char> = letters[at..end].to_vec();
                    letters.splice(at..at, piece);
                }
                2 => {
                    let piece: Vec<char> = letters.drain(at..end).collect();
                    let to = random.below(letters.len() + 1);
                    letters.splice(to..to, piece);
                }
                _ => drop(letters.splice(at..at, random.pick(PIECES).chars())),
            }
        }
        let text: String = letters.into_iter().collect();
        match dsl::parse_file("mutated.cssm", &text) {
            Ok(cases) => {
                accepted += 1;
                for case in cases {
                    assert_eq!(parse_one(&dsl::print(&case)), case, "round {round}: {text}");
                }
            }
            Err(report) => {
                refused += 1;
                assert!(!report.findings().is_empty(), "round {round}: refused without a reason: {text}");
                for finding in report.findings() {
                    assert!(
                        text.get(finding.bytes.clone()).is_some(),
                        "round {round}: {finding:?} in {text}"
                    );
                }
                let rendered = report.render();
                assert!(rendered.contains("help: "), "round {round}: {rendered}");
                assert!(report.to_json().len() > rendered.len() / 10);
            }
        }
    }
    assert!(accepted > 100 && refused > 10_000, "{accepted} accepted, {refused} refused");
}

#[test]
fn tokens_without_places_are_refused_too() {
    // A token stream may nest deeper than any text that the scan lets through.
    let mut deep = proc_macro2::TokenStream::new();
    for _ in 0..2_000 {
        deep = proc_macro2::Group::new(proc_macro2::Delimiter::Bracket, deep).to_token_stream();
    }
    let tokens = quote::quote! { case Sun { resolve: #deep, filter: gather } };
    let faults = dsl::parse_tokens(tokens).expect_err("faults");
    assert!(faults.iter().any(|fault| fault.message.contains("nested more than 16 deep")));
    let errors: Vec<_> = faults.iter().map(|fault| fault.to_compile_error().to_string()).collect();
    let named =
        |error: &&String| error.contains("compile_error") && error.contains("did you mean `gather_2x2`?");
    assert_eq!(errors.iter().filter(named).count(), 1, "{errors:?}");
    assert!(dsl::parse_tokens(proc_macro2::TokenStream::new()).is_err());
}

/// Macros wrap what they insert in invisible groups.
#[test]
fn invisible_groups_are_seen_through() {
    let hidden = proc_macro2::Group::new(proc_macro2::Delimiter::None, quote::quote! { bands(5) });
    let tokens = quote::quote! { case Sun { distribution: #hidden } };
    assert_eq!(dsl::parse_tokens(tokens).expect("a case"), parse("case Sun { distribution: bands(5) }"));
}
