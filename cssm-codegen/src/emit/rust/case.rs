//! The declaration as a Rust value: what was checked when the module was generated needs no check when it runs.

use cssm_core::LightCase;
use cssm_core::case::{Bias, DominantPlane, Filter, Kernel, MapSpec, Resolve, Source, Stability};
use cssm_core::schema::{Arguments, Value, Word};
use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::table::stretch_value;
use super::{doc, number, variant};

/// The function that returns the case.
pub(super) fn function(case: &LightCase, crate_path: &syn::Path) -> TokenStream {
    // Take the case apart by name, so that a new field cannot be forgotten here.
    let LightCase {
        name,
        doc: case_doc,
        public,
        light,
        far,
        shadow_distance_metres,
        scene_bounds,
        technique,
        configurations,
        distribution,
        stretch,
        dominant_plane,
        fit,
        stability,
        map,
        filter,
        bias,
        casters,
        axes,
        resolve,
        prefix,
    } = case;
    let docs = doc("The declaration.");
    let light = variant("LightKind", light);
    let far = variant("FarKind", far);
    let shadow_distance_metres = option(shadow_distance_metres.map(real));
    let technique = word(technique);
    let configurations = configurations.iter().map(word);
    let distribution = option(distribution.as_ref().map(word));
    let stretch = stretch_value(*stretch);
    let dominant_plane = option(dominant_plane.map(dominant_value));
    let fit = variant("Fit", fit);
    let stability = stability_value(stability);
    let map = map_spec(map);
    let filter = filter_value(filter);
    let bias = bias_value(bias);
    let (casters, axes) = (variant("Casters", casters), variant("Axes", axes));
    let resolve = resolve.iter().map(interface);
    quote! {
        #docs
        pub fn case() -> #crate_path::core::LightCase {
            use #crate_path::core::case::*;
            use #crate_path::core::schema::*;
            LightCase {
                name: #name.into(),
                doc: #case_doc.into(),
                public: #public,
                light: #light,
                far: #far,
                shadow_distance_metres: #shadow_distance_metres,
                scene_bounds: #scene_bounds,
                technique: #technique,
                configurations: Vec::from([#(#configurations),*]),
                distribution: #distribution,
                stretch: #stretch,
                dominant_plane: #dominant_plane,
                fit: #fit,
                stability: #stability,
                map: #map,
                filter: #filter,
                bias: #bias,
                casters: #casters,
                axes: #axes,
                resolve: Vec::from([#(#resolve),*]),
                prefix: #prefix.into(),
            }
        }
    }
}

fn map_spec(map: &MapSpec) -> TokenStream {
    let MapSpec { width, height, columns, format, gutter } = *map;
    let (width, height) = (number(width), number(height));
    let (columns, gutter) = (option(columns.map(number)), option(gutter.map(number)));
    let format = variant("DepthFormat", &format);
    quote!(MapSpec { width: #width, height: #height, columns: #columns, format: #format, gutter: #gutter })
}

fn dominant_value(plane: DominantPlane) -> TokenStream {
    let (share, thickness_metres) = (real(plane.share), real(plane.thickness_metres));
    quote!(DominantPlane { share: #share, thickness_metres: #thickness_metres })
}

fn stability_value(stability: &Stability) -> TokenStream {
    match *stability {
        Stability::Quantised { move_metres, turn_degrees } => {
            let (move_metres, turn_degrees) = (real(move_metres), real(turn_degrees));
            quote!(Stability::Quantised { move_metres: #move_metres, turn_degrees: #turn_degrees })
        }
        Stability::None | Stability::Snapped => variant("Stability", stability),
    }
}

fn filter_value(filter: &Filter) -> TokenStream {
    match *filter {
        Filter::Pcf { size, kernel } => {
            let (size, kernel) = (variant("PcfSize", &size), kernel_value(kernel));
            quote!(Filter::Pcf { size: #size, kernel: #kernel })
        }
        Filter::Evsm2 { exponent, blur_texels, bleeding } => {
            let (exponent, blur_texels, bleeding) = (real(exponent), number(blur_texels), real(bleeding));
            quote!(Filter::Evsm2 { exponent: #exponent, blur_texels: #blur_texels, bleeding: #bleeding })
        }
        Filter::GroundMasks { planes, blur_metres, reach_texels } => {
            let (planes, blur, reach) = (number(planes), real(blur_metres), number(reach_texels));
            quote!(Filter::GroundMasks { planes: #planes, blur_metres: #blur, reach_texels: #reach })
        }
        Filter::Pcss { source, reach_texels } => {
            let (source, reach_texels) = (source_value(source), number(reach_texels));
            quote!(Filter::Pcss { source: #source, reach_texels: #reach_texels })
        }
        Filter::None | Filter::Hardware2x2 | Filter::Gather2x2 => variant("Filter", filter),
    }
}

fn kernel_value(kernel: Kernel) -> TokenStream {
    match kernel {
        Kernel::Texels => quote!(Kernel::Texels),
        Kernel::Metres(width) => {
            let width = real(width);
            quote!(Kernel::Metres(#width))
        }
        Kernel::Pixels(width) => {
            let width = real(width);
            quote!(Kernel::Pixels(#width))
        }
    }
}

fn source_value(source: Source) -> TokenStream {
    match source {
        Source::Angle(degrees) => {
            let degrees = real(degrees);
            quote!(Source::Angle(#degrees))
        }
        Source::Radius(metres) => {
            let metres = real(metres);
            quote!(Source::Radius(#metres))
        }
    }
}

fn bias_value(bias: &Bias) -> TokenStream {
    match *bias {
        Bias::Constant { along_light_metres } => {
            let along_light_metres = real(along_light_metres);
            quote!(Bias::Constant { along_light_metres: #along_light_metres })
        }
        Bias::Slope { texels } => {
            let texels = real(texels);
            quote!(Bias::Slope { texels: #texels })
        }
        Bias::WorldTexel { a_metres, b_texels } => {
            let (a_metres, b_texels) = (real(a_metres), real(b_texels));
            quote!(Bias::WorldTexel { a_metres: #a_metres, b_texels: #b_texels })
        }
        Bias::None | Bias::ReceiverPlane => variant("Bias", bias),
    }
}

fn interface(interface: &Resolve) -> TokenStream {
    match *interface {
        Resolve::Mask { depth, normal } => {
            let (depth, normal) = (variant("MaskDepth", &depth), variant("MaskNormal", &normal));
            quote!(Resolve::Mask { depth: #depth, normal: #normal })
        }
        Resolve::Function { group, first_binding } => {
            let (group, first_binding) = (number(group), number(first_binding));
            quote!(Resolve::Function { group: #group, first_binding: #first_binding })
        }
    }
}

fn word(word: &Word) -> TokenStream {
    let name = word.name;
    if word.arguments.0.is_empty() {
        return quote!(Word::plain(#name));
    }
    let arguments = pairs(&word.arguments);
    quote!(Word::with(#name, [#arguments]))
}

fn pairs(arguments: &Arguments) -> TokenStream {
    let pairs = arguments.0.iter().map(|(name, argument)| {
        let argument = value(argument);
        quote!((#name, #argument))
    });
    quote!(#(#pairs),*)
}

fn value(value: &Value) -> TokenStream {
    match value {
        Value::Count(count) => {
            let count = number(*count);
            quote!(Value::Count(#count))
        }
        Value::Number(metres) => {
            let metres = real(*metres);
            quote!(Value::Number(#metres))
        }
        Value::Size(width, height) => {
            let (width, height) = (number(*width), number(*height));
            quote!(Value::Size(#width, #height))
        }
        Value::Word(inner) => {
            let inner = word(inner);
            quote!(Value::Word(#inner))
        }
        Value::Words(words) => {
            let words = words.iter().map(word);
            quote!(Value::Words(Vec::from([#(#words),*])))
        }
        Value::Sizes(sizes) => {
            let sizes = sizes.iter().map(|(width, height)| {
                let (width, height) = (number(*width), number(*height));
                quote!((#width, #height))
            });
            quote!(Value::Sizes(Vec::from([#(#sizes),*])))
        }
        Value::Group(arguments) => {
            let arguments = pairs(arguments);
            quote!(Value::Group(Arguments(Vec::from([#arguments]))))
        }
        Value::Name(name) => quote!(Value::Name(#name.into())),
    }
}

fn option(value: Option<TokenStream>) -> TokenStream {
    match value {
        Some(value) => quote!(Some(#value)),
        None => quote!(None),
    }
}

fn real(value: f64) -> TokenStream {
    let literal = Literal::f64_unsuffixed(value);
    quote!(#literal)
}
