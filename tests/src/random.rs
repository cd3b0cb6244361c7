//! Random declarations over the schema: whatever a field may hold, some of them hold.

use cssm_core::LightCase;
use cssm_core::case::FIELDS;
use cssm_core::schema::{Arguments, Choice, Field, Kind, Value, Word};

/// Largest number that stands for an open end of a range.
const LARGEST: f64 = 1e6;

/// Valid cases, the same ones for the same seed, named `Random` and a letter run.
pub fn cases(seed: u64, count: usize) -> Vec<LightCase> {
    let mut random = Random(seed);
    let mut cases = Vec::new();
    while cases.len() < count {
        // Contradictions between fields are refused by the case itself: draw again.
        let name = format!("Random{}", letters(cases.len()));
        let arguments = arguments(FIELDS, &mut random);
        cases.extend(LightCase::from_arguments(&name, "", random.below(2) == 0, &arguments));
    }
    cases
}

/// The splitmix64 sequence: small, seeded, the same everywhere.
#[derive(Debug, Clone)]
pub struct Random(pub u64);

impl Random {
    /// The next 64 bits.
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ (mixed >> 31)
    }

    /// A whole number below a limit.
    pub fn below(&mut self, limit: usize) -> usize {
        (self.bits() % limit.max(1) as u64) as usize
    }

    /// A number in [0, 1).
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn count(&mut self, min: u32, max: u32) -> u32 {
        // Ends matter most.
        match self.below(6) {
            0 => min,
            1 => max,
            _ => min + self.below((max - min) as usize + 1) as u32,
        }
    }
}

/// Every field is left out half of the time.
fn arguments(fields: &'static [Field], random: &mut Random) -> Arguments {
    let mut pairs = Vec::new();
    for field in fields {
        if random.below(2) == 0
            && let Some(value) = value(&field.kind, random)
        {
            pairs.push((field.name, value));
        }
    }
    Arguments(pairs)
}

fn value(kind: &'static Kind, random: &mut Random) -> Option<Value> {
    Some(match kind {
        Kind::Count { min, max } => Value::Count(random.count(*min, *max)),
        Kind::AutoOrCount { .. } if random.below(2) == 0 => Value::Word(Word::plain("auto")),
        Kind::AutoOrCount { min, max } => Value::Count(random.count(*min, *max)),
        Kind::Number { min, max, open, .. } => Value::Number(number(*min, max.min(LARGEST), *open, random)),
        Kind::NumberOr { choices, .. } if random.below(2) == 0 => Value::Word(word(choices, random)?),
        Kind::NumberOr { min, max, open, .. } => Value::Number(number(*min, max.min(LARGEST), *open, random)),
        Kind::Size { min, max } => Value::Size(random.count(*min, *max), random.count(*min, *max)),
        Kind::SizeList { min, max } => {
            let sizes = (0..=random.below(8)).map(|_| (random.count(*min, *max), random.count(*min, *max)));
            Value::Sizes(sizes.collect())
        }
        Kind::Choice(choices) => Value::Word(word(choices, random)?),
        Kind::ChoiceList(choices) => {
            let mut words: Vec<Word> = Vec::new();
            for _ in 0..=random.below(choices.len()) {
                let word = word(choices, random)?;
                if words.iter().all(|earlier| earlier.name != word.name) {
                    words.push(word);
                }
            }
            Value::Words(words)
        }
        Kind::Group(fields) => Value::Group(arguments(fields, random)),
        Kind::Prefix => Value::Name(prefix(random)),
    })
}

fn word(choices: &'static [Choice], random: &mut Random) -> Option<Word> {
    let choice = choices.get(random.below(choices.len()))?;
    Some(Word { name: choice.name, arguments: arguments(choice.arguments, random) })
}

/// Small numbers are as likely as large ones; closed ends come up often.
fn number(min: f64, max: f64, open: bool, random: &mut Random) -> f64 {
    match random.below(4) {
        0 if !open => min,
        1 if !open => max,
        _ => min + (max - min) * 10.0_f64.powf(-6.0 * random.unit()) * 0.999,
    }
}

/// Prefixes of one to three words; keywords of Rust and of WGSL are among them.
fn prefix(random: &mut Random) -> String {
    const WORDS: [&str; 8] = ["sun", "fn", "struct", "self", "l0w", "x", "texture", "match"];
    let words: Vec<_> = (0..=random.below(3)).map(|_| WORDS[random.below(WORDS.len())]).collect();
    words.join("_")
}

/// `A`, `B`, .. `Z`, `Ba`, ..: digits might end a prefix.
fn letters(index: usize) -> String {
    let letter = |value: usize| char::from(b'a' + (value % 26) as u8);
    let mut letters = vec![letter(index)];
    let mut rest = index / 26;
    while rest > 0 {
        letters.push(letter(rest));
        rest /= 26;
    }
    let text: String = letters.into_iter().rev().collect();
    text[..1].to_uppercase() + &text[1..]
}
