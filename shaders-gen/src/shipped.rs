//! The declarations that ship, as text.

/// Case `Sun`: face columns of eight bands, to infinity.
pub const SUN: &str = include_str!("../cases/sun.cssm");
/// Case `OnePlane`: one plane with a focus, for light from outside the view.
pub const ONE_PLANE: &str = include_str!("../cases/one_plane.cssm");
/// Case `FourPlane`: four planes with a focus, for light in or near the view.
pub const FOUR_PLANE: &str = include_str!("../cases/four_plane.cssm");
/// Case `Planes`: one plane or four, chosen by each plan.
pub const PLANES: &str = include_str!("../cases/planes.cssm");
/// Case `Pssm4Log`: four parallel splits at logarithmic limits.
pub const PSSM4_LOG: &str = include_str!("../cases/pssm4_log.cssm");
/// Case `Pssm4Practical`: four parallel splits at practical limits.
pub const PSSM4_PRACTICAL: &str = include_str!("../cases/pssm4_practical.cssm");
/// Case `Standard`: one uniform map.
pub const STANDARD: &str = include_str!("../cases/standard.cssm");

/// All of them, the recommended one first.
pub const ALL: &[&str] = &[SUN, ONE_PLANE, FOUR_PLANE, PLANES, PSSM4_LOG, PSSM4_PRACTICAL, STANDARD];
