//! Numbers that shaders are specialised for: all that depends on the declaration but is no layout.

use std::borrow::Cow;

/// A number that the shaders are specialised for; a shader declares those it uses.
#[derive(Debug, Clone, PartialEq)]
pub struct Constant {
    /// What it is.
    pub kind: ConstantKind,
    /// Shader name, prefix included: `SUN_MAP_SIZE`.
    pub name: Cow<'static, str>,
    /// Its value.
    pub value: ConstantValue,
}

/// The constants a case can have.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ConstantKind {
    /// Width and height of the map in texels.
    MapSize,
    /// Gathers along each axis of filters that read a fixed square of texels.
    Gathers,
    /// Half the widest kernel of the filter, texels.
    WidestKernel,
    /// Half the width of the filter's kernel, metres across the light.
    KernelMetres,
    /// Half the width of the filter's kernel, screen pixels.
    KernelPixels,
    /// Exponent over a facet's whole depth.
    Exponent,
    /// Texels to either side that the prefilter blurs over.
    Blur,
    /// Standard deviation of the prefilter's blur in metres.
    BlurMetres,
    /// Planes with masks of their own.
    GroundPlanes,
    /// Share of light below which a receiver counts as dark.
    Bleeding,
    /// Radius of the light: at a metre's distance for a directional light, in metres for a local one.
    LightRadius,
    /// Sectors around the eye.
    Sectors,
    /// Bands in each sector.
    Bands,
    /// Vectors of four thresholds in each sector.
    ThresholdVectors,
    /// Cell of the receivers near the dominant plane.
    Dominant,
    /// Bias `constant`: metres along the light.
    BiasMetres,
    /// Bias `slope`: multiple of the local texel.
    BiasTexels,
    /// Bias `world_texel`: metres along the light.
    BiasAMetres,
    /// Bias `world_texel`: multiple of the local texel.
    BiasBTexels,
    /// Stretching `exact`: texels along the rows that edges of casters may be off.
    StretchBound,
}

impl ConstantKind {
    /// Name in the shader library, without a prefix.
    pub const fn name(self) -> &'static str {
        match self {
            Self::MapSize => "MAP_SIZE",
            Self::Gathers => "GATHERS",
            Self::WidestKernel => "WIDEST_KERNEL",
            Self::KernelMetres => "KERNEL_METRES",
            Self::KernelPixels => "KERNEL_PIXELS",
            Self::Exponent => "EXPONENT",
            Self::Blur => "BLUR",
            Self::BlurMetres => "BLUR_METRES",
            Self::GroundPlanes => "GROUND_PLANES",
            Self::Bleeding => "BLEEDING",
            Self::LightRadius => "LIGHT_RADIUS",
            Self::Sectors => "SECTORS",
            Self::Bands => "BANDS",
            Self::ThresholdVectors => "THRESHOLD_VECTORS",
            Self::Dominant => "DOMINANT",
            Self::BiasMetres => "BIAS_METRES",
            Self::BiasTexels => "BIAS_TEXELS",
            Self::BiasAMetres => "BIAS_A_METRES",
            Self::BiasBTexels => "BIAS_B_TEXELS",
            Self::StretchBound => "STRETCH_BOUND",
        }
    }

    /// One sentence for the comments of shaders and tables.
    pub const fn summary(self) -> &'static str {
        match self {
            Self::MapSize => "Width and height of the map in texels.",
            Self::Gathers => "Gathers along each axis.",
            Self::WidestKernel => "Half the widest kernel in texels.",
            Self::KernelMetres => "Half the width of the kernel, metres across the light.",
            Self::KernelPixels => "Half the width of the kernel in screen pixels.",
            Self::Exponent => "Exponent over a facet's whole depth.",
            Self::Blur => "Texels to either side that the prefilter blurs over.",
            Self::BlurMetres => "Standard deviation of the blur in metres on the plane.",
            Self::GroundPlanes => "Planes with masks of their own.",
            Self::Bleeding => "Share of light below which a receiver counts as dark.",
            Self::LightRadius => {
                "Radius of the light: at a metre's distance for a directional light, in metres for a local one."
            }
            Self::Sectors => "Sectors around the eye.",
            Self::Bands => "Bands of distance in each sector.",
            Self::ThresholdVectors => "Vectors of four band limits in each sector.",
            Self::Dominant => "Place of the facet near the dominant plane.",
            Self::BiasMetres => "Bias along the light in metres.",
            Self::BiasTexels => "Bias as a multiple of the local texel and the tangent of the light's angle.",
            Self::BiasAMetres => "Constant part of the bias, metres along the light.",
            Self::BiasBTexels => "Part of the bias that scales with the local texel, in texels.",
            Self::StretchBound => "Texels along the rows that edges of casters may be off.",
        }
    }
}

/// Value of a constant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ConstantValue {
    /// `u32`
    U32(u32),
    /// `f32`
    F32(f32),
    /// `vec2<f32>`
    Vec2([f32; 2]),
}
