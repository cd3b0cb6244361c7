// Bins of depth.

/// Bits of a float below those that name its bin.
const BIN_SHIFT: u32 = 21u;
/// Those bits of one.
const FIRST_BIN: u32 = 508u;
/// The farthest bin.
const LAST_BIN: u32 = 63u;
/// Bits of infinity.
const INFINITE_BITS: u32 = 0x7f800000u;

/// Bin of a depth in metres: quarters of octaves of its ratio to the near plane's.
fn depth_bin(metres: f32) -> u32 {
    let ratio = max(1.0, metres * fit.per_near);
    return min((bitcast<u32>(ratio) >> BIN_SHIFT) - FIRST_BIN, LAST_BIN);
}
