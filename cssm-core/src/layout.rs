//! Tiles: how facets share the map.
//!
//! Tiles stand in strips that run the whole height of the map; tiles of one strip share their width, so the map is
//! covered without rest and only gutters are lost. Facets that ask for equal footprints get them, as small as any
//! partition into strips affords; the partition is judged by that very footprint, so that quality changes smoothly
//! where another partition takes over. Facets that ask for shares of the map get tiles as square as can be.

mod equal;
mod fixed;
mod shares;
mod spread;
mod strips;

pub use self::spread::Spread;
use crate::facet::Tile;
use crate::plan::PlanError;
use crate::technique::TileRequest;
use smallvec::SmallVec;

/// Smallest side of a tile's inner part, in texels.
const SMALLEST_INNER_SIDE: u32 = 4;

/// What the layout knows of one facet.
#[derive(Debug, Clone, Copy)]
pub struct TileDemand {
    /// What the technique asked for.
    pub request: TileRequest,
    /// What the tile spans at sample receivers; only asked for where footprints are balanced.
    pub spread: Spread,
    /// Whether the tile may be turned by a quarter.
    pub may_turn: bool,
}

/// A tile, and how the facet lies in it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Placement {
    /// Its rectangle of the map.
    pub tile: Tile,
    /// Whether the facet's y runs along the tile's x: rows (x, y) become (y, -x).
    pub turned: bool,
}

/// Products of the two screen vectors (pixels) that span a facet's clip space across and up.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gram {
    /// across . across
    pub xx: f64,
    /// up . up
    pub yy: f64,
    /// across . up
    pub xy: f64,
}

impl Gram {
    /// Major axis in pixels of one texel of a tile of this inner size.
    pub fn major_pixels(&self, width: f64, height: f64) -> f64 {
        self.major_square(width, height).sqrt()
    }

    /// Square of [`Self::major_pixels`].
    pub(crate) fn major_square(&self, width: f64, height: f64) -> f64 {
        let (xx, yy, xy) =
            (self.xx / (width * width), self.yy / (height * height), self.xy / (width * height));
        0.5 * (xx + yy) + (0.25 * (xx - yy) * (xx - yy) + xy * xy).sqrt()
    }

    /// Major and minor axis in pixels of one texel of a tile with these inverses of its inner sides.
    pub(crate) fn axes_pixels(&self, per_width: f64, per_height: f64) -> (f64, f64) {
        let xx = self.xx * per_width * per_width;
        let yy = self.yy * per_height * per_height;
        let xy = self.xy * per_width * per_height;
        let (mean, half) = (0.5 * (xx + yy), 0.5 * (xx - yy));
        let square = mean + (half * half + xy * xy).sqrt();
        let area = (self.xx * self.yy - self.xy * self.xy).max(0.0) * per_width * per_height;
        let minor = if square > 0.0 { (area * per_width * per_height / square).sqrt() } else { 0.0 };
        (square.sqrt(), minor)
    }

    /// Vectors shorter by a factor.
    pub(crate) fn shortened(&self, factor: f64) -> Self {
        let square = factor * factor;
        Self { xx: self.xx / square, yy: self.yy / square, xy: self.xy / square }
    }

    /// The same facet after a quarter turn of its clip space.
    #[must_use]
    pub fn turned(&self) -> Self {
        Self { xx: self.yy, yy: self.xx, xy: -self.xy }
    }
}

/// Size, gutters and folding of the map.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct MapArea {
    /// Width in texels.
    pub width: u32,
    /// Height in texels.
    pub height: u32,
    /// Gutter of every tile.
    pub gutter: u32,
    /// Number of strips, if declared.
    pub strips: Option<u32>,
}

impl MapArea {
    /// Smallest tile side.
    pub(crate) fn smallest_side(&self) -> u32 {
        2 * self.gutter + SMALLEST_INNER_SIDE
    }

    pub(crate) fn too_small(&self, tiles: usize) -> PlanError {
        PlanError::MapTooSmall {
            width: self.width,
            height: self.height,
            tiles: tiles as u32,
            gutter: self.gutter,
        }
    }
}

/// Whether a tile asks for the footprint of the others, whatever its size.
pub(crate) const fn is_balanced(request: TileRequest) -> bool {
    matches!(request, TileRequest::Footprint | TileRequest::Coarser { .. })
}

/// Places one tile per demand; tiles never overlap and lie inside the map.
///
/// # Errors
/// [`PlanError::MapTooSmall`] when they do not fit.
pub fn place(demands: &[TileDemand], area: &MapArea) -> Result<Vec<Placement>, PlanError> {
    let mut placed = Placements::new();
    Layout::default().place(demands, area, &mut placed)?;
    Ok(placed.into_vec())
}

/// Places of tiles.
pub(crate) type Placements = SmallVec<[Placement; 4]>;

/// What placing tiles works in.
#[derive(Debug, Default)]
pub(crate) struct Layout {
    search: equal::Search,
    tiles: strips::Few<Tile>,
}

impl Layout {
    /// Makes room for so many tiles.
    pub(crate) fn make_room(&mut self, most: usize) {
        self.search.make_room(most);
        self.tiles.reserve(most.saturating_sub(self.tiles.len()));
    }

    /// [`place`], into a list.
    pub(crate) fn place(
        &mut self,
        demands: &[TileDemand],
        area: &MapArea,
        placed: &mut Placements,
    ) -> Result<(), PlanError> {
        if demands.iter().all(|demand| is_balanced(demand.request)) {
            return self.search.place(demands, area, placed);
        }
        let sizes = demands.iter().map(|demand| match demand.request {
            TileRequest::Fixed(width, height) => Some((width, height)),
            _ => None,
        });
        match sizes.collect::<Option<SmallVec<[(u32, u32); 16]>>>() {
            Some(sizes) => fixed::place(&sizes, area, &mut self.tiles)?,
            None => shares::place(demands, area, &mut self.tiles)?,
        }
        placed.clear();
        placed.extend(self.tiles.iter().map(|tile| Placement { tile: *tile, turned: false }));
        Ok(())
    }
}
