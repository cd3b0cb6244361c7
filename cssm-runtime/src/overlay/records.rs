//! What the overlays' shaders read, one list of fields for both sides: the processor's struct and the shader's text.

use bytemuck::Pod;

/// The part of an overlay's shader that its records and numbers make.
pub(super) fn prelude<S: Record, const ROWS: usize>(
    rows: [RowNames; ROWS],
    numbers: &[(&str, f64)],
) -> String {
    let mut text = String::from("struct Settings {\n");
    for Field { name, ty, .. } in S::FIELDS {
        text += &format!("    {name}: {ty},\n");
    }
    text += "}\n\n";
    text += &format!("const ROW_TEXELS: u32 = {ROW_TEXELS}u;\n");
    for RowNames { name, fields, count } in rows {
        text += &format!("const {name}_ROWS: u32 = {count}u;\n");
        for field in fields {
            let (row, field) = (field.offset_bytes / ROW_BYTES, field.name.to_ascii_uppercase());
            text += &format!("const {name}_{field}: u32 = {row}u;\n");
        }
    }
    for (name, value) in numbers {
        text += &format!("const {name}: f32 = {value:?};\n");
    }
    text + "\n"
}

/// Texels of a row of the texture that holds what is no setting: four floats each.
pub(super) const ROW_TEXELS: usize = 256;

/// Bytes of a texel of that texture, which holds one row of a record.
const ROW_BYTES: usize = size_of::<[f32; 4]>();

/// A struct that shaders read as well.
pub(super) trait Record: Pod {
    /// Its fields in order.
    const FIELDS: &'static [Field];
}

/// A field of a record.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Field {
    name: &'static str,
    /// Type in the shader.
    ty: &'static str,
    /// Offset in the processor's struct.
    offset_bytes: usize,
}

/// A record of the texture: what its rows are called.
#[derive(Debug, Clone, Copy)]
pub(super) struct RowNames {
    name: &'static str,
    fields: &'static [Field],
    count: usize,
}

impl RowNames {
    /// Rows of a record whose fields are four floats each, under the shader's name for it.
    pub(super) const fn of<R: Record>(name: &'static str) -> Self {
        Self { name, fields: R::FIELDS, count: size_of::<R>() / ROW_BYTES }
    }
}

/// Rows of a record.
pub(super) fn rows_of<R: Record>(record: &R) -> &[[f32; 4]] {
    bytemuck::cast_slice(std::slice::from_ref(record))
}

/// A type of both sides.
trait Shared {
    /// Its name in shaders.
    const NAME: &'static str;
}

impl Shared for f32 {
    const NAME: &'static str = "f32";
}

impl Shared for u32 {
    const NAME: &'static str = "u32";
}

impl Shared for [f32; 2] {
    const NAME: &'static str = "vec2<f32>";
}

impl Shared for [f32; 4] {
    const NAME: &'static str = "vec4<f32>";
}

/// Declares a record once for both sides.
macro_rules! record {
    ($(#[$outer:meta])* $record:ident { $($(#[$inner:meta])* $field:ident: $ty:ty,)* }) => {
        $(#[$outer])*
        #[derive(Debug, Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
        #[repr(C)]
        pub(super) struct $record {
            $($(#[$inner])* pub(super) $field: $ty,)*
        }

        impl Record for $record {
            const FIELDS: &'static [Field] = &[$(Field {
                name: stringify!($field),
                ty: <$ty as Shared>::NAME,
                offset_bytes: std::mem::offset_of!($record, $field),
            }),*];
        }
    };
}

record! {
    /// The settings of the overlay of facets.
    FacetSettings {
        /// Ray of the image's upper left corner, camera axes, at depth 1.
        ray_corner: [f32; 4],
        /// Its change from one pixel to the next.
        ray_across: [f32; 4],
        /// Its change from one line to the next.
        ray_down: [f32; 4],
        /// From stored reversed depth to one over depth: a factor and a summand.
        inverse_depth: [f32; 2],
        opacity: f32,
        /// Texels of a square of the checker; 0: no checker.
        checker_texels: f32,
        /// Sectors of a half.
        sectors: u32,
        /// Bands of a sector.
        bands: u32,
        /// 1 where there is a split.
        has_split: u32,
        /// 1 where there is a dominant plane.
        has_dominant: u32,
        /// Row at which borders begin; 0: there are none.
        borders: u32,
        /// Row at which distances begin; 0: there are none.
        distances: u32,
        /// Row at which units begin; 0: there are none.
        units: u32,
        /// Row at which thresholds begin.
        thresholds: u32,
        /// Rows of a sector's thresholds, four to a row.
        threshold_rows: u32,
        /// Row at which the cells' facets begin.
        cells: u32,
        cell_count: u32,
        /// Row at which facets begin.
        facets: u32,
    }
}

record! {
    /// The first rows of a plan; zero where it has none of them.
    PlanRows {
        /// First row of receivers near the dominant plane: between -1 and 1.
        dominant: [f32; 4],
        /// Second row of them: not negative.
        dominant_front: [f32; 4],
        split: [f32; 4],
    }
}

record! {
    /// A facet.
    FacetRows {
        x: [f32; 4],
        y: [f32; 4],
        w: [f32; 4],
        /// How y/w bends: one of the curves, scale, shift, and the curve's own figure.
        curve: [f32; 4],
        /// Corner, width and height of its tile in map texels.
        tile: [f32; 4],
        colour: [f32; 4],
    }
}

record! {
    /// The settings of the overlay of tiles.
    TileSettings {
        /// Size of the map in texels.
        map_texels: [f32; 2],
        /// Width of outlines in pixels of the picture.
        outline_pixels: f32,
        unused_last: f32,
    }
}

record! {
    /// A tile.
    TileRows {
        /// Corner, width and height in map texels.
        rectangle: [f32; 4],
        colour: [f32; 4],
    }
}

#[cfg(test)]
mod tests {
    use naga::TypeInner;

    use super::super::{facet_shader, tile_shader};
    use super::*;

    record! {
        /// A record whose second field shaders put elsewhere.
        Astray {
            first: f32,
            second: [f32; 2],
        }
    }

    /// Name, offset in the shader and offset in the processor's struct of fields that are not in one place.
    fn astray<S: Record>(shader: &str) -> Vec<(&'static str, u32, usize)> {
        let module = naga::front::wgsl::parse_str(shader).unwrap();
        let settings = module.types.iter().find(|(_, ty)| ty.name.as_deref() == Some("Settings"));
        let TypeInner::Struct { members, span } = &settings.unwrap().1.inner else { panic!("no struct") };
        assert_eq!(members.len(), S::FIELDS.len());
        let mut found: Vec<_> = members
            .iter()
            .zip(S::FIELDS)
            .filter(|(member, field)| member.offset as usize != field.offset_bytes)
            .map(|(member, field)| (field.name, member.offset, field.offset_bytes))
            .collect();
        if *span as usize != size_of::<S>() {
            found.push(("the whole", *span, size_of::<S>()));
        }
        found
    }

    #[test]
    fn settings_lie_where_shaders_read_them() {
        assert_eq!(astray::<FacetSettings>(&facet_shader()), []);
        assert_eq!(astray::<TileSettings>(&tile_shader()), []);
    }

    #[test]
    fn a_field_that_shaders_align_otherwise_is_found() {
        let text = prelude::<Astray, 0>([], &[]);
        assert_eq!(astray::<Astray>(&text), [("second", 8, 4), ("the whole", 16, 12)]);
    }

    #[test]
    fn rows_are_whole_and_named_in_order() {
        let text = prelude::<TileSettings, 1>([RowNames::of::<FacetRows>("FACET")], &[("FOUR", 4.0)]);
        let facet = FacetRows {
            x: [0.0; 4],
            y: [1.0; 4],
            w: [2.0; 4],
            curve: [3.0; 4],
            tile: [4.0; 4],
            colour: [5.0; 4],
        };
        let rows = rows_of(&facet);
        assert!(text.contains(&format!("const FACET_ROWS: u32 = {}u;", rows.len())), "{text}");
        for (name, value) in [("X", 0), ("Y", 1), ("W", 2), ("CURVE", 3), ("TILE", 4), ("COLOUR", 5)] {
            assert_eq!(rows[value], [value as f32; 4]);
            assert!(text.contains(&format!("const FACET_{name}: u32 = {value}u;")), "{text}");
        }
        assert!(text.contains("const FOUR: f32 = 4.0;"), "{text}");
        assert!(FacetRows::FIELDS.iter().all(|field| field.ty == <[f32; 4]>::NAME));
    }

    #[test]
    fn shaders_are_valid() {
        for shader in [facet_shader(), tile_shader()] {
            let module = naga::front::wgsl::parse_str(&shader).unwrap();
            let flags = naga::valid::ValidationFlags::all();
            naga::valid::Validator::new(flags, naga::valid::Capabilities::empty()).validate(&module).unwrap();
        }
    }
}
