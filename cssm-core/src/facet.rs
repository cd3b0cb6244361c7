//! The facet: the only thing that techniques produce and that shaders consume.
//!
//! A shadow map is a list of facets. A facet is
//!
//! * a **matrix**: four functionals (rows) that take a homogeneous point, relative to the eye in world axes and
//!   metres, to the clip space of the facet's own tile: x and y in [-1, 1] across the whole tile (gutters
//!   included), y up, z in [0, 1] growing away from the light. The rows x, y and w annihilate the light
//!   (r.L = 0), so every point of a light ray lands on the same texel; along the ray z/w grows strictly;
//! * **select** half-spaces, which say which receivers are its own. Receivers outside belong to another facet;
//! * **clip** half-spaces, which say which parts of casters may be drawn where facets share a tile. Each contains
//!   the light (h.L = 0), so a caster is never cut off from the receivers below it. Select and clip are different
//!   sets: a depth slab selects receivers but must never clip casters, and the clip set of a facet reaches past its
//!   receivers by the gutter;
//! * a **tile**: its rectangle of the map, in whole texels, with gutters that only filter taps read. Triangular
//!   facets share a tile; clip half-spaces keep them apart.
//!
//! Standard maps, parallel splits, warped maps and camera space maps differ only in which facets they list; no
//! shader, table or runtime code asks which technique made one. The view and the light decide the numbers; the
//! [`FacetShape`] of a case (how many sectors, how many bands) is known before any frame and decides the shader.
//!
//! Selection is a walk over rows that neighbours **share** ([`Selection`]): one sign per border decides, then
//! thresholds on one distance. It is total by construction: every point has exactly one facet, in f64 and in f32,
//! also on borders, where testing each facet's own half-spaces in f32 would leave points in none or in several.

use glam::{DVec2, DVec4};

use crate::remap::Remap;

/// How many facets a plan of a case may have and how a receiver finds its own; fixed by the declaration.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct FacetShape {
    /// Halves of space, told apart by one plane through the light; 1: not parted.
    pub halves: u32,
    /// Sectors in each half around the axis through eye and light, told apart by shared border rows; 1: no walk.
    pub sectors: u32,
    /// Bands in each sector, told apart by thresholds on the sector's distance row; 1: no thresholds.
    pub bands: u32,
    /// Half-spaces that the capture cuts casters with; 0: every tile is a rectangle of its own.
    pub clips: u32,
    /// Whether receivers near a dominant plane have a facet of their own.
    pub dominant: bool,
}

impl FacetShape {
    /// The shape of a single facet.
    pub const ONE: Self = Self { halves: 1, sectors: 1, bands: 1, clips: 0, dominant: false };

    /// Cells of the walk: `(half * sectors + sector) * bands + band`, and one more for the dominant plane.
    pub const fn cells(self) -> u32 {
        self.halves * self.sectors * self.bands + self.dominant as u32
    }

    /// The smallest shape that holds both.
    #[must_use]
    pub fn max(self, other: Self) -> Self {
        Self {
            halves: self.halves.max(other.halves),
            sectors: self.sectors.max(other.sectors),
            bands: self.bands.max(other.bands),
            clips: self.clips.max(other.clips),
            dominant: self.dominant || other.dominant,
        }
    }
}

/// Four functionals on homogeneous points (x, y, z, 1), relative to the eye in world axes, in metres.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FacetRows {
    /// Clip x of the tile; annihilates the light.
    pub x: DVec4,
    /// Clip y of the tile, up; annihilates the light. With a remap y/w is the k that it takes.
    pub y: DVec4,
    /// Clip z, from 0 towards the light to 1; z/w grows along the ray away from the light. With
    /// [`crate::plan::DepthOrder::Reversed`] from 1 to 0.
    pub z: DVec4,
    /// Clip w, positive on receivers; annihilates the light.
    pub w: DVec4,
    /// What y/w goes through to become NDC.
    pub remap: Remap,
}

/// Distance from a tile's edge, in texels, that keeps the nearest texel inside the tile in f32.
const NEAREST_TAP_MARGIN: f64 = 0.001;
/// Distance from a tile's edge, in texels, that keeps the four nearest texels inside the tile in f32.
const LINEAR_TAP_MARGIN: f64 = 0.51;

/// A rectangle of the map in whole texels; (0, 0) is the map's upper left corner.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Tile {
    /// Left edge.
    pub x: u32,
    /// Upper edge.
    pub y: u32,
    /// Width, gutters included.
    pub width: u32,
    /// Height, gutters included.
    pub height: u32,
    /// Texels along every edge that only filter taps read.
    pub gutter: u32,
}

impl Tile {
    /// Map texel coordinates (fractional, texel centres at .5, y down) of a point of the tile's clip space.
    pub fn texel_from_ndc(&self, x_ndc: f64, y_ndc: f64) -> (f64, f64) {
        (
            f64::from(self.x) + (x_ndc * 0.5 + 0.5) * f64::from(self.width),
            f64::from(self.y) + (0.5 - y_ndc * 0.5) * f64::from(self.height),
        )
    }

    /// Smallest and largest map texel coordinate of a receiver for which no filter tap leaves the tile.
    pub fn texel_limits(&self) -> (DVec2, DVec2) {
        // Taps reach one texel centre past the receiver.
        let margin = if self.gutter == 0 { NEAREST_TAP_MARGIN } else { LINEAR_TAP_MARGIN };
        let low = DVec2::new(f64::from(self.x), f64::from(self.y));
        let size = DVec2::new(f64::from(self.width), f64::from(self.height));
        (low + margin, low + size - margin)
    }

    /// Number of texels, gutters included.
    pub const fn texels(&self) -> u64 {
        self.width as u64 * self.height as u64
    }
}

/// One facet of a plan.
#[derive(Debug, Clone, PartialEq)]
pub struct Facet {
    /// Cells of the [`Selection`] whose receivers are its own, ascending; at least one.
    pub cells: Vec<u32>,
    /// Matrix rows.
    pub rows: FacetRows,
    /// Half-spaces (h.X >= 0) that hold the facet's own receivers.
    pub select: Vec<DVec4>,
    /// Half-spaces (h.X >= 0, h.L = 0) that the capture cuts casters with, gutters included; empty where the tile's
    /// rectangle does it. At most [`FacetShape::clips`].
    pub clip: Vec<DVec4>,
    /// Rectangle of the map.
    pub tile: Tile,
    /// Vertices of the facet's own receivers: the visible polytope cut by `select`; w = 0 lies at infinity.
    pub receivers: Vec<DVec4>,
    /// Half-spaces (h.X >= 0) that hold everything whose shadow can reach the facet's receivers or the filter taps
    /// around them; a box entirely outside one of them casts no shadow here.
    pub casters: Vec<DVec4>,
    /// Change of z/w times w per metre along the light, positive; for a local light also times the distance from it
    /// in metres.
    pub depth_per_metre: f64,
    /// Size of a texel across the light ray in metres, divided by w at the same point; the larger axis.
    pub texel_metres_per_w: f64,
    /// Depth (z/w) by which an exact receiver plane is lowered for half the smaller texel axis; for a local light times
    /// the distance from it in metres.
    pub receiver_plane_depth: f64,
    /// Depth (z/w) by which an exact receiver plane is lowered for rounding.
    pub rounding_depth: f64,
}

impl Facet {
    /// The first of its cells, by which it is named in reports.
    pub fn first_cell(&self) -> u32 {
        self.cells.first().copied().unwrap_or(0)
    }
}

/// The walk from a receiver to its facet.
#[derive(Debug, Clone, PartialEq)]
pub struct Selection {
    /// Rows of the receivers near a dominant plane, which have a facet of their own: the first lies between -1 and 1, the
    /// second is not negative. `None`: there is no plane.
    pub dominant: Option<[DVec4; 2]>,
    /// Parts the halves: points with `split.X >= 0` lie in the first. `None`: all do.
    pub split: Option<DVec4>,
    /// Border rows of the sectors of each half, in walking order, halves one after the other. `borders[k]` separates
    /// sector k - 1 from sector k: a point with `borders[k].X >= 0` lies at or past it. The first closes the ring:
    /// points with a negative value walk backwards from the last sector. A half that does not surround the axis has
    /// `(0, 0, 0, 1)` there, and `(0, 0, 0, -1)` for sectors it does not use. Empty when the shape has one sector.
    pub borders: Vec<DVec4>,
    /// Distance row of each sector; empty when the shape has one band.
    pub distances: Vec<DVec4>,
    /// Thresholds of all sectors one after the other, `bands - 1` for each, ascending: band = how many the distance has
    /// reached.
    pub thresholds: Vec<f64>,
    /// Unit row of each sector that thresholds are multiplied with; empty where all are `(0, 0, 0, 1)`.
    pub units: Vec<DVec4>,
    /// Sectors in each half.
    pub sectors: u32,
    /// Bands in each sector.
    pub bands: u32,
}

/// A cell of a walk.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Cell {
    /// Half of space.
    pub half: u32,
    /// Sector within the half.
    pub sector: u32,
    /// Band within the sector.
    pub band: u32,
}

impl Cell {
    /// The cell of a shape's numbering.
    pub const fn index(self, sectors: u32, bands: u32) -> u32 {
        (self.half * sectors + self.sector) * bands + self.band
    }
}

impl Selection {
    /// The walk of a plan with one facet.
    pub const fn single() -> Self {
        Self::around(1, 1)
    }

    /// A walk with so many sectors in each half and bands in each sector, whose rows are still to be listed.
    pub const fn around(sectors: u32, bands: u32) -> Self {
        Self {
            dominant: None,
            split: None,
            borders: Vec::new(),
            distances: Vec::new(),
            thresholds: Vec::new(),
            units: Vec::new(),
            sectors,
            bands,
        }
    }

    /// Makes it the walk of a plan with so many sectors and bands, whose rows are still to be listed.
    pub(crate) fn begin(&mut self, sectors: u32, bands: u32) {
        (self.dominant, self.split) = (None, None);
        (self.sectors, self.bands) = (sectors, bands);
        self.borders.clear();
        self.distances.clear();
        self.thresholds.clear();
        self.units.clear();
    }

    /// Makes room for so many cells.
    pub(crate) fn reserve(&mut self, cells: usize) {
        self.begin(1, 1);
        self.borders.reserve(cells);
        self.distances.reserve(cells);
        self.thresholds.reserve(cells);
        self.units.reserve(cells);
    }

    /// Thresholds of a sector, halves counted through.
    pub fn limits(&self, sector: usize) -> &[f64] {
        let count = self.bands.saturating_sub(1) as usize;
        self.thresholds.get(sector * count..(sector + 1) * count).unwrap_or(&[])
    }

    /// The walk of a plan that may have fewer halves, sectors and bands than the shape of its case: what is missing is
    /// never reached.
    #[must_use]
    pub fn padded(&self, shape: &FacetShape) -> Self {
        let mut padded = Self::single();
        self.pad(shape, &mut padded);
        padded
    }

    /// [`Self::padded`] in the place of another walk.
    pub(crate) fn pad(&self, shape: &FacetShape, padded: &mut Self) {
        let own_sectors = self.sectors.max(1) as usize;
        let (halves, sectors, bands) = (shape.halves as usize, shape.sectors as usize, shape.bands as usize);
        padded.begin(shape.sectors, shape.bands);
        padded.dominant = self.dominant.or_else(|| shape.dominant.then_some([DVec4::W * NEVER, -DVec4::W]));
        padded.split = self.split.or_else(|| (halves > 1).then_some(DVec4::W));
        for (half, sector) in (0..halves).flat_map(|half| (0..sectors).map(move |sector| (half, sector))) {
            let is_own = sector < own_sectors && (half == 0 || self.split.is_some());
            let listed = is_own.then_some(half * own_sectors + sector);
            if sectors > 1 {
                let border = listed.and_then(|place| self.borders.get(place)).copied();
                padded.borders.push(border.unwrap_or(if sector == 0 { DVec4::W } else { -DVec4::W }));
            }
            if bands > 1 {
                let distance = listed.and_then(|place| self.distances.get(place)).copied();
                padded.distances.push(distance.unwrap_or(DVec4::W));
                let limits = listed.map_or(&[][..], |place| self.limits(place));
                padded.thresholds.extend_from_slice(limits);
                padded.thresholds.resize(padded.distances.len() * (bands - 1), f64::MAX);
                if !self.units.is_empty() {
                    let unit = listed.and_then(|place| self.units.get(place)).copied();
                    padded.units.push(unit.unwrap_or(DVec4::W));
                }
            }
        }
    }

    /// The sector of a homogeneous point relative to the eye, halves counted through: `half * sectors + sector`.
    pub fn sector(&self, point: DVec4) -> u32 {
        let half = u32::from(self.split.is_some_and(|split| split.dot(point) < 0.0));
        let start = (half * self.sectors) as usize;
        let end = (start + self.sectors as usize).min(self.borders.len());
        let Some((first, others)) = self.borders.get(start..end).and_then(|ring| ring.split_first()) else {
            return half * self.sectors;
        };

        // Walk from the ring's start on its near side, from its end on the far side.
        let walked = if first.dot(point) >= 0.0 {
            others.iter().position(|border| border.dot(point) < 0.0).unwrap_or(others.len())
        } else {
            others.iter().rposition(|border| border.dot(point) >= 0.0).map_or(0, |last| last + 1)
        };
        half * self.sectors + walked as u32
    }

    /// The cell of a homogeneous point relative to the eye.
    pub fn cell(&self, point: DVec4) -> u32 {
        let near_plane =
            |[row, front]: [DVec4; 2]| row.dot(point).abs() <= point.w && front.dot(point) >= 0.0;
        if self.dominant.is_some_and(near_plane) {
            return self.dominant_cell();
        }
        let sector = self.sector(point);
        let band = match self.distances.get(sector as usize) {
            None => 0,
            Some(row) => {
                let distance = row.dot(point);
                let unit = self.units.get(sector as usize).map_or(point.w, |unit| unit.dot(point));
                let limits = self.limits(sector as usize);
                limits.iter().map(|limit| u32::from(distance >= *limit * unit)).sum()
            }
        };
        sector * self.bands + band
    }

    /// The cell of receivers near the dominant plane: the last.
    pub fn dominant_cell(&self) -> u32 {
        let halves = 1 + u32::from(self.split.is_some());
        halves * self.sectors * self.bands
    }

    /// Every row of the walk.
    pub(crate) fn rows_mut(&mut self) -> impl Iterator<Item = &mut DVec4> {
        let parting = self.dominant.iter_mut().flatten().chain(&mut self.split);
        parting.chain(&mut self.borders).chain(&mut self.distances).chain(&mut self.units)
    }
}

/// A value of the dominant plane's row that no receiver reaches.
const NEVER: f64 = 2.0;
