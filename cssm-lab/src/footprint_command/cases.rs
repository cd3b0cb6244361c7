//! The cases that are built in: every row of the reference that the house can make.

use cssm_core::case::{CaseError, LightCase, LightCaseBuilder, LightKind, Stretch};
use cssm_core::schema::{Value, Word};

use super::reference::{self, Reference};

/// Depth to which an infinite view is scored, in metres.
pub const HORIZON_METRES: f64 = 1e5;

/// A case with its reference.
#[derive(Debug, Clone)]
pub struct BuiltIn {
    /// Name in tables.
    pub name: String,
    /// The case.
    pub case: LightCase,
    /// What the prototype measured.
    pub reference: Reference,
}

/// Casters of stretched cases are decided pixel by pixel from this bound on.
const EXACT: Stretch = Stretch::Exact { bound_texels: 0.25 };

fn number(name: &'static str, value: f64) -> (&'static str, Value) {
    (name, Value::Number(value))
}

fn splits(count: u32, scheme: Word) -> LightCaseBuilder {
    let arguments = [("splits", Value::Count(count)), ("scheme", Value::Word(scheme))];
    LightCase::builder("Split").technique(Word::with("parallel_split", arguments))
}

fn warped_splits(warp: &'static str) -> LightCaseBuilder {
    let arguments = [
        ("splits", Value::Count(4)),
        ("scheme", Value::Word(Word::plain("logarithmic"))),
        ("warp", Value::Word(Word::plain(warp))),
    ];
    LightCase::builder("WarpedSplit").technique(Word::with("parallel_split", arguments))
}

fn rule(name: &'static str) -> (&'static str, Value) {
    ("rule", Value::Word(Word::plain(name)))
}

fn slide(focus_metres: Option<f64>) -> (&'static str, Value) {
    ("slide_back", focus_metres.map_or(Value::Word(Word::plain("none")), Value::Number))
}

fn log_scheme() -> (&'static str, Value) {
    ("scheme", Value::Word(Word::plain("logarithmic")))
}

fn one_plane(distribution: Word, stretch: Stretch) -> LightCaseBuilder {
    LightCase::builder("Plane").configurations(&["one_plane"]).distribution(distribution).stretch(stretch)
}

fn faces() -> LightCaseBuilder {
    LightCase::builder("Faces").configurations(&["face_columns"])
}

/// Logarithmic rows in columns of so many pieces.
fn logarithmic(folds: u32) -> Word {
    Word::with("logarithmic", [number("horizon", HORIZON_METRES), ("folds", Value::Count(folds))])
}

fn perspective(focus_metres: f64, folds: u32) -> Word {
    let arguments = [number("focus", focus_metres), number("share", 0.5), ("folds", Value::Count(folds))];
    Word::with("perspective", arguments)
}

/// One piece on either side of the focus.
fn two_segment(focus_metres: f64, share: f64) -> Word {
    let arguments = [
        number("focus", focus_metres),
        number("share", share),
        number("horizon", HORIZON_METRES),
        ("folds", Value::Count(2)),
    ];
    Word::with("two_segment", arguments)
}

fn four_plane(focus_metres: f64, push: &'static str) -> LightCaseBuilder {
    let arguments = [number("focus", focus_metres), ("push", Value::Word(Word::plain(push)))];
    LightCase::builder("FourPlane").configuration_words(vec![Word::with("four_plane", arguments)])
}

/// The directional cases, with square maps of so many texels a side or the same number in a long map. Techniques that
/// need finite receivers are bounded by `far_metres`; those with a focus have it at `focus_metres`.
///
/// # Errors
/// What a declaration says, which is a fault of this list.
pub fn directional(
    side: u32,
    far_metres: f64,
    near_metres: f64,
    focus_metres: f64,
) -> Result<Vec<BuiltIn>, Vec<CaseError>> {
    let bounded = |builder: LightCaseBuilder| builder.shadow_distance_metres(far_metres);
    let technique = |name: &'static str, arguments: Vec<(&'static str, Value)>| {
        bounded(LightCase::builder("Peer").technique(Word::with(name, arguments)))
    };
    let uniform = || Word::plain("uniform");
    let log = || Word::plain("logarithmic");
    let practical = Word::with("practical", [number("lambda", 0.5)]);
    let (square, long) = ((side, side), (side / 2, 2 * side));
    let row = |count: u32| {
        let tile = (f64::from(side) / f64::from(count).sqrt()).round() as u32;
        (count * tile, tile)
    };
    let focus = focus_metres;
    let rows = [
        (
            "standard",
            bounded(LightCase::builder("Standard").technique(Word::plain("standard"))),
            square,
            reference::STANDARD,
        ),
        ("bounding_box", technique("bounding_box", vec![]), square, reference::BOUNDING_BOX),
        (
            "trapezoidal",
            technique("trapezoidal", vec![number("focus", focus)]),
            square,
            reference::TRAPEZOIDAL,
        ),
        (
            "trapezoidal_focused",
            technique("trapezoidal", vec![rule("focused"), number("focus", focus)]),
            square,
            Reference::NONE,
        ),
        (
            "light_space_perspective",
            technique("light_space_perspective", vec![]),
            square,
            reference::LIGHT_SPACE_PERSPECTIVE,
        ),
        (
            "generalized_linear",
            technique("generalized_linear", vec![]),
            square,
            reference::GENERALIZED_LINEAR,
        ),
        ("perspective", technique("perspective", vec![slide(None)]), square, reference::PERSPECTIVE),
        (
            "perspective_slid",
            technique("perspective", vec![slide(Some(focus))]),
            square,
            reference::PERSPECTIVE_SLID,
        ),
        (
            "perspective_faces",
            technique("perspective", vec![slide(Some(focus))]).configurations(&["cube_faces"]),
            square,
            Reference::NONE,
        ),
        ("warp_family", technique("warp_family", vec![]), square, Reference::NONE),
        (
            "logarithmic_perspective",
            technique("logarithmic_perspective", vec![]).distribution(logarithmic(1)).stretch(EXACT),
            square,
            Reference::NONE,
        ),
        ("stable_cascades", technique("stable_cascades", vec![log_scheme()]), square, Reference::NONE),
        ("pssm4_log_warped", bounded(warped_splits("light_space_perspective")), square, Reference::NONE),
        ("pssm2_log", bounded(splits(2, log())), row(2), reference::SPLIT_2),
        ("pssm2_uniform", bounded(splits(2, uniform())), row(2), reference::general_p95(1305.0)),
        ("pssm3_log", bounded(splits(3, log())), row(3), reference::SPLIT_3),
        ("pssm3_uniform", bounded(splits(3, uniform())), row(3), reference::general_p95(1066.0)),
        ("pssm4_log", bounded(splits(4, log())), square, reference::SPLIT_4),
        ("pssm4_practical", bounded(splits(4, practical)), square, reference::SPLIT_4_PRACTICAL),
        ("pssm4_uniform", bounded(splits(4, uniform())), square, reference::general_p95(923.0)),
        ("one_plane", one_plane(perspective(focus, 1), Stretch::None), square, reference::ONE_PLANE),
        ("one_plane_8", one_plane(bands(8), Stretch::None), square, Reference::NONE),
        (
            "one_plane_stretched",
            one_plane(perspective(focus, 1), EXACT),
            square,
            reference::ONE_PLANE_STRETCHED,
        ),
        (
            "one_plane_stretched_long",
            one_plane(perspective(focus, 1), EXACT),
            long,
            reference::ONE_PLANE_STRETCHED_LONG,
        ),
        ("one_plane_stretched_folded", one_plane(perspective(focus, 4), EXACT), square, Reference::NONE),
        ("one_plane_log", one_plane(logarithmic(1), EXACT), square, reference::ONE_PLANE_LOGARITHMIC),
        ("one_plane_log_long", one_plane(logarithmic(1), EXACT), long, reference::ONE_PLANE_LOGARITHMIC_LONG),
        (
            "one_plane_log_folded",
            one_plane(logarithmic(8), EXACT),
            square,
            reference::ONE_PLANE_LOGARITHMIC_LONG,
        ),
        (
            "two_segment_50_long",
            one_plane(two_segment(focus, 0.5), EXACT),
            long,
            reference::general_p95(2.71),
        ),
        (
            "two_segment_65_long",
            one_plane(two_segment(focus, 0.65), EXACT),
            long,
            reference::general_p95(3.50),
        ),
        (
            "two_segment_80_long",
            one_plane(two_segment(focus, 0.8), EXACT),
            long,
            reference::general_p95(6.06),
        ),
        ("four_plane", four_plane(focus, "t"), square, reference::FOUR_PLANE),
        ("four_plane_near", four_plane(near_metres, "t"), square, reference::FOUR_PLANE_NEAR),
        ("four_plane_camera", four_plane(focus, "camera"), square, Reference::NONE),
        ("face_columns_log", faces().distribution(logarithmic(1)).stretch(EXACT), square, Reference::NONE),
        (
            "face_columns_log_folded",
            faces().distribution(logarithmic(8)).stretch(EXACT),
            square,
            reference::FACES_LOGARITHMIC,
        ),
        ("face_columns_8", faces().distribution(bands(8)), square, reference::FACES_8),
        ("face_columns_16", faces().distribution(bands(16)), square, reference::FACES_16),
    ];
    let built = |(name, builder, map, reference): (&str, LightCaseBuilder, (u32, u32), Reference)| {
        let case = builder.map_size_texels(map.0, map.1).build()?;
        Ok(BuiltIn { name: name.to_owned(), case, reference })
    };
    rows.into_iter().map(built).collect()
}

fn bands(count: u32) -> Word {
    Word::with("bands", [("count", Value::Count(count)), number("horizon", HORIZON_METRES)])
}

/// A case of one configuration under an omni light.
///
/// # Errors
/// As [`directional`].
pub fn omni(configuration: &str, map: (u32, u32), focus_metres: f64) -> Result<LightCase, Vec<CaseError>> {
    let lamp = || LightCase::builder("Lamp").light(LightKind::Omni).map_size_texels(map.0, map.1);
    let plain = |name| lamp().configurations(&[name]);
    let builder = match configuration {
        "face_columns" => plain("face_columns").distribution(logarithmic(8)).stretch(EXACT),
        "one_plane" => plain("one_plane").distribution(perspective(focus_metres, 1)).stretch(EXACT),
        "four_plane" => plain("four_plane"),
        "eight_plane" => plain("eight_plane"),
        "tetrahedron" => plain("tetrahedron"),
        _ => plain("cube"),
    };
    builder.build()
}
