//! Names of cases and prefixes of shader names.

/// Longest case name and longest prefix; names become file names.
const NAME_LIMIT: usize = 64;

/// Whether a name is upper camel case and can name a Rust type.
pub(super) fn is_camel_case(name: &str) -> bool {
    name.starts_with(|first: char| first.is_ascii_uppercase())
        && name.chars().all(|letter| letter.is_ascii_alphanumeric())
        && name.len() <= NAME_LIMIT
        && name != "Self"
}

/// Whether a name can prefix shader names: a digit at its end would be mangled by the shader compiler, two
/// underscores are reserved in shading languages.
pub(super) fn is_prefix(prefix: &str) -> bool {
    prefix.starts_with(|first: char| first.is_ascii_lowercase())
        && prefix.ends_with(|last: char| last.is_ascii_lowercase())
        && !prefix.contains("__")
        && prefix.len() <= NAME_LIMIT
        && prefix
            .chars()
            .all(|letter| letter.is_ascii_lowercase() || letter.is_ascii_digit() || letter == '_')
}

/// Snake case of an upper camel case name; a trailing digit is followed by `_case`.
pub(super) fn default_prefix(name: &str) -> String {
    let letters: Vec<char> = name.chars().filter(char::is_ascii_alphanumeric).collect();
    let mut prefix = String::new();
    for (index, letter) in letters.iter().enumerate() {
        // Break words before a capital, but keep runs of capitals together: `HDRSun` is hdr_sun.
        let after_small = index > 0 && !letters[index - 1].is_ascii_uppercase();
        let before_small = letters.get(index + 1).is_some_and(char::is_ascii_lowercase);
        if letter.is_ascii_uppercase() && index > 0 && (after_small || before_small) {
            prefix.push('_');
        }
        prefix.push(letter.to_ascii_lowercase());
    }
    if prefix.ends_with(|last: char| last.is_ascii_digit()) {
        prefix.push_str("_case");
    }
    prefix.truncate(NAME_LIMIT);
    prefix.trim_end_matches(|last: char| !last.is_ascii_lowercase()).into()
}

/// The nearest case name to something that is not one: `my_sun` gives `MySun`.
pub(super) fn upper_camel(name: &str) -> String {
    let words = name.split(|letter: char| !letter.is_ascii_alphanumeric());
    let capital = |word: &str| -> String {
        let mut letters = word.chars();
        letters.next().map(|first| first.to_ascii_uppercase()).into_iter().chain(letters).collect()
    };
    let camel: String = words.map(capital).collect();
    if is_camel_case(&camel) { camel } else { "Sun".into() }
}

#[cfg(test)]
mod tests {
    use super::{default_prefix, is_camel_case, is_prefix, upper_camel};

    #[test]
    fn every_case_name_has_a_prefix() {
        let prefixes = [
            ("Sun", "sun"),
            ("LowSun", "low_sun"),
            ("HDRSun", "hdr_sun"),
            ("Pssm4Log", "pssm4_log"),
            ("Pssm4", "pssm4_case"),
            ("S", "s"),
        ];
        for (name, prefix) in prefixes {
            assert!(is_camel_case(name), "{name}");
            assert_eq!(default_prefix(name), prefix);
            assert!(is_prefix(prefix), "{prefix}");
        }
        assert!(is_prefix(&default_prefix(&"Ab1".repeat(21))));
    }

    #[test]
    fn names_that_break_shaders_or_files_are_refused() {
        for prefix in ["", "Sun", "sun2", "_sun", "sun_", "s__n", "s\u{f6}n", "2sun", &"s".repeat(65)] {
            assert!(!is_prefix(prefix), "{prefix}");
        }
        for name in ["", "sun", "Self", "My_Sun", "S\u{f6}n", "2Sun"] {
            assert!(!is_camel_case(name), "{name}");
            assert!(is_camel_case(&upper_camel(name)), "{name}");
        }
    }
}
