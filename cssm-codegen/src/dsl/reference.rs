//! The reference page: the schema as a document.

use cssm_core::case::{FIELDS, LightKind};
use cssm_core::schema::{Choice, Default, Field, Kind, Unit};
use cssm_core::technique::TECHNIQUES;

const HEAD: &str = "\
# Declarations

A light case is declared once, in a `.cssm` file, in `light_case! { .. }` or with `LightCase::builder`; the three
are the same declaration and generate the same bytes. A file holds one or more cases:

```text
/// Sun over an open world.
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
```

- A case is named in upper camel case; its doc comment goes into everything that is generated. `pub` makes the
  generated Rust items public.
- Fields are written `name: value` with commas between, in any order, each at most once. Every field has a default.
- Arguments follow a name in braces, `bands { count: 8 }`, or in parentheses, `bands(8, horizon: 100 km)`; in
  parentheses the first needs no name.
- Lengths carry a unit, `20 m` or `20m`: `mm`, `cm`, `m`, `km`. Multiples of a texel carry `texel` or `texels`. Pure
  numbers carry none.
- Sizes are width x height in texels: `2048 x 2048` or `2048x2048`.
- `//` and `/* */` comment. Only comments may hold letters outside ASCII.
- Case names and prefixes are unique in a file.

## Fields
";

/// The reference page of all fields in Markdown: kinds, units, ranges, defaults and choices.
pub fn reference() -> String {
    let mut page = String::from(HEAD);
    for field in FIELDS {
        page.push_str(&format!("\n### `{}`\n\n", field.name));
        page.push_str(&sentence(field.summary));
        page.push_str(&format!("\n\n- Takes {}.\n- Default: {}.\n", takes(&field.kind), default(field)));
        detail(&mut page, &field.kind);
    }
    lights(&mut page);
    page
}

/// Which configurations a technique has for a kind of light.
fn lights(page: &mut String) {
    page.push_str("\n## Lights and configurations\n\n| technique | light | configurations | by default |\n|---|---|---|---|\n");
    for technique in TECHNIQUES {
        for light in [LightKind::Directional, LightKind::Spot, LightKind::Omni] {
            let list =
                |names: &[&str]| names.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ");
            let serving: Vec<_> = technique.serving(light).collect();
            if !serving.is_empty() {
                let (name, light_name) = (technique.choice.name, light.name());
                let defaults = list((technique.default_configurations)(light));
                page.push_str(&format!("| `{name}` | `{light_name}` | {} | {defaults} |\n", list(&serving)));
            }
        }
    }
}

/// Tables of what a field's kind holds in turn.
fn detail(page: &mut String, kind: &Kind) {
    match kind {
        Kind::Choice(choices) | Kind::ChoiceList(choices) | Kind::NumberOr { choices, .. } => {
            page.push_str("\n| value | meaning |\n|---|---|\n");
            for choice in *choices {
                page.push_str(&format!("| `{}` | {} |\n", choice.name, cell(choice.summary)));
            }
            for Choice { name, arguments, .. } in choices.iter().filter(|choice| !choice.arguments.is_empty())
            {
                page.push_str(&format!("\nArguments of `{name}`:\n\n"));
                table(page, arguments);
            }
        }
        Kind::Group(fields) => {
            page.push('\n');
            table(page, fields);
        }
        _ => {}
    }
}

fn table(page: &mut String, fields: &[Field]) {
    page.push_str("| name | takes | default | meaning |\n|---|---|---|---|\n");
    for field in fields {
        let row =
            [takes(&field.kind), default(field), field.summary.into()].map(|text| cell(&text)).join(" | ");
        page.push_str(&format!("| `{}` | {row} |\n", field.name));
    }

    // Say what the choices mean, and list their own arguments in turn.
    for field in fields {
        let (Kind::Choice(choices) | Kind::NumberOr { choices, .. }) = field.kind else {
            continue;
        };
        page.push_str(&format!("\nValues of `{}`:\n\n| value | meaning |\n|---|---|\n", field.name));
        for choice in choices {
            page.push_str(&format!("| `{}` | {} |\n", choice.name, cell(choice.summary)));
        }
        for choice in choices.iter().filter(|choice| !choice.arguments.is_empty()) {
            page.push_str(&format!("\nArguments of `{}`:\n\n", choice.name));
            table(page, choice.arguments);
        }
    }
}

fn takes(kind: &Kind) -> String {
    match kind {
        Kind::Number { unit: Unit::Length, .. } => format!("{kind}, in `mm`, `cm`, `m` or `km`"),
        Kind::Number { unit: Unit::Texels, .. } => format!("{kind}, written `texel` or `texels`"),
        Kind::Number { unit: Unit::Degrees, .. } => format!("{kind}, written `deg`, `degree` or `degrees`"),
        Kind::Number { unit: Unit::Pixels, .. } => format!("{kind}, written `px`, `pixel` or `pixels`"),
        kind => kind.to_string(),
    }
}

fn default(field: &Field) -> String {
    match field.default {
        Default::Value(text) => format!("`{text}`"),
        Default::Absent(meaning) => format!("left out: {meaning}"),
        Default::Required => "none: it must be written".into(),
    }
}

fn sentence(summary: &str) -> String {
    let mut letters = summary.chars();
    let first: String = letters.next().map(|first| first.to_uppercase().collect()).unwrap_or_default();
    format!("{first}{}.", letters.as_str())
}

fn cell(text: &str) -> String {
    text.replace('|', "\\|")
}
