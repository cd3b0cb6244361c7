//! What an instance is, in 64 bits: a facet whose instances sum to the same number draws the same.

use crate::mesh::CasterInstance;

/// Start and factor of FNV-1a.
const FNV: (u64, u64) = (0xcbf2_9ce4_8422_2325, 0x0000_0100_0000_01b3);

/// Hash of an instance's mesh and the bits of its transform. Well mixed, so that sums of hashes tell sets apart.
pub(super) fn hash(instance: &CasterInstance) -> u64 {
    let CasterInstance { mesh, world_from_object } = instance;
    let handle = u64::from(mesh.index) << 32 | u64::from(mesh.generation);
    let numbers = world_from_object.to_cols_array().map(f64::to_bits);
    let words = std::iter::once(handle).chain(numbers);
    mixed(words.fold(FNV.0, |hash, word| mixed(hash ^ word).wrapping_mul(FNV.1)))
}

/// Spreads every bit over all others (finaliser of MurmurHash3).
pub(crate) fn mixed(mut hash: u64) -> u64 {
    for factor in [0xff51_afd7_ed55_8ccd, 0xc4ce_b9fe_1a85_ec53] {
        hash = (hash ^ hash >> 33).wrapping_mul(factor);
    }
    hash ^ hash >> 33
}
