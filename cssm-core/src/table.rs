//! The table of a case: everything the CPU and the GPU must agree on, defined once.
//!
//! [`CaseTable::describe`] derives it from a case alone. Code generation prints the shaders' structs and bindings
//! from it and emits it as Rust and JSON; the runtime uploads plans and builds pipelines from it. It names no type
//! of any graphics interface. What a case does not declare has no record field, binding or pass here.

mod binding;
mod caster;
mod constant;
mod describe;
mod filter;
mod ground;
mod meaning;
mod pass;
mod record;
mod shader;
mod write;

pub use binding::{BindGroup, Binding, BindingKind, GroupContent};
pub use caster::{CasterAttribute, CasterBinding, CasterShader, CasterSpace, CasterTable, caster_rows};
pub use constant::{Constant, ConstantKind, ConstantValue};
pub use meaning::Meaning;
pub use pass::{Pass, Reduction, Resource};
pub use record::{FieldType, Record, RecordField, RecordKind};
pub use shader::{Shader, ShaderKind};
pub use write::{
    shear_parts, write_capture_record, write_capture_record_to, write_caster_mask_record, write_fit_record,
    write_mask_record, write_mask_record_to, write_shadow_record, write_shadow_record_to,
};

use std::borrow::Cow;

use crate::case::{Axes, DepthFormat, Stretch};
use crate::distribution::RemapKind;

/// Records, bindings, passes and shaders of one case.
#[derive(Debug, Clone, PartialEq)]
pub struct CaseTable {
    /// Name of the case.
    pub case: Cow<'static, str>,
    /// Prefix of every shader name.
    pub prefix: Cow<'static, str>,
    /// Fingerprint of the declaration; equal declarations have equal fingerprints.
    pub fingerprint: u64,
    /// Map width in texels.
    pub map_width: u32,
    /// Map height in texels.
    pub map_height: u32,
    /// Map texel format.
    pub map_format: DepthFormat,
    /// Halves of the selection walk.
    pub halves: u32,
    /// Sectors of each half.
    pub sectors: u32,
    /// Bands in each sector.
    pub bands: u32,
    /// Half-spaces that the capture cuts casters with; 0: every tile is a rectangle of its own.
    pub clips: u32,
    /// Whether receivers near a dominant plane have a cell of their own, after all others.
    pub dominant: bool,
    /// Whether band limits are multiples of a row of each sector's own.
    pub scales_thresholds: bool,
    /// Whether rays begin at a point; the shadow record then holds its position where a bias needs it.
    pub local_light: bool,
    /// How facets bend their rows.
    pub remap: RemapKind,
    /// How casters are drawn where rows are bent.
    pub stretch: Stretch,
    /// Whether plans may store depth reversed; the shadow record then holds its sign.
    pub may_reverse_depth: bool,
    /// Axes of positions and normals in the resolve shaders.
    pub axes: Axes,
    /// Whether the resolve shaders shear positions along the light; the shadow record then holds the shear and its rows
    /// are those of sheared camera axes. Capture records are in sheared camera axes always.
    pub shears: bool,
    /// Texture fetch instructions of the map per resolved pixel, at most.
    pub fetches_per_pixel: u32,
    /// Numbers that the shaders are specialised for.
    pub constants: Cow<'static, [Constant]>,
    /// Uniform records; nested ones before those that hold them.
    pub records: Cow<'static, [Record]>,
    /// Bind groups by shader.
    pub groups: Cow<'static, [BindGroup]>,
    /// Passes in order of execution.
    pub passes: Cow<'static, [Pass]>,
    /// The reduction of the engine's depth, if the case is fitted to it and takes it.
    pub reduction: Option<Reduction>,
    /// Shader modules; empty until code generation has run.
    pub shaders: Cow<'static, [Shader]>,
}

impl CaseTable {
    /// The constant of a kind, if the case has one.
    pub fn constant(&self, kind: ConstantKind) -> Option<&Constant> {
        self.constants.iter().find(|constant| constant.kind == kind)
    }

    /// The record of a kind, if the case has one.
    pub fn record(&self, kind: RecordKind) -> Option<&Record> {
        self.records.iter().find(|record| record.kind == kind)
    }

    /// The bind group of a shader with a content, if the case has one.
    pub fn group(&self, shader: ShaderKind, content: GroupContent) -> Option<&BindGroup> {
        self.groups.iter().find(|group| group.shader == shader && group.content == content)
    }

    /// The pass that runs a shader, if the case has one.
    pub fn pass(&self, shader: ShaderKind) -> Option<&Pass> {
        self.passes.iter().find(|pass| pass.shader == shader)
    }

    /// The generated module of a kind, if there is one.
    pub fn shader(&self, kind: ShaderKind) -> Option<&Shader> {
        self.shaders.iter().find(|shader| shader.kind == kind)
    }

    /// Cells of the selection walk; the shadow record holds a facet for each.
    pub fn cells(&self) -> u32 {
        self.halves * self.sectors * self.bands + u32::from(self.dominant)
    }
}
