//! Cases from declaration files.

use std::path::{Path, PathBuf};

use cssm_core::LightCase;
use cssm_core::case::MAP_SIDE_LIMIT_TEXELS;

use crate::error::LabError;

/// Smallest map side that a declaration may ask for.
const MAP_SIDE_LEAST_TEXELS: u32 = 64;

/// The case that `FILE` or `FILE:Name` names.
///
/// # Errors
/// When the file cannot be read, has faults, or does not hold exactly that one case.
pub fn load_case(file_and_name: &str) -> Result<LightCase, LabError> {
    let (path, name) = match file_and_name.rsplit_once(':') {
        Some((path, name)) if !path.is_empty() && is_name(name) && !Path::new(file_and_name).exists() => {
            (PathBuf::from(path), Some(name))
        }
        _ => (PathBuf::from(file_and_name), None),
    };
    let text =
        std::fs::read_to_string(&path).map_err(|source| LabError::ReadCase { path: path.clone(), source })?;
    pick_case(&path, &text, name)
}

/// The case of a name, or the only one, in the text of a declaration file.
///
/// # Errors
/// As [`load_case`].
pub fn pick_case(path: &Path, text: &str, name: Option<&str>) -> Result<LightCase, LabError> {
    let mut cases = cssm_codegen::dsl::parse_file(&path.display().to_string(), text)
        .map_err(|report| LabError::Declaration { report: report.render() })?;
    let declared = || cases.iter().map(|case| case.name.clone()).collect();
    let index = match (name, cases.len()) {
        (_, 0) => {
            return Err(LabError::NoCases { path: path.to_owned() });
        }
        (None, 1) => 0,
        (None, _) => {
            return Err(LabError::SeveralCases { path: path.to_owned(), declared: declared() });
        }
        (Some(name), _) => {
            let no_such = || LabError::NoSuchCase {
                path: path.to_owned(),
                name: name.to_owned(),
                declared: declared(),
            };
            cases.iter().position(|case| case.name == name).ok_or_else(no_such)?
        }
    };
    Ok(cases.swap_remove(index))
}

/// The case with a map of another size.
///
/// # Errors
/// When a side is out of range.
pub fn with_map_size(mut case: LightCase, (width, height): (u32, u32)) -> Result<LightCase, LabError> {
    let allowed = MAP_SIDE_LEAST_TEXELS..=MAP_SIDE_LIMIT_TEXELS;
    if !allowed.contains(&width) || !allowed.contains(&height) {
        return Err(LabError::MapSize { width, height, limit: MAP_SIDE_LIMIT_TEXELS });
    }
    (case.map.width, case.map.height) = (width, height);
    Ok(case)
}

fn is_name(text: &str) -> bool {
    !text.is_empty() && text.chars().all(|letter| letter.is_ascii_alphanumeric() || letter == '_')
}

#[cfg(test)]
mod tests {
    use super::*;

    const TWO: &str = "pub case One { prefix: one } pub case Two { prefix: two }";

    fn pick(text: &str, name: Option<&str>) -> Result<String, String> {
        pick_case(Path::new("two.cssm"), text, name).map(|case| case.name).map_err(|error| error.to_string())
    }

    #[test]
    fn cases_are_picked_by_name() {
        assert_eq!(pick(TWO, Some("Two")), Ok("Two".to_owned()));
        assert_eq!(pick("pub case One { prefix: one }", None), Ok("One".to_owned()));
    }

    #[test]
    fn unclear_picks_say_what_there_is() {
        assert_eq!(pick(TWO, None), Err("two.cssm declares One, Two; name one: two.cssm:One".to_owned()));
        assert_eq!(pick(TWO, Some("Sun")), Err("two.cssm has no case Sun; it declares One, Two".to_owned()));
        let none = pick("", None).expect_err("nothing is declared");
        assert!(none.contains("no case is declared"), "{none}");
        let faulty = pick("pub case One { filter: blurred }", None).expect_err("no such filter");
        assert!(faulty.contains("two.cssm:1:"), "{faulty}");
    }

    #[test]
    fn map_sizes_stay_in_range() {
        let case = pick_case(Path::new("two.cssm"), TWO, Some("One")).unwrap();
        assert_eq!(with_map_size(case.clone(), (512, 256)).unwrap().map.height, 256);
        assert!(with_map_size(case, (512, 32)).unwrap_err().to_string().contains("64 to 16384"));
    }
}
