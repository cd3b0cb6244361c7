//! Number literals: digits and what is glued to them.

/// A literal split into its number and the letters glued to it: `20m`, `2048x2048`, `1.5e3`.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Literal {
    /// The number's own text.
    pub(super) digits: String,
    /// Its value; finite.
    pub(super) value: f64,
    /// Its value if it is written as a whole number; the largest `u64` if it is larger.
    pub(super) whole: Option<u64>,
    /// What is glued to it; may be empty.
    pub(super) suffix: String,
}

impl Literal {
    /// Splits a literal's text.
    ///
    /// # Errors
    /// Message and remedy, for literals that are no decimal number or too large.
    pub(super) fn split(text: &str) -> Result<Self, (String, String)> {
        // Refuse what other languages write here.
        if !text.starts_with(|first: char| first.is_ascii_digit()) {
            return Err((format!("{text} is no number and no name"), "write names without quotes".into()));
        }
        let radix = match text.as_bytes().get(1) {
            _ if !text.starts_with('0') => None,
            Some(b'x') => Some((16, "hexadecimal")),
            Some(b'o') => Some((8, "octal")),
            Some(b'b') => Some((2, "binary")),
            _ => None,
        };
        if let Some((radix, name)) = radix {
            let remedy = match u64::from_str_radix(&text[2..].replace('_', ""), radix) {
                Ok(value) => format!("write the decimal number, `{value}`, or a size such as `2048 x 2048`"),
                Err(_) => "write a decimal number, or a size such as `2048 x 2048`".into(),
            };
            return Err((format!("`{text}` is a {name} number"), remedy));
        }

        // Split behind the digits, one fraction and one exponent.
        let digits_end = |from: usize| {
            let rest = &text[from..];
            from + rest.find(|letter: char| !letter.is_ascii_digit() && letter != '_').unwrap_or(rest.len())
        };
        let mut end = digits_end(0);
        let mut is_whole = true;
        if text[end..].starts_with('.') {
            end = digits_end(end + 1);
            is_whole = false;
        }
        if let Some(exponent) = text[end..].strip_prefix(['e', 'E']) {
            let sign = usize::from(exponent.starts_with(['+', '-']));
            if exponent[sign..].starts_with(|digit: char| digit.is_ascii_digit()) {
                end = digits_end(end + 1 + sign);
                is_whole = false;
            }
        }

        let (digits, suffix) = text.split_at(end);
        let plain = digits.replace('_', "");
        let value = plain.parse().unwrap_or(f64::INFINITY);
        if !f64::is_finite(value) {
            return Err((format!("`{text}` is too large for a number"), "use a smaller number".into()));
        }
        let whole = is_whole.then(|| plain.parse().unwrap_or(u64::MAX));
        Ok(Self { digits: digits.into(), value, whole, suffix: suffix.into() })
    }
}

#[cfg(test)]
mod tests {
    use super::Literal;

    fn parts(text: &str) -> (String, f64, Option<u64>, String) {
        let literal = Literal::split(text).unwrap();
        (literal.digits, literal.value, literal.whole, literal.suffix)
    }

    #[test]
    fn splits_numbers_from_what_is_glued_to_them() {
        assert_eq!(parts("2048x1024"), ("2048".into(), 2048.0, Some(2048), "x1024".into()));
        assert_eq!(parts("20m"), ("20".into(), 20.0, Some(20), "m".into()));
        assert_eq!(parts("20ev"), ("20".into(), 20.0, Some(20), "ev".into()));
        assert_eq!(parts("1.5e3km"), ("1.5e3".into(), 1500.0, None, "km".into()));
        assert_eq!(parts("2_048"), ("2_048".into(), 2048.0, Some(2048), String::new()));
        assert_eq!(parts("1e-3"), ("1e-3".into(), 1e-3, None, String::new()));
        assert_eq!(parts("99999999999999999999").2, Some(u64::MAX));
    }

    #[test]
    fn refuses_radix_prefixes_text_and_overflow() {
        for text in ["0x200", "0b1", "0o17", "0xzz", "1e400", "\"sun\"", "'s'"] {
            assert!(Literal::split(text).is_err(), "{text}");
        }
    }
}
