//! What can go wrong, and what to do about it.

use crate::mesh::MeshError;

/// Why the service refuses. The state before the call stays in use.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ServiceError {
    /// The map is larger than textures of the device may be.
    #[error(
        "the map of {width} x {height} texels exceeds the limit of {limit} texels a side; declare a smaller map.size or request the limits of features_and_limits"
    )]
    MapTooLarge {
        /// Map width in texels.
        width: u32,
        /// Map height in texels.
        height: u32,
        /// Largest side.
        limit: u32,
    },
    /// A record does not fit a uniform binding.
    #[error(
        "record {record} takes {bytes} bytes, but uniform bindings are limited to {limit}; declare fewer bands or splits, or request the limits of features_and_limits"
    )]
    RecordTooLarge {
        /// Shader type name of the record.
        record: String,
        /// Its size.
        bytes: u32,
        /// Largest uniform binding.
        limit: u64,
    },
    /// The declared bind group number is out of reach.
    #[error(
        "bind group {group} is declared, but only {limit} bind groups may be bound; declare a smaller group"
    )]
    GroupTooLarge {
        /// Declared group number.
        group: u32,
        /// Number of groups.
        limit: u32,
    },
    /// The adapter has no comparison samplers.
    #[error("the adapter has no comparison samplers; declare filter: gather_2x2 or none")]
    NoComparisonSampler,
    /// The device has no storage buffers in vertex shaders, or too few.
    #[error(
        "case {case} stretches exactly, which reads {needed} storage buffers in vertex shaders, but the device has {offered}; declare distribution: bands or stretch: vertex, or request the limits of features_and_limits"
    )]
    NoVertexStorage {
        /// Name of the case.
        case: String,
        /// Storage buffers that the case needs.
        needed: u32,
        /// Storage buffers of a shader stage.
        offered: u32,
    },
    /// The table lacks something that code generation adds.
    #[error("case {case} has no {what} in its table; pass a table that code generation has filled")]
    IncompleteTable {
        /// Name of the case.
        case: String,
        /// What is missing.
        what: &'static str,
    },
    /// The case does not declare the interface that was called.
    #[error("case {case} does not declare {what}; add it to the case's resolve list")]
    NotDeclared {
        /// Name of the case.
        case: String,
        /// What was called.
        what: &'static str,
    },
    /// The device refused to create something.
    #[error(
        "the device refused {what}: {reason}; check the table's shaders, the options and what was passed in"
    )]
    Refused {
        /// What was to be created or done.
        what: &'static str,
        /// The device's own words.
        reason: String,
    },
    /// The device has no memory left.
    #[error("the device has no memory left for {what}; free resources or declare a smaller map")]
    OutOfMemory {
        /// What was to be created.
        what: &'static str,
    },
    /// The device is lost.
    #[error("the device is lost; create a new one and call rebuild")]
    DeviceLost,
    /// A mesh makes no sense.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// An instance names a mesh that the service does not hold.
    #[error(
        "instance {instance} names a mesh that was removed or belongs to a lost device; add the mesh again"
    )]
    UnknownMesh {
        /// Position in the list of instances.
        instance: usize,
    },
    /// A transform holds NaN or does not fit f32 relative to the eye.
    #[error("the transform of instance {instance} is not finite relative to the eye; give finite transforms")]
    Transform {
        /// Position in the list of instances.
        instance: usize,
    },
    /// The instances of a frame exceed what a buffer may hold.
    #[error(
        "{rows} instance rows exceed the device's largest buffer; merge meshes or request a larger max_buffer_size"
    )]
    TooManyInstances {
        /// Rows over all facets.
        rows: usize,
    },
    /// The plan was not made for this table.
    #[error(
        "the plan does not belong to case {case}: {why}; plan with the case that the table was generated from"
    )]
    ForeignPlan {
        /// Name of the case.
        case: String,
        /// What gives it away.
        why: &'static str,
    },
    /// Caster shaders were not composed for this table.
    #[error(
        "the caster shaders of entry {entry} do not belong to case {case}: {why}; compose them with the case that the table was generated from"
    )]
    ForeignCasters {
        /// Name of the caster entry.
        entry: String,
        /// Name of the case.
        case: String,
        /// What gives it away.
        why: &'static str,
    },
    /// The view's eye or rotation is not the plan's.
    #[error("the view's eye or rotation is not the plan's; prepare with the view that was planned")]
    ForeignView,
    /// The frame was prepared by another service, or before a rebuild, or names a mesh that is gone.
    #[error("the frame is stale: {why}; prepare it again")]
    StaleFrame {
        /// What happened since.
        why: &'static str,
    },
    /// The mask pass reads a normal texture and none was given.
    #[error("the mask pass reads normals from a texture; give MaskInputs::normal")]
    MissingNormal,
    /// No case was declared.
    #[error(
        "a light service needs at least one light case; pass the declared cases with their generated tables"
    )]
    NoCases,
    /// The table was generated from another declaration.
    #[error(
        "the table is not that of case {case}; pass the table that was generated from this very declaration"
    )]
    ForeignTable {
        /// Name of the case.
        case: String,
    },
    /// Cases that share a map declare different ones.
    #[error(
        "case {case} declares another map than the first case; give all cases of a service one map size and format"
    )]
    MixedMaps {
        /// Name of the case that differs.
        case: String,
    },
    /// The service has no such case.
    #[error("the service has no case {case}; use a position in the list that it was made from")]
    UnknownCase {
        /// Position in the list of cases.
        case: u32,
    },
    /// The service has no such light.
    #[error("the light was removed or belongs to another service; add it again")]
    UnknownLight,
    /// A light is of another kind than its case's.
    #[error(
        "case {case} declares light: {declared}, but a light of another kind uses it; use a case of the light's kind"
    )]
    LightKind {
        /// Name of the case.
        case: String,
        /// Name of the declared kind.
        declared: &'static str,
    },
    /// A number of a light's description makes no sense.
    #[error(
        "the light's {what} makes no sense; give positive, finite numbers, and a largest side that is not below the smallest"
    )]
    LightSetting {
        /// What is wrong.
        what: &'static str,
    },
    /// The light makes no sense.
    #[error(transparent)]
    Light(#[from] cssm_core::light::LightError),
    /// One of the two lists of casters is at fault.
    #[error("in the list of {list} casters: {source}")]
    Casters {
        /// `static` or `dynamic`.
        list: &'static str,
        /// What is wrong.
        source: Box<ServiceError>,
    },
    /// The box of a caster that the engine draws holds nothing.
    #[error(
        "the box of caster {caster} in the list of {list} casters of the engine's own is empty or not finite; give finite boxes, or none for casters that may be anywhere"
    )]
    EngineBounds {
        /// `static` or `dynamic`.
        list: &'static str,
        /// Position in the list.
        caster: usize,
    },
    /// Casters that only the engine can draw were left out.
    #[error("tiles of the frame show casters that the engine draws; record it with capture_with")]
    EngineCasters,
    /// Reading back failed.
    #[error("the texture could not be read back: {why}; read colour or depth textures with COPY_SRC usage")]
    ReadBack {
        /// What failed.
        why: &'static str,
    },
}
