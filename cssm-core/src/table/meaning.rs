//! What the fields of records hold.

/// What a record field holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Meaning {
    /// Facet row: clip x of the tile from (x, y, z, 1) relative to the eye.
    RowX,
    /// Facet row: clip y of the tile, up.
    RowY,
    /// Facet row: clip z.
    RowZ,
    /// Facet row: clip w.
    RowW,
    /// Map texel = ndc * xy + zw.
    TexelFromNdc,
    /// Smallest (xy) and largest (zw) map texel coordinate of a receiver for which no tap leaves the tile.
    TexelLimits,
    /// Depth times w per metre away from the light.
    DepthPerMetre,
    /// Larger texel axis across the ray in metres, per w.
    TexelMetresPerW,
    /// Depth by which an exact receiver plane is lowered for half a texel, and for rounding: their sum; for a local light
    /// the first part alone, times the distance from it.
    ReceiverPlaneDepth,
    /// Depth by which an exact receiver plane is lowered for rounding, for a local light.
    RoundingDepth,
    /// Remap of the rows: for [`crate::distribution::RemapKind::Perspective`] (shift, scale, push-back, 0); for [`crate::distribution::RemapKind::Logarithmic`]
    /// (shift, change per ln(k reference), reference, 0), then (k of the horizon, shift, change per k beyond it, 0).
    Remap,
    /// Width and height of the facet's tile in texels.
    TileSize,
    /// Smallest and largest k of the tile (xy) and the map texel of its upper left corner (zw), for casters that are decided
    /// texel by texel.
    StretchTile,
    /// Position of a local light relative to the eye, in the case's axes.
    LightPosition,
    /// Plane through the light that parts the halves.
    Split,
    /// Rows of receivers near the dominant plane: the first between -1 and 1, the second not negative.
    Dominant,
    /// Rows that band limits are multiplied with, one per sector.
    Units,
    /// Unit vector towards the light, in the case's axes.
    TowardLight,
    /// What x and y gain per z by the shear along the light: leading parts of twelve bits (xy), then the rest (zw).
    Shear,
    /// Row that gives the metres that a screen pixel spans at a position's depth.
    PixelMetres,
    /// 1 where stored depth grows away from the light, -1 where it falls.
    DepthSign,
    /// Half-spaces that casters are cut with; all of space where a facet has none.
    Clips,
    /// Alpha below which a caster has a hole.
    AlphaCutoff,
    /// Border rows of the selection walk, one per sector.
    Borders,
    /// Distance rows, one per sector.
    Distances,
    /// Band limits: four to a vector, `ceil((bands - 1) / 4)` vectors to a sector; unused entries are the largest
    /// float.
    Thresholds,
    /// Planes with masks of their own, as unit normals and offsets relative to the eye, in the case's axes.
    GroundPlanes,
    /// Where those planes lie in tiles, four vectors to a plane, planes of a cell one after the other: see
    /// [`crate::ground::PlaneInTile`], whose figures stand in xyz; zero where a plane is not lit.
    GroundTiles,
    /// Edges of facets that share their tile, of clip x/w and y/w in xyz; as many to a cell as facets have clip half-spaces.
    GroundEdges,
    /// All facets, by index.
    Facets,
    /// Direction relative to the eye, in the case's axes, depth 1, at the image's upper left corner.
    RayCorner,
    /// Change of that direction across the whole image width.
    RayAcross,
    /// Change of that direction down the whole image height.
    RayDown,
    /// 1 / depth = x * stored + y, for reversed-z depth.
    InverseDepth,
    /// One over the depth of the near plane.
    PerNear,
}

impl Meaning {
    /// One sentence for the comments of shaders and tables.
    pub const fn summary(self) -> &'static str {
        match self {
            Self::RowX => "Clip x of the tile, to the right.",
            Self::RowY => "Clip y of the tile, upwards.",
            Self::RowZ => "Clip z: depth along the light times w.",
            Self::RowW => "Clip w, positive on receivers.",
            Self::TexelFromNdc => "Map texel coordinates = clip space after division * xy + zw.",
            Self::TexelLimits => {
                "Smallest (xy) and largest (zw) map texel coordinates of the facet's receivers."
            }
            Self::DepthPerMetre => "Depth times w per metre away from the light.",
            Self::TexelMetresPerW => "Larger side of a texel across the light in metres, per w.",
            Self::ReceiverPlaneDepth => "Depth by which an exact receiver plane is lowered.",
            Self::TowardLight => "Unit vector towards the light, in the case's axes.",
            Self::Shear => {
                "What x and y gain per z by the shear along the light: twelve leading bits, then the rest."
            }
            Self::PixelMetres => "Metres that a screen pixel spans at a position's depth.",
            Self::DepthSign => "1 where stored depth grows away from the light, -1 where it falls.",
            Self::Clips => "Half-spaces that casters are cut with.",
            Self::AlphaCutoff => "Alpha below which the caster has a hole.",
            Self::Borders => "Border rows of the sectors, in walking order; the first closes the ring.",
            Self::Distances => "Distance row of each sector.",
            Self::Thresholds => {
                "Ascending band limits of each sector, four to a vector; unused ones are out of reach."
            }
            Self::GroundPlanes => "Planes with masks, as normals and offsets, in the case's axes.",
            Self::GroundTiles => {
                "Planes in tiles, four vectors each: depth, one over w, squared densities of texels along x and y."
            }
            Self::GroundEdges => "Edges of facets in tiles that they share, positive inside.",
            Self::Facets => "The facets: cell = (half * sectors + sector) * bands + band.",
            Self::RoundingDepth => "Depth by which an exact receiver plane is lowered for rounding.",
            Self::Remap => "How y/w becomes clip y: shifts and scales of a monotone curve.",
            Self::TileSize => "Width and height of the tile in texels.",
            Self::StretchTile => {
                "Smallest and largest k of the tile (xy), map texel of its upper left corner (zw)."
            }
            Self::LightPosition => "The light's position relative to the eye, in the case's axes.",
            Self::Split => "Plane through the light: receivers on its positive side walk the first half.",
            Self::Dominant => "Receivers near the dominant plane: first row in [-1, 1], second not negative.",
            Self::Units => "Rows that the limits of each sector are multiplied with.",
            Self::RayCorner => {
                "Direction through the image's upper left corner, depth 1, in the case's axes."
            }
            Self::RayAcross => "Change of that direction across the whole image.",
            Self::RayDown => "Change of that direction down the whole image.",
            Self::PerNear => "One over the near plane's depth in metres.",
            Self::InverseDepth => "One over the depth in metres = stored depth * x + y.",
        }
    }
}
