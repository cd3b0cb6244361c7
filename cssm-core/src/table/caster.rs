//! Capture shaders around an engine's own vertex function, as data; and where the engine's casters stand.
//!
//! Code generation composes them from a case and the engine's source; the engine makes its own pipelines of them and
//! draws its own buffers.

use std::borrow::Cow;

use glam::{DAffine3, DMat3};

use super::ShaderKind;
use crate::plan::ShadowPlan;

/// Capture shaders of a case whose casters the engine's own functions place.
#[derive(Debug, Clone, PartialEq)]
pub struct CasterTable {
    /// Name of the caster entry, lower snake case.
    pub name: Cow<'static, str>,
    /// Name of the case.
    pub case: Cow<'static, str>,
    /// Fingerprint of the case's declaration; see [`super::CaseTable::fingerprint`].
    pub fingerprint: u64,
    /// Space of the positions that the engine's function returns.
    pub space: CasterSpace,
    /// Vertex attributes that the engine's function takes, in order of location; the instance rows are not among them.
    pub attributes: Cow<'static, [CasterAttribute]>,
    /// Bindings that the shaders use beside the facet's: the engine's own, in order of group and number.
    pub bindings: Cow<'static, [CasterBinding]>,
    /// One module for pipelines that leave depth unclipped, and one that clamps depth and cuts casters by itself.
    pub shaders: Cow<'static, [CasterShader]>,
}

impl CasterTable {
    /// The module of a kind, if there is one.
    pub fn shader(&self, kind: ShaderKind) -> Option<&CasterShader> {
        self.shaders.iter().find(|shader| shader.kind == kind)
    }
}

/// Space of the positions that an engine's vertex function returns; metres, after skinning, displacement and whatever
/// else the engine does.
///
/// Positions are f32 from there on, so the space decides what they lose: relative to an object a few metres large
/// nothing that anyone could see; relative to an origin near the eye 6e-8 of the distance from it, which is a tenth of a
/// texel at a field of view of 1 degree.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CasterSpace {
    /// The object's own. Three rows for each instance, vertex attributes `vec4<f32>` at this and the next two locations,
    /// take positions to the capture's axes; [`caster_rows`] finds them in f64 from the object's place in the world.
    Object {
        /// Location of the first row.
        first_location: u32,
    },
    /// World axes, relative to an origin of the engine's choice, the same for all casters of a draw. Three rows in a
    /// uniform buffer, `array<vec4<f32>, 3>` bound at these numbers, take positions to the capture's axes;
    /// [`caster_rows`] of a translation to the origin finds them. Fit for engines that hold all their instances
    /// relative to the eye.
    World {
        /// Bind group number; the group is the engine's.
        group: u32,
        /// Binding number in it.
        binding: u32,
    },
    /// The capture's axes, relative to the eye of the plan: the engine composes its own matrices with
    /// [`ShadowPlan::capture_from_world`], in f64.
    Capture,
}

/// A vertex attribute that an engine's function takes.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CasterAttribute {
    /// `@location` number.
    pub location: u32,
    /// Name in the engine's source.
    pub name: Cow<'static, str>,
    /// WGSL type, such as `vec3<f32>`.
    pub ty: Cow<'static, str>,
}

/// A binding of the engine's that caster shaders use.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CasterBinding {
    /// `@group` number.
    pub group: u32,
    /// `@binding` number.
    pub binding: u32,
    /// Variable name in the shader.
    pub name: Cow<'static, str>,
}

/// A composed capture module.
#[derive(Debug, Clone, PartialEq)]
pub struct CasterShader {
    /// Which of the case's capture shaders it stands for.
    pub kind: ShaderKind,
    /// WGSL source.
    pub wgsl: Cow<'static, str>,
    /// SPIR-V, little-endian words.
    pub spirv: Cow<'static, [u8]>,
    /// Vertex entry point.
    pub vertex: Cow<'static, str>,
    /// Fragment entry point, if there is one.
    pub fragment: Option<Cow<'static, str>>,
}

/// Rows that take (x, y, z, 1) of an object's space to a position relative to the plan's eye in the capture's axes,
/// metres: composed in f64, rounded once; `None` where f32 cannot hold them.
///
/// For [`CasterSpace::World`] the object is the world seen from the engine's origin: a translation to it.
pub fn caster_rows(plan: &ShadowPlan, world_from_object: &DAffine3) -> Option<[[f32; 4]; 3]> {
    let capture_from_world: DMat3 = plan.capture_from_world();
    let matrix = capture_from_world * world_from_object.matrix3;
    let shift = capture_from_world * (world_from_object.translation - plan.eye_world);
    let row = |index: usize| matrix.row(index).extend(shift[index]).as_vec4();
    let rows = [row(0), row(1), row(2)];
    rows.iter().all(|row| row.is_finite()).then(|| rows.map(|row| row.to_array()))
}
