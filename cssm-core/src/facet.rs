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

/// How many facets a plan of a case may have and how a receiver finds its own; fixed by the declaration.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct FacetShape {
    /// Sectors around the eye, told apart by shared border rows; 1: no walk.
    pub sectors: u32,
    /// Bands in each sector, told apart by thresholds on the sector's distance row; 1: no thresholds.
    pub bands: u32,
    /// Half-spaces that the capture cuts casters with; 0: every tile is a rectangle of its own.
    pub clips: u32,
}

impl FacetShape {
    /// Largest number of facets of a plan.
    pub const fn facets(self) -> u32 {
        self.sectors * self.bands
    }
}

/// Four functionals on homogeneous points (x, y, z, 1), relative to the eye in world axes, in metres.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FacetRows {
    /// Clip x of the tile; annihilates the light.
    pub x: DVec4,
    /// Clip y of the tile, up; annihilates the light.
    pub y: DVec4,
    /// Clip z, from 0 towards the light to 1; z/w grows along the ray away from the light. With
    /// [`crate::plan::DepthOrder::Reversed`] from 1 to 0.
    pub z: DVec4,
    /// Clip w, positive on receivers; annihilates the light.
    pub w: DVec4,
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
    /// Index in [`Selection`]'s numbering: `sector * bands + band`.
    pub index: u32,
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
    /// Change of z/w times w per metre along the light, positive.
    pub depth_per_metre: f64,
    /// Size of a texel across the light ray in metres, divided by w at the same point; the larger axis.
    pub texel_metres_per_w: f64,
    /// Depth (z/w) by which an exact receiver plane is lowered: rounding and half the smaller texel axis.
    pub receiver_plane_depth: f64,
}

/// The walk from a receiver to its facet.
#[derive(Debug, Clone, PartialEq)]
pub struct Selection {
    /// Border rows of the sectors, in walking order. `borders[k]` separates sector k - 1 from sector k: a point
    /// with `borders[k].X >= 0` lies at or past it. `borders[0]` closes the ring: points with a negative value
    /// walk backwards from the last sector. A plan that does not surround the eye has `(0, 0, 0, 1)` there, and
    /// `(0, 0, 0, -1)` for sectors it does not use. Empty when the shape has one sector.
    pub borders: Vec<DVec4>,
    /// Distance row of each sector; empty when the shape has one band.
    pub distances: Vec<DVec4>,
    /// Ascending thresholds of each sector, `bands - 1` of them: band = how many the distance has reached.
    pub thresholds: Vec<Vec<f64>>,
    /// Bands in each sector.
    pub bands: u32,
}

impl Selection {
    /// The walk of a plan with one facet.
    pub fn single() -> Self {
        Self { borders: Vec::new(), distances: Vec::new(), thresholds: Vec::new(), bands: 1 }
    }

    /// The walk of a plan that may have fewer sectors and bands than the shape of its case: what is missing is never
    /// reached.
    pub fn padded(mut self, shape: &FacetShape) -> Self {
        let (sectors, bands) = (shape.sectors as usize, shape.bands as usize);
        if sectors > 1 {
            if self.borders.is_empty() {
                self.borders.push(DVec4::W);
            }
            self.borders.resize(sectors, -DVec4::W);
        }
        if bands > 1 {
            self.distances.resize(sectors, DVec4::W);
            self.thresholds.resize(sectors, Vec::new());
            for limits in &mut self.thresholds {
                limits.resize(bands - 1, f64::MAX);
            }
        }
        self.bands = shape.bands;
        self
    }

    /// The sector of a homogeneous point relative to the eye.
    pub fn sector(&self, point: DVec4) -> u32 {
        let Some(first) = self.borders.first() else { return 0 };
        let last = self.borders.len() - 1;
        // Walk from the ring's start on its near side, from its end on the far side.
        if first.dot(point) >= 0.0 {
            let reached = self.borders[1..].iter().take_while(|border| border.dot(point) >= 0.0);
            reached.count() as u32
        } else {
            let passed = self.borders[1..].iter().rev().take_while(|border| border.dot(point) < 0.0);
            (last - passed.count()) as u32
        }
    }

    /// The facet index of a homogeneous point relative to the eye: `sector * bands + band`.
    pub fn facet(&self, point: DVec4) -> u32 {
        let sector = self.sector(point);
        let band = match self.distances.get(sector as usize) {
            None => 0,
            Some(row) => {
                let distance = row.dot(point);
                self.thresholds[sector as usize].iter().filter(|limit| distance >= **limit * point.w).count()
                    as u32
            }
        };
        sector * self.bands + band
    }
}
