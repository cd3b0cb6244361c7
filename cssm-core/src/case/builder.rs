//! The Rust door to a light case.

use super::{
    Axes, Bias, CaseError, Casters, DepthFormat, DominantPlane, FarKind, Filter, Fit, LightCase, LightKind,
    Resolve, Stability, Stretch,
};
use crate::schema::{Arguments, Value, Word};

/// A declaration in Rust; every field has the default of the text grammar.
#[derive(Debug, Clone)]
pub struct LightCaseBuilder {
    name: String,
    doc: String,
    public: bool,
    fields: Vec<(&'static str, Value)>,
    map: Vec<(&'static str, Value)>,
}

impl LightCaseBuilder {
    pub(super) fn new(name: &str) -> Self {
        Self { name: name.into(), doc: String::new(), public: true, fields: Vec::new(), map: Vec::new() }
    }

    /// Doc comment.
    pub fn doc(mut self, doc: &str) -> Self {
        self.doc = doc.into();
        self
    }

    /// Whether the generated Rust items are `pub`; they are unless this says otherwise.
    pub fn public(mut self, public: bool) -> Self {
        self.public = public;
        self
    }

    /// Kind of light.
    pub fn light(self, light: LightKind) -> Self {
        self.set("light", Value::Word(Word::plain(light.name())))
    }

    /// How far views reach.
    pub fn far(self, far: FarKind) -> Self {
        self.set("view", Value::Word(far.view_word()))
    }

    /// Farthest receiver depth in metres.
    pub fn shadow_distance_metres(self, metres: f64) -> Self {
        self.set("shadow_distance", Value::Number(metres))
    }

    /// Promises that every plan is given finite scene bounds.
    pub fn scene_bounds(self, promised: bool) -> Self {
        self.set("bounds", Value::Word(Word::plain(if promised { "scene" } else { "none" })))
    }

    /// The technique and its parameters, such as `Word::plain("camera_space")`; parameters left out take their
    /// defaults.
    pub fn technique(self, technique: Word) -> Self {
        self.set("technique", Value::Word(technique))
    }

    /// Configurations that may occur, best first; their parameters take their defaults.
    pub fn configurations(self, names: &[&'static str]) -> Self {
        self.configuration_words(names.iter().map(|name| Word::plain(name)).collect())
    }

    /// Configurations that may occur with parameters, best first.
    pub fn configuration_words(self, words: Vec<Word>) -> Self {
        self.set("configurations", Value::Words(words))
    }

    /// How rows are spent over depth, such as `Word::plain("perspective")`; parameters left out take their defaults.
    pub fn distribution(self, distribution: Word) -> Self {
        self.set("distribution", Value::Word(distribution))
    }

    /// Distribution `bands(count)`, with the declared horizon for infinite far planes.
    pub fn bands(self, count: u32, horizon_metres: f64) -> Self {
        let arguments = [("count", Value::Count(count)), ("horizon", Value::Number(horizon_metres))];
        self.set("distribution", Value::Word(Word::with("bands", arguments)))
    }

    /// How casters are drawn where the distribution bends rows.
    pub fn stretch(self, stretch: Stretch) -> Self {
        self.set("stretch", Value::Word(stretch.word()))
    }

    /// A facet of its own for receivers near a plane.
    pub fn dominant_plane(self, plane: DominantPlane) -> Self {
        self.set("dominant_plane", Value::Word(DominantPlane::word(Some(plane))))
    }

    /// What facets are fitted to beside the view.
    pub fn fit(self, fit: Fit) -> Self {
        self.set("fit", Value::Word(Word::plain(fit.name())))
    }

    /// How texels are kept where they are while the camera moves.
    pub fn stability(self, stability: Stability) -> Self {
        self.set("stability", Value::Word(stability.word()))
    }

    /// Size of the whole map in texels.
    pub fn map_size_texels(self, width: u32, height: u32) -> Self {
        self.set_map("size", Value::Size(width, height))
    }

    /// Number of strips the tiles are folded into.
    pub fn map_columns(self, columns: u32) -> Self {
        self.set_map("columns", Value::Count(columns))
    }

    /// Texel format.
    pub fn map_format(self, format: DepthFormat) -> Self {
        self.set_map("format", Value::Word(Word::plain(format.name())))
    }

    /// Gutter of every tile in texels.
    pub fn map_gutter_texels(self, gutter: u32) -> Self {
        self.set_map("gutter", Value::Count(gutter))
    }

    /// How texels become visibility.
    pub fn filter(self, filter: Filter) -> Self {
        self.set("filter", Value::Word(filter.word()))
    }

    /// How bias is found.
    pub fn bias(self, bias: Bias) -> Self {
        self.set("bias", Value::Word(bias.word()))
    }

    /// What the engine's casters are.
    pub fn casters(self, casters: Casters) -> Self {
        self.set("casters", Value::Word(Word::plain(casters.name())))
    }

    /// Axes in which the resolve shaders take positions and normals.
    pub fn axes(self, axes: Axes) -> Self {
        self.set("axes", Value::Word(Word::plain(axes.name())))
    }

    /// Interfaces that the shaders offer.
    pub fn resolve(self, interfaces: &[Resolve]) -> Self {
        let words = interfaces.iter().map(|interface| interface.word()).collect();
        self.set("resolve", Value::Words(words))
    }

    /// Prefix of every emitted shader name.
    pub fn prefix(self, prefix: &str) -> Self {
        self.set("prefix", Value::Name(prefix.into()))
    }

    /// Checks the declaration.
    ///
    /// # Errors
    /// All field errors at once.
    pub fn build(mut self) -> Result<LightCase, Vec<CaseError>> {
        if !self.map.is_empty() {
            self.fields.push(("map", Value::Group(Arguments(self.map))));
        }
        LightCase::from_arguments(&self.name, &self.doc, self.public, &Arguments(self.fields))
    }

    fn set(mut self, field: &'static str, value: Value) -> Self {
        self.fields.retain(|(name, _)| *name != field);
        self.fields.push((field, value));
        self
    }

    fn set_map(mut self, field: &'static str, value: Value) -> Self {
        self.map.retain(|(name, _)| *name != field);
        self.map.push((field, value));
        self
    }
}
