//! The declarations that ship, as text.

/// Case `Sun`: face columns of eight bands, to infinity.
pub const SUN: &str = include_str!("../cases/sun.cssm");
/// Case `OnePlane`: one plane with a focus, for light from outside the view.
pub const ONE_PLANE: &str = include_str!("../cases/one_plane.cssm");
/// Case `FourPlane`: four planes with a focus, for light in or near the view.
pub const FOUR_PLANE: &str = include_str!("../cases/four_plane.cssm");
/// Case `Planes`: one plane or four, chosen by each plan.
pub const PLANES: &str = include_str!("../cases/planes.cssm");
/// Case `SunLog`: face columns whose rows run with the logarithm of distance, to infinity.
pub const SUN_LOG: &str = include_str!("../cases/sun_log.cssm");
/// Case `SunStretched`: one plane with a focus whose rows are bent, for light from outside the view.
pub const SUN_STRETCHED: &str = include_str!("../cases/sun_stretched.cssm");
/// Case `Lamp`: a light that shines to all sides, wherever it stands.
pub const LAMP: &str = include_str!("../cases/lamp.cssm");
/// Case `Spot`: a spot light, wherever it stands.
pub const SPOT: &str = include_str!("../cases/spot.cssm");
/// Case `Pssm4Log`: four parallel splits at logarithmic limits.
pub const PSSM4_LOG: &str = include_str!("../cases/pssm4_log.cssm");
/// Case `Pssm4Practical`: four parallel splits at practical limits.
pub const PSSM4_PRACTICAL: &str = include_str!("../cases/pssm4_practical.cssm");
/// Case `Standard`: one uniform map.
pub const STANDARD: &str = include_str!("../cases/standard.cssm");

/// All of them, the recommended one first.
pub const ALL: &[&str] = &[
    SUN,
    SUN_LOG,
    SUN_STRETCHED,
    ONE_PLANE,
    FOUR_PLANE,
    PLANES,
    LAMP,
    SPOT,
    PSSM4_LOG,
    PSSM4_PRACTICAL,
    STANDARD,
];
