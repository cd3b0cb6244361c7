//! Places for squares in the one depth texture: they stay where they are until their size changes.

use cssm_core::plan::MapRegion;
use guillotiere::{AllocId, AtlasAllocator, size2};

/// Free and taken places of the texture.
pub(super) struct Places {
    allocator: AtlasAllocator,
}

/// A square of the texture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Place {
    id: AllocId,
    /// Its texels.
    pub(super) region: MapRegion,
}

impl Places {
    /// A texture without squares; wgpu's textures are far smaller than the largest `i32`.
    pub(super) fn new(width: u32, height: u32) -> Self {
        let side = |side: u32| i32::try_from(side).unwrap_or(i32::MAX);
        Self { allocator: AtlasAllocator::new(size2(side(width), side(height))) }
    }

    /// A free square, if there is one.
    pub(super) fn take(&mut self, side: u32) -> Option<Place> {
        let wanted = i32::try_from(side).ok()?;
        let found = self.allocator.allocate(size2(wanted, wanted))?;
        let corner = found.rectangle.min;
        let (x, y) = (u32::try_from(corner.x).ok()?, u32::try_from(corner.y).ok()?);
        Some(Place { id: found.id, region: MapRegion { x, y, width: side, height: side } })
    }

    /// Gives a square back.
    pub(super) fn give_back(&mut self, place: Place) {
        self.allocator.deallocate(place.id);
    }

    /// Forgets all squares.
    pub(super) fn clear(&mut self) {
        self.allocator.clear();
    }
}

impl std::fmt::Debug for Places {
    fn fmt(&self, out: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        out.debug_struct("Places").field("size", &self.allocator.size()).finish_non_exhaustive()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn squares_never_overlap_and_freed_ones_come_back() {
        let mut places = Places::new(1024, 1024);
        let mut taken: Vec<Place> =
            [512, 256, 256, 128, 384, 64, 64].map(|side| places.take(side).unwrap()).into();
        let disjoint = |taken: &[Place]| {
            let apart = |one: MapRegion, two: MapRegion| {
                one.x + one.width <= two.x
                    || two.x + two.width <= one.x
                    || one.y + one.height <= two.y
                    || two.y + two.height <= one.y
            };
            (0..taken.len()).all(|one| (0..one).all(|two| apart(taken[one].region, taken[two].region)))
        };
        assert!(disjoint(&taken));
        assert!(places.take(1024).is_none());
        while places.take(64).is_some() {}
        places.give_back(taken.remove(0));
        taken.push(places.take(512).unwrap());
        assert!(disjoint(&taken));
        places.clear();
        assert!(places.take(1024).is_some());
    }
}
