//! Random declarations, drawn from the schema itself: a new field or choice is drawn without a line here.

use cssm_core::case::FIELDS;
use cssm_core::schema::{Choice, Field, Kind, Unit};

/// A small generator of random numbers (splitmix64): equal seeds give equal declarations on every machine.
pub(crate) struct Random(pub(crate) u64);

impl Random {
    /// The next number.
    pub(crate) fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut bits = self.0;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        bits ^ (bits >> 31)
    }

    /// A number below a positive limit.
    pub(crate) fn below(&mut self, limit: usize) -> usize {
        (self.next() % limit as u64) as usize
    }

    /// One of several.
    pub(crate) fn pick<'a, T>(&mut self, from: &'a [T]) -> &'a T {
        &from[self.below(from.len())]
    }

    fn unit(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// The text of one case. Every value is within its field's range, but fields may contradict each other: most
/// callers draw until one is accepted.
pub(crate) fn declaration(random: &mut Random, name: &str) -> String {
    let mut text = format!("/// Drawn at random.\ncase {name} {{\n");
    for field in FIELDS {
        // Leave fields out half the time; a prefix is drawn from few letters and might collide.
        if random.below(2) == 0 || field.name == "prefix" {
            continue;
        }
        text.push_str(&format!("    {}: {},\n", field.name, value(random, &field.kind)));
    }
    text + "}\n"
}

fn value(random: &mut Random, kind: &Kind) -> String {
    match *kind {
        Kind::Count { min, max } => count(random, min, max),
        Kind::AutoOrCount { min, max } => {
            if random.below(2) == 0 {
                "auto".into()
            } else {
                count(random, min, max)
            }
        }
        Kind::NumberOr { choices, .. } if random.below(2) == 0 => word(random, choices),
        Kind::Number { min, max, unit, .. } | Kind::NumberOr { min, max, unit, .. } => {
            // Draw inside the range, over at most four decades.
            let top = if max.is_finite() { max } else { min + 1e4 };
            let number = (min + (top - min) * 10_f64.powf(-4.0 * random.unit()) * 0.999).clamp(min, top);
            match unit {
                Unit::None => format!("{number}"),
                unit => format!("{number} {}", unit.base_name()),
            }
        }
        Kind::Size { min, max } => size(random, min, max),
        Kind::SizeList { min, max } => {
            let sizes: Vec<_> = (0..1 + random.below(4)).map(|_| size(random, min, max)).collect();
            format!("[{}]", sizes.join(", "))
        }
        Kind::Choice(choices) => word(random, choices),
        Kind::ChoiceList(choices) => {
            let start = random.below(choices.len());
            let length = 1 + random.below(choices.len());
            let chosen = (0..length).map(|index| choices[(start + index) % choices.len()]);
            let words: Vec<_> = chosen.map(|choice| word(random, &[choice])).collect();
            format!("[{}]", words.join(", "))
        }
        Kind::Group(fields) => group(random, fields),
        Kind::Prefix => "drawn".into(),
    }
}

fn word(random: &mut Random, choices: &[Choice]) -> String {
    let choice = random.pick(choices);
    if choice.arguments.is_empty() {
        choice.name.into()
    } else {
        format!("{} {}", choice.name, group(random, choice.arguments))
    }
}

fn group(random: &mut Random, fields: &[Field]) -> String {
    let mut entries = Vec::new();
    for field in fields {
        if random.below(3) > 0 {
            entries.push(format!("{}: {}", field.name, value(random, &field.kind)));
        }
    }
    format!("{{ {} }}", entries.join(", "))
}

fn count(random: &mut Random, min: u32, max: u32) -> String {
    (min as usize + random.below((max - min + 1) as usize)).to_string()
}

/// Sides of at most 1024 texels, so that drawn cases stay cheap to render.
fn size(random: &mut Random, min: u32, max: u32) -> String {
    let top = max.min(1024).max(min);
    format!("{} x {}", count(random, min, top), count(random, min, top))
}
