// Where the perspective of an eye that is pushed back ends.

/// Smallest divisor on either side of the remap.
const SMALLEST_DIVISOR: f32 = 1e-5;
