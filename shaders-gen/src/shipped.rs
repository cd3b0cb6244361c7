//! The declarations that ship, as text.

/// Case `Sun`: face columns of eight bands, to infinity.
pub const SUN: &str = include_str!("../cases/sun.cssm");
/// Case `Pssm4Log`: four parallel splits at logarithmic limits.
pub const PSSM4_LOG: &str = include_str!("../cases/pssm4_log.cssm");
/// Case `Pssm4Practical`: four parallel splits at practical limits.
pub const PSSM4_PRACTICAL: &str = include_str!("../cases/pssm4_practical.cssm");
/// Case `Standard`: one uniform map.
pub const STANDARD: &str = include_str!("../cases/standard.cssm");
