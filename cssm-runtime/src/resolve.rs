//! The resolve stage as a screen-space pass: the view's depth in, visibility out.

use cssm_core::table::{BindingKind, CaseTable, GroupContent, ShaderKind};

use crate::error::ServiceError;
use crate::frame::{PreparedFrame, Slot, SlotLayouts, uniform};
use crate::layout::{bind_group, group_layout, image_pipeline, incomplete, required_group, shader_module};
use crate::scope::checked;

/// What the mask pass reads of the engine's frame.
#[derive(Debug, Clone, Copy)]
pub struct MaskInputs<'a> {
    /// The view's depth: a depth texture for `depth: reversed_z`, a float texture in metres for `depth: linear`.
    pub depth: &'a wgpu::TextureView,
    /// Unit geometric normals in the case's axes (camera axes unless it declares `axes: world`); only for
    /// `normal: texture`.
    pub normal: Option<&'a wgpu::TextureView>,
}

/// The mask pipeline of a case.
#[derive(Debug)]
pub(crate) struct MaskPipeline {
    pipeline: wgpu::RenderPipeline,
    input_layout: wgpu::BindGroupLayout,
}

impl MaskPipeline {
    /// The pipeline, if the case declares a mask.
    pub(crate) fn new(
        device: &wgpu::Device,
        table: &CaseTable,
        layouts: &SlotLayouts,
        target: wgpu::TextureFormat,
    ) -> Result<Option<Self>, ServiceError> {
        let Some(pass) = table.pass(ShaderKind::Mask) else {
            return Ok(None);
        };
        let input = required_group(table, ShaderKind::Mask, GroupContent::MaskInput)?;
        let shadow = required_group(table, ShaderKind::Mask, GroupContent::Shadow)?;
        let shadow_layout =
            layouts.shadow.as_ref().ok_or_else(|| incomplete(table, "bind group of a pass"))?;
        let module = shader_module(device, table, ShaderKind::Mask)?;

        // Put each group at its declared number.
        let input_layout = checked(device, "the mask's bind group layout", || {
            group_layout(device, table, input, wgpu::ShaderStages::FRAGMENT)
        })?;
        let mut groups = vec![None; 1 + input.group.max(shadow.group) as usize];
        groups[input.group as usize] = Some(&input_layout);
        groups[shadow.group as usize] = Some(shadow_layout);

        let pipeline = checked(device, "the mask pipeline", || {
            image_pipeline(device, "cssm mask", &groups, &module, pass, target)
        })?;
        Ok(Some(Self { pipeline, input_layout }))
    }

    /// Binds the engine's textures.
    pub(crate) fn bind(
        &self,
        device: &wgpu::Device,
        table: &CaseTable,
        layouts: &SlotLayouts,
        slot: &Slot,
        inputs: &MaskInputs,
    ) -> Result<wgpu::BindGroup, ServiceError> {
        let group = required_group(table, ShaderKind::Mask, GroupContent::MaskInput)?;
        let wants_normal = group.bindings.iter().any(|binding| binding.kind == BindingKind::SceneNormal);
        if wants_normal && inputs.normal.is_none() {
            return Err(ServiceError::MissingNormal);
        }
        checked(device, "the mask's inputs", || {
            bind_group(device, &self.input_layout, group, |kind| match kind {
                BindingKind::Uniform { record, .. } => {
                    Some(uniform(&slot.uniforms, table, record, layouts.uniforms.mask_offset))
                }
                BindingKind::SceneDepth | BindingKind::SceneLinearDepth => {
                    Some(wgpu::BindingResource::TextureView(inputs.depth))
                }
                BindingKind::SceneNormal => inputs.normal.map(wgpu::BindingResource::TextureView),
                _ => None,
            })
        })
    }

    /// Records the pass over the whole target; with a scissor `[x, y, width, height]` what lies outside is lit.
    #[allow(clippy::too_many_arguments, reason = "one call of the service, each argument of another kind")]
    pub(crate) fn replay(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        table: &CaseTable,
        frame: &PreparedFrame,
        inputs: &wgpu::BindGroup,
        target: &wgpu::TextureView,
        scissor: Option<[u32; 4]>,
        timestamps: Option<wgpu::RenderPassTimestampWrites>,
    ) -> Result<(), ServiceError> {
        let input = required_group(table, ShaderKind::Mask, GroupContent::MaskInput)?.group;
        let shadow = required_group(table, ShaderKind::Mask, GroupContent::Shadow)?.group;
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("cssm mask"),
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: target,
                depth_slice: None,
                resolve_target: None,
                ops: wgpu::Operations {
                    load: wgpu::LoadOp::Clear(wgpu::Color::WHITE),
                    store: wgpu::StoreOp::Store,
                },
            })],
            timestamp_writes: timestamps,
            ..Default::default()
        });
        if let Some([x, y, width, height]) = scissor {
            if width == 0 || height == 0 {
                return Ok(());
            }
            pass.set_scissor_rect(x, y, width, height);
        }
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(input, inputs, &[]);
        pass.set_bind_group(shadow, frame.shadow_bind_group(), &[]);
        pass.draw(0..3, 0..1);
        Ok(())
    }
}
