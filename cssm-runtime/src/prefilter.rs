//! The prefilter: moments of the map's depths, or masks of what covers planes, blurred tile by tile between capture and
//! resolve.
//!
//! Two passes of one draw each cover the tiles of a plan by instances, one for each cell of its selection walk; the tiles
//! themselves stand in the shadow record that resolving reads. Texels outside the plan's tiles keep what they hold, so
//! plans that share a map are filtered one by one, when their tiles are drawn anew.

use cssm_core::table::{BindingKind, CaseTable, GroupContent, ShaderKind};

use crate::atlas::{Atlas, Prefiltered, prefiltered_format};
use crate::error::ServiceError;
use crate::frame::uniform;
use crate::layout::{bind_group, group_layout, image_pipeline, required_group, required_pass, shader_module};
use crate::scope::checked;

/// Corners of the two triangles that cover a tile.
const CORNERS: u32 = 6;

/// The prefilter of a table that declares one.
#[derive(Debug)]
pub(crate) struct Prefilter {
    rows: Stage,
    columns: Stage,
    cells: u32,
}

/// One pass.
#[derive(Debug)]
struct Stage {
    shader: ShaderKind,
    group: u32,
    layout: wgpu::BindGroupLayout,
    pipeline: wgpu::RenderPipeline,
}

/// What both passes bind for one frame.
#[derive(Debug)]
pub(crate) struct PrefilterGroups {
    rows: wgpu::BindGroup,
    columns: wgpu::BindGroup,
}

impl Prefilter {
    /// The pipelines, if the case has a filter that needs them.
    pub(crate) fn new(device: &wgpu::Device, table: &CaseTable) -> Result<Option<Self>, ServiceError> {
        if table.pass(ShaderKind::PrefilterRows).is_none() {
            return Ok(None);
        }
        let stage = |shader| Stage::new(device, table, shader);
        Ok(Some(Self {
            rows: stage(ShaderKind::PrefilterRows)?,
            columns: stage(ShaderKind::PrefilterColumns)?,
            cells: table.cells(),
        }))
    }

    /// Binds the shadow record of a frame at an offset of its uniform buffer.
    pub(crate) fn bind(
        &self,
        device: &wgpu::Device,
        table: &CaseTable,
        atlas: &Atlas,
        (uniforms, shadow_offset): (&wgpu::Buffer, u64),
    ) -> Result<PrefilterGroups, ServiceError> {
        let bind = |stage: &Stage| {
            let group = required_group(table, stage.shader, GroupContent::Prefilter)?;
            checked(device, "a prefilter bind group", || {
                bind_group(device, &stage.layout, group, |kind| match kind {
                    BindingKind::Uniform { record, .. } => {
                        Some(uniform(uniforms, table, record, shadow_offset))
                    }
                    _ => atlas.texture_resource(kind),
                })
            })
        };
        Ok(PrefilterGroups { rows: bind(&self.rows)?, columns: bind(&self.columns)? })
    }

    /// Records both passes over the tiles of the plan that the groups' record holds.
    pub(crate) fn replay(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        images: &Prefiltered,
        groups: &PrefilterGroups,
    ) {
        self.rows.replay(encoder, &images.rows, &groups.rows, self.cells);
        self.columns.replay(encoder, &images.blurred, &groups.columns, self.cells);
    }
}

impl Stage {
    fn new(device: &wgpu::Device, table: &CaseTable, shader: ShaderKind) -> Result<Self, ServiceError> {
        let pass = required_pass(table, shader)?;
        let declared = required_group(table, shader, GroupContent::Prefilter)?;
        let module = shader_module(device, table, shader)?;
        let layout = checked(device, "a prefilter bind group layout", || {
            group_layout(device, table, declared, wgpu::ShaderStages::VERTEX_FRAGMENT)
        })?;
        let mut groups = vec![None; 1 + declared.group as usize];
        groups[declared.group as usize] = Some(&layout);
        let pipeline = checked(device, "a prefilter pipeline", || {
            image_pipeline(device, PASS_LABEL, &groups, &module, pass, prefiltered_format(table))
        })?;
        Ok(Self { shader, group: declared.group, layout, pipeline })
    }

    fn replay(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        target: &wgpu::TextureView,
        group: &wgpu::BindGroup,
        cells: u32,
    ) {
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some(PASS_LABEL),
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: target,
                depth_slice: None,
                resolve_target: None,
                ops: wgpu::Operations { load: wgpu::LoadOp::Load, store: wgpu::StoreOp::Store },
            })],
            ..Default::default()
        });
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(self.group, group, &[]);
        pass.draw(0..CORNERS, 0..cells);
    }
}

/// Name of the passes in captures of frames.
const PASS_LABEL: &str = "cssm prefilter";
