//! The shadow bindings inside a bind group of the engine's: for cases that declare `function { first_binding: .. }`.

use cssm_core::table::BindingKind;

use crate::error::ServiceError;
use crate::frame::{PreparedFrame, uniform};
use crate::gpu::Gpu;
use crate::layout::{group_entries, shadow_group};
use crate::service::ShadowService;

impl ShadowService {
    /// Entries of the shadow bindings for a bind group layout of the engine's, visible to `stages`: the plan, the map and
    /// its sampler, at the numbers that the case declares. Empty where the case declares no resolve interface.
    pub fn shadow_layout_entries(&self, stages: wgpu::ShaderStages) -> Vec<wgpu::BindGroupLayoutEntry> {
        let group = shadow_group(self.table());
        group.map(|group| group_entries(self.table(), group, stages)).unwrap_or_default()
    }

    /// What to bind there for one frame, beside the engine's own entries; [`PreparedFrame::shadow_bind_group`] holds the
    /// same by themselves.
    ///
    /// # Errors
    /// [`ServiceError::StaleFrame`].
    pub fn shadow_entries<'f>(
        &'f self,
        frame: &'f PreparedFrame,
    ) -> Result<Vec<wgpu::BindGroupEntry<'f>>, ServiceError> {
        self.check_frame(frame)?;
        let Gpu { layouts, atlas, .. } = self.gpu();
        let bindings = shadow_group(self.table()).map(|group| &*group.bindings).unwrap_or_default();
        let entry = |binding: &cssm_core::table::Binding| {
            let resource = match binding.kind {
                BindingKind::Uniform { record, .. } => {
                    let offset = layouts.uniforms.shadow_offset;
                    Some(uniform(&frame.slot.uniforms, self.table(), record, offset))
                }
                kind => atlas.resource(kind, frame.depth_order),
            };
            resource.map(|resource| wgpu::BindGroupEntry { binding: binding.binding, resource })
        };
        Ok(bindings.iter().filter_map(entry).collect())
    }
}
