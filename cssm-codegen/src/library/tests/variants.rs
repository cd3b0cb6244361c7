//! Cases that together take every alternative of every slot.

use cssm_core::LightCase;
use cssm_core::case::{
    Axes, Bias, CaseError, Casters, DominantPlane, Filter, Fit, Kernel, LightCaseBuilder, LightKind,
    MaskDepth, MaskNormal, PcfSize, Resolve, Source, Stretch,
};
use cssm_core::schema::Word;
use cssm_core::table::CaseTable;

/// A case and its table.
pub(super) struct Variant {
    pub(super) case: LightCase,
    pub(super) table: CaseTable,
}

impl Variant {
    fn of(case: LightCase) -> Self {
        Self { table: CaseTable::describe(&case), case }
    }
}

/// Cases that together take every alternative of every slot.
pub(super) fn variants() -> Vec<Variant> {
    let mut variants: Vec<_> = resolve_cases().into_iter().map(Variant::of).collect();
    variants.extend(["face_columns", "four_plane"].map(tested));
    variants.extend(exact());
    variants
}

/// A tested case with one configuration.
pub(super) fn tested(configuration: &'static str) -> Variant {
    let case = LightCase::builder("Sun").casters(Casters::AlphaTested);
    Variant::of(case.configurations(&[configuration]).build().unwrap())
}

/// Cases that decide casters texel by texel, in every way.
fn exact() -> Vec<Variant> {
    let case = |distribution, configurations: &[&'static str]| {
        let case = LightCase::builder("Sun").casters(Casters::AlphaTested).configurations(configurations);
        case.distribution(Word::plain(distribution)).stretch(Stretch::Exact { bound_texels: 0.25 }).build()
    };
    let configurations = [&["one_plane"][..], &["one_plane", "four_plane"]];
    let all = configurations.into_iter().flat_map(|configurations| {
        ["perspective", "two_segment"].map(|distribution| case(distribution, configurations))
    });
    all.map(|case| Variant::of(case.unwrap())).collect()
}

/// Cases that together take every alternative of the slots of resolving.
fn resolve_cases() -> Vec<LightCase> {
    let biases = [
        Bias::None,
        Bias::Constant { along_light_metres: 0.05 },
        Bias::Slope { texels: 1.5 },
        Bias::WorldTexel { a_metres: 0.01, b_texels: 1.5 },
        Bias::ReceiverPlane,
    ];
    let moments = Filter::Evsm2 { exponent: 20.0, blur_texels: 2, bleeding: 0.1 };
    let masks = Filter::GroundMasks { planes: 3, blur_metres: 0.2, reach_texels: 8 };
    let narrow = [Filter::None, Filter::Hardware2x2, Filter::Gather2x2, moments, masks];
    let mut cases = Vec::new();
    for bias in biases {
        let case = |light| LightCase::builder("Reference").light(light).bias(bias);
        cases.extend(local_and_bent(&case));
        cases.extend(local_and_bent(&|light| case(light).filter(masks)));
        for index in 0..WIDE_FILTERS {
            let case = |light| case(light).filter(wide_filters(light)[index]);
            let directional = || case(LightKind::Directional);
            cases.extend(local_and_bent(&case));
            cases.push(directional().axes(Axes::World).build());
            cases.push(
                directional().shadow_distance_metres(1000.0).technique(Word::plain("standard")).build(),
            );
        }
        for filter in narrow {
            let normals = match bias.reads_normal() {
                true => &[MaskNormal::Reconstructed, MaskNormal::Texture][..],
                false => &[MaskNormal::Reconstructed],
            };
            for (normal, depth) in normals
                .iter()
                .flat_map(|normal| [MaskDepth::ReversedZ, MaskDepth::Linear].map(|depth| (*normal, depth)))
            {
                let interfaces =
                    [Resolve::Mask { depth, normal }, Resolve::Function { group: 3, first_binding: 0 }];
                let case = || LightCase::builder("Reference").bias(bias).filter(filter).resolve(&interfaces);
                let bounded = || case().shadow_distance_metres(1000.0);
                cases.push(case().build());
                cases.push(case().bands(1, 1e5).fit(Fit::Histogram).build());
                cases.push(bounded().technique(Word::plain("standard")).build());
                cases.push(bounded().technique(Word::plain("parallel_split")).build());
            }
        }
    }
    cases.into_iter().collect::<Result<_, _>>().unwrap()
}

/// How many of [`wide_filters`] there are.
const WIDE_FILTERS: usize = 4;

/// Filters that find the width of their kernel, one for each way to find it.
fn wide_filters(light: LightKind) -> [Filter; WIDE_FILTERS] {
    let source = if light.is_local() { Source::Radius(0.05) } else { Source::Angle(0.53) };
    [
        Filter::Pcf { size: PcfSize::Three, kernel: Kernel::Texels },
        Filter::Pcf { size: PcfSize::Five, kernel: Kernel::Metres(0.05) },
        Filter::Pcf { size: PcfSize::Seven, kernel: Kernel::Pixels(3.0) },
        Filter::Pcss { source, reach_texels: 5 },
    ]
}

/// Local lights, bent rows and dominant planes, in every way that the shaders tell apart.
fn local_and_bent(of: &dyn Fn(LightKind) -> LightCaseBuilder) -> Vec<Result<LightCase, Vec<CaseError>>> {
    let stretch = Stretch::Exact { bound_texels: 0.25 };
    let plane = DominantPlane { share: 0.25, thickness_metres: 1.0 };
    let case = || of(LightKind::Directional);
    let omni = || of(LightKind::Omni);
    let bent = |case: LightCaseBuilder, distribution: &'static str| {
        case.configurations(&["one_plane"]).distribution(Word::plain(distribution)).stretch(stretch)
    };
    vec![
        omni().build(),
        omni().dominant_plane(plane).build(),
        omni().configurations(&["one_plane"]).build(),
        omni().configurations(&["four_plane"]).build(),
        of(LightKind::Spot).configurations(&["light_projection"]).build(),
        bent(case(), "perspective").build(),
        bent(case(), "perspective").dominant_plane(plane).build(),
        bent(case(), "logarithmic").dominant_plane(plane).build(),
        bent(case(), "perspective").stretch(Stretch::Vertex).build(),
        bent(omni(), "perspective").build(),
        bent(omni(), "two_segment").stretch(Stretch::Vertex).build(),
        case().configurations(&["four_plane"]).dominant_plane(plane).build(),
    ]
}
