//! The schema of a light case: every field with its default.

use super::filter::FILTERS;
use crate::distribution;
use crate::schema::{Choice, Default, Field, Kind, Unit};
use crate::technique;

/// Largest map side that a declaration may ask for.
pub const MAP_SIDE_LIMIT_TEXELS: u32 = 16384;

/// Largest number that a declaration may give to the first of the shadow bindings; WebGPU ends at 999.
const LAST_BINDING: u32 = 990;

const FAR: &[Choice] = &[
    Choice::plain("infinite", "the far plane may be at infinity"),
    Choice::plain("finite", "every view has a finite far plane"),
];

const MASK: &[Field] = &[
    Field {
        name: "depth",
        summary: "what the engine's depth texture holds",
        kind: Kind::Choice(&[
            Choice::plain("reversed_z", "1 at the near plane, 0 at infinity, in a depth texture"),
            Choice::plain("linear", "metres along the view axis in a single-channel float texture"),
        ]),
        default: Default::Value("reversed_z"),
    },
    Field {
        name: "normal",
        summary: "where the geometric normal comes from; a texture needs a bias that reads normals",
        kind: Kind::Choice(&[
            Choice::plain("reconstructed", "from neighbouring depths"),
            Choice::plain("texture", "unit normals in the case's axes in a float texture"),
        ]),
        default: Default::Value("reconstructed"),
    },
];

/// Every field of a light case, in the order of the reference page.
pub const FIELDS: &[Field] = &[
    Field {
        name: "light",
        summary: "kind of light",
        kind: Kind::Choice(&[
            Choice::plain("directional", "parallel rays, such as the sun's"),
            Choice::plain("spot", "rays from a point within a cone"),
            Choice::plain("omni", "rays from a point to all sides"),
        ]),
        default: Default::Value("directional"),
    },
    Field {
        name: "view",
        summary: "views that the case serves",
        kind: Kind::Choice(&[Choice {
            name: "perspective",
            summary: "any perspective projection: off-centre, jittered, reversed-z, either handedness",
            arguments: &[Field {
                name: "far",
                summary: "how far views reach",
                kind: Kind::Choice(FAR),
                default: Default::Value("infinite"),
            }],
        }]),
        default: Default::Value("perspective { far: infinite }"),
    },
    Field {
        name: "shadow_distance",
        summary: "farthest receiver depth along the view axis",
        kind: Kind::Number { min: 0.0, max: f64::INFINITY, open: true, unit: Unit::Length },
        default: Default::Absent("receivers reach to the view's far plane"),
    },
    Field {
        name: "bounds",
        summary: "bounds of the receivers that every plan is given",
        kind: Kind::Choice(&[
            Choice::plain("none", "plans may be made without bounds"),
            Choice::plain("scene", "every plan is given finite scene bounds"),
        ]),
        default: Default::Value("none"),
    },
    Field {
        name: "technique",
        summary: "how facets are chosen",
        kind: Kind::Choice(technique::CHOICES),
        default: Default::Value("camera_space"),
    },
    Field {
        name: "configurations",
        summary: "geometric situations that may occur, best first",
        kind: Kind::ChoiceList(technique::CONFIGURATIONS),
        default: Default::Absent("those of the technique that serve every position of the light"),
    },
    Field {
        name: "distribution",
        summary: "how map rows are spent over depth",
        kind: Kind::Choice(distribution::CHOICES),
        default: Default::Absent("`bands(8)` where a declared configuration takes one, nothing elsewhere"),
    },
    Field {
        name: "stretch",
        summary: "how casters are drawn where the distribution bends rows",
        kind: Kind::Choice(&[
            Choice::plain("none", "rows are not bent: every facet is a homography"),
            Choice::plain(
                "vertex",
                "only triangle corners are bent; fast, wrong for triangles that span many rows",
            ),
            Choice {
                name: "exact",
                summary: "triangles that straight edges would miss by more than the bound are decided per pixel",
                arguments: &[Field {
                    name: "bound",
                    summary: "the bound",
                    kind: Kind::Number { min: 0.0, max: 64.0, open: false, unit: Unit::Texels },
                    default: Default::Value("0.25 texels"),
                }],
            },
        ]),
        default: Default::Absent("`exact` where the distribution needs bent rows, `none` elsewhere"),
    },
    Field {
        name: "dominant_plane",
        summary: "facet of its own for receivers near a plane that plans are given: one texel for each pixel",
        kind: Kind::Choice(&[
            Choice::plain("none", "no plane is set apart"),
            Choice {
                name: "share",
                summary: "a share of the map",
                arguments: &[
                    Field {
                        name: "share",
                        summary: "the share",
                        kind: Kind::Number { min: 0.0, max: 0.9, open: true, unit: Unit::None },
                        default: Default::Value("0.25"),
                    },
                    Field {
                        name: "thickness",
                        summary: "distance from the plane within which receivers count as on it",
                        kind: Kind::Number { min: 0.0, max: 1e6, open: true, unit: Unit::Length },
                        default: Default::Value("1 m"),
                    },
                ],
            },
        ]),
        default: Default::Value("none"),
    },
    Field {
        name: "fit",
        summary: "what facets are fitted to beside the view, as far as a plan is given it",
        kind: Kind::Choice(&[
            Choice::plain("none", "the view and the scene's bounds alone"),
            Choice::plain(
                "bounds",
                "also bounding volumes of what is visible this frame, and of the casters",
            ),
            Choice::plain("depth_min_max", "also the smallest and the largest visible depth"),
            Choice::plain("histogram", "also how many pixels see each depth"),
        ]),
        default: Default::Value("none"),
    },
    Field {
        name: "stability",
        summary: "how texels are kept where they are while the camera moves",
        kind: Kind::Choice(&[
            Choice::plain("none", "every plan fits its view as well as it can"),
            Choice::plain(
                "snapped",
                "linear facets keep texels of one size on a lattice that is fixed in the world",
            ),
            Choice {
                name: "quantised",
                summary: "plans are made for the nearest of a lattice of views, wide enough for all views near it",
                arguments: &[
                    Field {
                        name: "move",
                        summary: "pitch of the lattice of eyes",
                        kind: Kind::Number { min: 0.0, max: 1e6, open: false, unit: Unit::Length },
                        default: Default::Value("25 cm"),
                    },
                    Field {
                        name: "turn",
                        summary: "pitch of the lattice of orientations",
                        kind: Kind::Number { min: 0.0, max: 45.0, open: false, unit: Unit::Degrees },
                        default: Default::Value("0.5 deg"),
                    },
                ],
            },
        ]),
        default: Default::Value("none"),
    },
    Field {
        name: "map",
        summary: "size, folding, format and gutters of the map",
        kind: Kind::Group(&[
            Field {
                name: "size",
                summary: "width x height of the whole map",
                kind: Kind::Size { min: 64, max: MAP_SIDE_LIMIT_TEXELS },
                default: Default::Value("2048 x 2048"),
            },
            Field {
                name: "columns",
                summary: "number of strips the tiles are folded into",
                kind: Kind::AutoOrCount { min: 1, max: 32 },
                default: Default::Value("auto"),
            },
            Field {
                name: "format",
                summary: "texel format",
                kind: Kind::Choice(&[
                    Choice::plain("depth32float", "32-bit float"),
                    Choice::plain("depth16unorm", "16-bit unsigned normalised"),
                ]),
                default: Default::Value("depth32float"),
            },
            Field {
                name: "gutter",
                summary: "texels around every tile that only filter taps read; auto: filter radius + 1",
                kind: Kind::AutoOrCount { min: 0, max: 16 },
                default: Default::Value("auto"),
            },
        ]),
        default: Default::Value("{ size: 2048 x 2048, columns: auto, format: depth32float, gutter: auto }"),
    },
    Field {
        name: "filter",
        summary: "how texels become visibility",
        kind: Kind::Choice(FILTERS),
        default: Default::Value("gather_2x2"),
    },
    Field {
        name: "bias",
        summary: "how the reference is kept off the receiver's own texels",
        kind: Kind::Choice(&[
            Choice::plain("none", "no bias"),
            Choice {
                name: "constant",
                summary: "a constant distance along the light",
                arguments: &[Field {
                    name: "along_light",
                    summary: "the distance",
                    kind: Kind::Number { min: 0.0, max: 1e3, open: false, unit: Unit::Length },
                    default: Default::Value("5 cm"),
                }],
            },
            Choice {
                name: "slope",
                summary: "local texel times the tangent of the angle between normal and light",
                arguments: &[Field {
                    name: "scale",
                    summary: "multiple of the local texel",
                    kind: Kind::Number { min: 0.0, max: 64.0, open: false, unit: Unit::Texels },
                    default: Default::Value("1.5 texels"),
                }],
            },
            Choice {
                name: "world_texel",
                summary: "a distance plus a multiple of the local texel",
                arguments: &[
                    Field {
                        name: "a",
                        summary: "constant part along the light",
                        kind: Kind::Number { min: 0.0, max: 1e3, open: false, unit: Unit::Length },
                        default: Default::Value("1 cm"),
                    },
                    Field {
                        name: "b",
                        summary: "part that scales with the local texel",
                        kind: Kind::Number { min: 0.0, max: 64.0, open: false, unit: Unit::Texels },
                        default: Default::Value("1.5 texels"),
                    },
                ],
            },
            Choice::plain("receiver_plane", "exact plane of the receiver in its facet; no knob"),
        ]),
        default: Default::Value("receiver_plane"),
    },
    Field {
        name: "casters",
        summary: "what the engine's casters are",
        kind: Kind::Choice(&[
            Choice::plain("opaque", "triangles alone"),
            Choice::plain("alpha_tested", "triangles, some cut out by the alpha channel of a texture"),
        ]),
        default: Default::Value("opaque"),
    },
    Field {
        name: "axes",
        summary: "axes of positions and normals in the resolve shaders, relative to the eye",
        kind: Kind::Choice(&[
            Choice::plain("camera", "x right, y up, looking along -z: exact at any field of view"),
            Choice::plain("world", "the world's: a tenth of a texel is lost at a field of view of 1 degree"),
        ]),
        default: Default::Value("camera"),
    },
    Field {
        name: "resolve",
        summary: "interfaces that the shaders offer",
        kind: Kind::ChoiceList(&[
            Choice { name: "mask", summary: "a screen-space visibility pass", arguments: MASK },
            Choice {
                name: "function",
                summary: "a WGSL function for the engine's own materials",
                arguments: &[
                    Field {
                        name: "group",
                        summary: "bind group number of the shadow bindings",
                        kind: Kind::Count { min: 0, max: 3 },
                        default: Default::Value("2"),
                    },
                    Field {
                        name: "first_binding",
                        summary: "number of the first of them, where the group holds bindings of the engine's too",
                        kind: Kind::Count { min: 0, max: LAST_BINDING },
                        default: Default::Value("0"),
                    },
                ],
            },
        ]),
        default: Default::Value("[mask, function { group: 2 }]"),
    },
    Field {
        name: "prefix",
        summary: "prefix of every emitted shader name, lower snake case, no digit at its end",
        kind: Kind::Prefix,
        default: Default::Absent("the case's name in snake case"),
    },
];
