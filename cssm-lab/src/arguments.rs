//! Values of command line arguments.

use cssm_core::Light;
use cssm_core::glam::DVec3;

/// Largest image side that is accepted; adapters may allow less.
const IMAGE_SIDE_LIMIT_PIXELS: u32 = 16384;

/// `x,y,z`.
///
/// # Errors
/// What to write instead.
pub fn parse_point(text: &str) -> Result<DVec3, String> {
    let numbers: Vec<f64> = text
        .split(',')
        .map(|number| {
            number.trim().parse().map_err(|_| format!("`{}` is not a number; write x,y,z", number.trim()))
        })
        .collect::<Result<_, String>>()?;
    match numbers[..] {
        [x, y, z] if DVec3::new(x, y, z).is_finite() => Ok(DVec3::new(x, y, z)),
        [_, _, _] => Err("the numbers must be finite".to_owned()),
        _ => Err(format!("{} numbers were given; write three: x,y,z", numbers.len())),
    }
}

/// What `--light` takes.
pub const LIGHT_FORMS: &str =
    "directional:X,Y,Z|omni:PX,PY,PZ[:RANGE]|spot:PX,PY,PZ:DX,DY,DZ:HALF_ANGLE_DEGREES[:RANGE]";

/// A light: the direction in which a directional one travels; a local one's position, a spot light's direction and the
/// angle between its axis and its edge in degrees, and the range in metres, without which there is no limit.
///
/// # Errors
/// What to write instead.
pub fn parse_light(text: &str) -> Result<Light, String> {
    let unknown = || format!("`{text}` is no light; write {LIGHT_FORMS}");
    let (kind, rest) = text.split_once(':').ok_or_else(unknown)?;
    let parts: Vec<&str> = rest.split(':').collect();
    let range = |part: Option<&&str>| part.map_or(Ok(f64::INFINITY), |text| parse_depth(text));
    let light = match (kind, &parts[..]) {
        ("directional", [direction]) => Light::directional_travelling(parse_point(direction)?),
        ("omni", [position, rest @ ..]) if rest.len() < 2 => {
            Light::omni(parse_point(position)?, range(rest.first())?)
        }
        ("spot", [position, direction, angle, rest @ ..]) if rest.len() < 2 => {
            let degrees: f64 =
                angle.trim().parse().map_err(|_| format!("`{angle}` is no angle; write degrees"))?;
            let (position, direction) = (parse_point(position)?, parse_point(direction)?);
            Light::spot(position, direction, degrees.to_radians(), range(rest.first())?)
        }
        _ => return Err(unknown()),
    };
    light.map_err(|error| error.to_string())
}

/// A depth in metres, or `inf`.
///
/// # Errors
/// What to write instead.
pub fn parse_depth(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(depth) if depth > 0.0 => Ok(depth),
        _ => Err("write a positive number of metres, or inf".to_owned()),
    }
}

/// `WxH` in pixels.
///
/// # Errors
/// What to write instead.
pub fn parse_image_size(text: &str) -> Result<(u32, u32), String> {
    let (width, height) = parse_size(text)?;
    let limit = IMAGE_SIDE_LIMIT_PIXELS;
    if width.max(height) > limit {
        return Err(format!("give at most {limit} pixels a side"));
    }
    Ok((width, height))
}

/// `WxH`, both at least 1.
///
/// # Errors
/// What to write instead.
pub fn parse_size(text: &str) -> Result<(u32, u32), String> {
    let sides = text.split_once(['x', 'X']).and_then(|(width, height)| {
        Some((width.trim().parse::<u32>().ok()?, height.trim().parse::<u32>().ok()?))
    });
    sides
        .filter(|(width, height)| *width > 0 && *height > 0)
        .ok_or_else(|| "write WIDTHxHEIGHT, such as 640x360".to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn good_values_are_read() {
        assert_eq!(parse_point("1, -2.5,3e2"), Ok(DVec3::new(1.0, -2.5, 300.0)));
        assert_eq!(parse_depth("inf"), Ok(f64::INFINITY));
        assert_eq!(parse_image_size("640x360"), Ok((640, 360)));
        let Ok(Light::Directional { toward_light_world }) = parse_light("directional:0,-2,0") else {
            panic!()
        };
        assert_eq!(toward_light_world, DVec3::Y);
        let lamp = DVec3::new(1.0, 2.0, -3.0);
        assert_eq!(parse_light("omni:1,2,-3"), Ok(Light::omni(lamp, f64::INFINITY).unwrap()));
        assert_eq!(parse_light("omni:1,2,-3:8.5"), Ok(Light::omni(lamp, 8.5).unwrap()));
        let spot = |range| Ok(Light::spot(lamp, DVec3::NEG_Y, 30_f64.to_radians(), range).unwrap());
        assert_eq!(parse_light("spot:1,2,-3:0,-1,0:30"), spot(f64::INFINITY));
        assert_eq!(parse_light("spot:1,2,-3:0,-1,0:30:12"), spot(12.0));
    }

    #[test]
    fn bad_values_say_what_to_write() {
        let errors = [
            parse_point("1,2").map(|_| ()),
            parse_point("1,2,three").map(|_| ()),
            parse_point("1,2,inf").map(|_| ()),
            parse_light("point:1,2,3").map(|_| ()),
            parse_light("directional:0,0,0").map(|_| ()),
            parse_depth("-3").map(|_| ()),
            parse_depth("NaN").map(|_| ()),
            parse_image_size("640").map(|_| ()),
            parse_image_size("0x3").map(|_| ()),
            parse_image_size("99999x3").map(|_| ()),
        ];
        let texts: Vec<_> = errors.into_iter().map(|error| error.expect_err("the value is wrong")).collect();
        assert_eq!(texts[0], "2 numbers were given; write three: x,y,z");
        assert_eq!(texts[1], "`three` is not a number; write x,y,z");
        assert!(texts[3].contains("directional:X,Y,Z|omni:PX,PY,PZ"));
        assert!(texts[4].contains("not zero"));
        assert_eq!(texts[5], "write a positive number of metres, or inf");
        assert_eq!(texts[9], "give at most 16384 pixels a side");
        for (text, said) in [
            ("omni:1,2,3:4:5", "is no light"),
            ("omni:1,2,3:-4", "positive number of metres"),
            ("spot:1,2,3:0,-1,0", "is no light"),
            ("spot:1,2,3:0,-1,0:90", "no cone"),
            ("spot:1,2,3:0,-1,0:wide", "is no angle"),
        ] {
            let error = parse_light(text).expect_err("the light is wrong");
            assert!(error.contains(said), "{text}: {error}");
        }
    }
}
