//! Between a light case and the arguments of its declaration, both ways.

use super::{
    Axes, Bias, Casters, DepthFormat, DominantPlane, FarKind, Fit, LightCase, LightKind, MapSpec, MaskDepth,
    MaskNormal, Resolve, Stability, Stretch,
};
use crate::schema::{Arguments, Value, Word};

impl LightCase {
    /// The complete declaration of this case: every field of [`super::FIELDS`] that holds something, in order.
    /// [`LightCase::from_arguments`] makes the same case of it.
    pub fn to_arguments(&self) -> Arguments {
        let auto_or = |count: Option<u32>| match count {
            Some(count) => Value::Count(count),
            None => Value::Word(Word::plain("auto")),
        };
        let map = Arguments(vec![
            ("size", Value::Size(self.map.width, self.map.height)),
            ("columns", auto_or(self.map.columns)),
            ("format", Value::Word(Word::plain(self.map.format.name()))),
            ("gutter", auto_or(self.map.gutter)),
        ]);
        let bounds = if self.scene_bounds { "scene" } else { "none" };
        let fields = [
            ("light", Some(Value::Word(Word::plain(self.light.name())))),
            ("view", Some(Value::Word(self.far.view_word()))),
            ("shadow_distance", self.shadow_distance_metres.map(Value::Number)),
            ("bounds", Some(Value::Word(Word::plain(bounds)))),
            ("technique", Some(Value::Word(self.technique.clone()))),
            ("configurations", Some(Value::Words(self.configurations.clone()))),
            ("distribution", self.distribution.clone().map(Value::Word)),
            ("stretch", Some(Value::Word(self.stretch.word()))),
            ("dominant_plane", Some(Value::Word(DominantPlane::word(self.dominant_plane)))),
            ("fit", Some(Value::Word(Word::plain(self.fit.name())))),
            ("stability", Some(Value::Word(self.stability.word()))),
            ("map", Some(Value::Group(map))),
            ("filter", Some(Value::Word(self.filter.word()))),
            ("bias", Some(Value::Word(self.bias.word()))),
            ("casters", Some(Value::Word(Word::plain(self.casters.name())))),
            ("axes", Some(Value::Word(Word::plain(self.axes.name())))),
            ("resolve", Some(Value::Words(self.resolve.iter().map(Resolve::word).collect()))),
            ("prefix", Some(Value::Name(self.prefix.clone()))),
        ];
        Arguments(fields.into_iter().filter_map(|(name, value)| Some((name, value?))).collect())
    }
}

impl FarKind {
    pub(super) fn view_word(self) -> Word {
        let far = match self {
            Self::Infinite => "infinite",
            Self::Finite => "finite",
        };
        Word::with("perspective", [("far", Value::Word(Word::plain(far)))])
    }

    pub(super) fn of_view(view: Option<&Word>) -> Self {
        match view.and_then(|view| view.arguments.word("far")).map(|far| far.name) {
            Some("finite") => Self::Finite,
            _ => Self::Infinite,
        }
    }
}

impl LightKind {
    pub(super) fn of_word(word: Option<&Word>) -> Self {
        match word.map(|word| word.name) {
            Some("spot") => Self::Spot,
            Some("omni") => Self::Omni,
            _ => Self::Directional,
        }
    }
}

impl Stretch {
    pub(super) fn word(self) -> Word {
        match self {
            Self::None => Word::plain("none"),
            Self::Vertex => Word::plain("vertex"),
            Self::Exact { bound_texels } => Word::with("exact", [("bound", Value::Number(bound_texels))]),
        }
    }

    /// Reads a word whose defaults are filled in.
    pub(super) fn of_word(word: &Word) -> Self {
        match word.name {
            "vertex" => Self::Vertex,
            "exact" => Self::Exact { bound_texels: word.arguments.number("bound").unwrap_or(DEFAULT_BOUND) },
            _ => Self::None,
        }
    }
}

/// Bound of exact stretching where a declaration holds none, texels.
pub(super) const DEFAULT_BOUND: f64 = 0.25;

impl DominantPlane {
    pub(super) fn word(plane: Option<Self>) -> Word {
        let Some(Self { share, thickness_metres }) = plane else { return Word::plain("none") };
        let arguments = [("share", Value::Number(share)), ("thickness", Value::Number(thickness_metres))];
        Word::with("share", arguments)
    }

    /// Reads a word whose defaults are filled in.
    pub(super) fn of_word(word: Option<&Word>) -> Option<Self> {
        let word = word.filter(|word| word.name == "share")?;
        let number = |name: &str| word.arguments.number(name);
        Some(Self { share: number("share")?, thickness_metres: number("thickness")? })
    }
}

impl Fit {
    pub(super) fn of_word(word: Option<&Word>) -> Self {
        match word.map(|word| word.name) {
            Some("bounds") => Self::Bounds,
            Some("depth_min_max") => Self::DepthMinMax,
            Some("histogram") => Self::Histogram,
            _ => Self::None,
        }
    }
}

impl Stability {
    pub(super) fn word(self) -> Word {
        match self {
            Self::None | Self::Snapped => Word::plain(self.name()),
            Self::Quantised { move_metres, turn_degrees } => Word::with(
                self.name(),
                [("move", Value::Number(move_metres)), ("turn", Value::Number(turn_degrees))],
            ),
        }
    }

    /// Reads a word whose defaults are filled in.
    pub(super) fn of_word(word: Option<&Word>) -> Self {
        let Some(word) = word else { return Self::None };
        let number = |name: &str| word.arguments.number(name).unwrap_or(0.0);
        match word.name {
            "snapped" => Self::Snapped,
            "quantised" => Self::Quantised { move_metres: number("move"), turn_degrees: number("turn") },
            _ => Self::None,
        }
    }
}

impl Casters {
    pub(super) fn of_word(word: Option<&Word>) -> Self {
        match word.map(|word| word.name) {
            Some("alpha_tested") => Self::AlphaTested,
            _ => Self::Opaque,
        }
    }
}

impl Axes {
    pub(super) fn of_word(word: Option<&Word>) -> Self {
        match word.map(|word| word.name) {
            Some("world") => Self::World,
            _ => Self::Camera,
        }
    }
}

impl Bias {
    pub(super) fn word(self) -> Word {
        let arguments = match self {
            Self::None | Self::ReceiverPlane => vec![],
            Self::Constant { along_light_metres } => vec![("along_light", Value::Number(along_light_metres))],
            Self::Slope { texels } => vec![("scale", Value::Number(texels))],
            Self::WorldTexel { a_metres, b_texels } => {
                vec![("a", Value::Number(a_metres)), ("b", Value::Number(b_texels))]
            }
        };
        Word::with(self.name(), arguments)
    }

    /// Reads a word whose defaults are filled in.
    pub(super) fn of_word(word: Option<&Word>) -> Self {
        let Some(word) = word else {
            return Self::ReceiverPlane;
        };
        let number = |name: &str| word.arguments.number(name).unwrap_or(0.0);
        match word.name {
            "none" => Self::None,
            "constant" => Self::Constant { along_light_metres: number("along_light") },
            "slope" => Self::Slope { texels: number("scale") },
            "world_texel" => Self::WorldTexel { a_metres: number("a"), b_texels: number("b") },
            _ => Self::ReceiverPlane,
        }
    }

    /// Whether the reference depends on the geometric normal.
    pub const fn reads_normal(self) -> bool {
        matches!(self, Self::Slope { .. } | Self::ReceiverPlane)
    }
}

impl Resolve {
    pub(super) fn word(&self) -> Word {
        match self {
            Self::Mask { depth, normal } => {
                let depth = match depth {
                    MaskDepth::ReversedZ => "reversed_z",
                    MaskDepth::Linear => "linear",
                };
                let normal = match normal {
                    MaskNormal::Reconstructed => "reconstructed",
                    MaskNormal::Texture => "texture",
                };
                let plain = |name| Value::Word(Word::plain(name));
                Word::with("mask", [("depth", plain(depth)), ("normal", plain(normal))])
            }
            Self::Function { group, first_binding } => {
                let numbers =
                    [("group", Value::Count(*group)), ("first_binding", Value::Count(*first_binding))];
                Word::with("function", numbers)
            }
        }
    }

    /// Reads a word whose defaults are filled in.
    pub(super) fn of_word(word: &Word) -> Self {
        if word.name == "function" {
            let number = |name: &str| word.arguments.count(name).unwrap_or(0);
            return Self::Function { group: number("group"), first_binding: number("first_binding") };
        }
        let name = |field: &str| word.arguments.word(field).map(|word| word.name);
        Self::Mask {
            depth: match name("depth") {
                Some("linear") => MaskDepth::Linear,
                _ => MaskDepth::ReversedZ,
            },
            normal: match name("normal") {
                Some("texture") => MaskNormal::Texture,
                _ => MaskNormal::Reconstructed,
            },
        }
    }
}

impl MapSpec {
    /// Reads a group whose defaults are filled in.
    pub(super) fn of_group(map: Option<&Arguments>) -> Self {
        let (width, height) = match map.and_then(|map| map.get("size")) {
            Some(Value::Size(width, height)) => (*width, *height),
            _ => (0, 0),
        };
        let format = match map.and_then(|map| map.word("format")).map(|word| word.name) {
            Some("depth16unorm") => DepthFormat::Depth16Unorm,
            _ => DepthFormat::Depth32Float,
        };
        let count = |name: &str| map.and_then(|map| map.count(name));
        Self { width, height, columns: count("columns"), format, gutter: count("gutter") }
    }
}
