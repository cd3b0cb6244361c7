//! Where the generated resolve function puts positions: facet, texel, depth, for many plans in one submission.

use cssm_core::glam::{DVec2, Vec3};
use cssm_core::table::{CaseTable, GroupContent, RecordKind, ShaderKind};
use cssm_runtime::{read_back, wgpu};

use super::casters::buffer;
use super::device::TestDevice;
use super::images;

/// Plans in one submission.
pub const PLANS: usize = 256;

/// What the shader found for one position.
#[derive(Debug, Clone, Copy)]
pub struct Placed {
    /// Facet index.
    pub facet: u32,
    /// Map texel coordinates.
    pub texel: DVec2,
    /// Depth after division, growing away from the light.
    pub signed_depth: f64,
    /// What was divided by.
    pub w: f64,
    /// Whether the shader would look into the map there.
    pub covered: bool,
}

/// The generated function behind an entry point of our own: a row of pixels for each plan, a pixel for each position.
#[derive(Debug)]
pub struct PlaceProbe<'a> {
    gpu: &'a TestDevice,
    pipeline: wgpu::RenderPipeline,
    inputs: wgpu::BindGroupLayout,
    shadow: wgpu::BindGroupLayout,
    inputs_group: u32,
    shadow_group: u32,
    record_bytes: u64,
}

impl<'a> PlaceProbe<'a> {
    /// Builds it from the function of a generated table.
    ///
    /// # Panics
    /// When the table has no function.
    pub fn new(gpu: &'a TestDevice, table: &CaseTable) -> Self {
        let function = table.shader(ShaderKind::Function).expect("the case declares a function");
        let group = table.group(ShaderKind::Function, GroupContent::Shadow).expect("it has a group");
        let record = table.record(RecordKind::Shadow).expect("it has a shadow record");
        let shadow_group = group.group;
        let inputs_group = u32::from(shadow_group == 0);

        // A plan of one facet has nothing to choose from, so its shader has no function for it.
        let index = if table.cells() > 1 { "PREFIX_facet_index(point)" } else { "0u" };
        let own = PROBE.replace("INDEX", index).replace("INPUTS", &inputs_group.to_string());
        let own = own.replace("PREFIX", &table.prefix);
        let module = gpu.device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: None,
            source: wgpu::ShaderSource::Wgsl(format!("{}\n{own}", function.wgsl).into()),
        });

        // The entry point reads neither map nor sampler: the plan is all that is bound.
        let entry = |ty| wgpu::BindGroupLayoutEntry {
            binding: 0,
            visibility: wgpu::ShaderStages::FRAGMENT,
            ty,
            count: None,
        };
        let layout = |ty| {
            gpu.device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
                label: None,
                entries: &[entry(ty)],
            })
        };
        let inputs = layout(wgpu::BindingType::Texture {
            sample_type: wgpu::TextureSampleType::Float { filterable: false },
            view_dimension: wgpu::TextureViewDimension::D2,
            multisampled: false,
        });
        let shadow = layout(wgpu::BindingType::Buffer {
            ty: wgpu::BufferBindingType::Uniform,
            has_dynamic_offset: true,
            min_binding_size: None,
        });
        let mut groups = vec![None; shadow_group.max(inputs_group) as usize + 1];
        groups[inputs_group as usize] = Some(&inputs);
        groups[shadow_group as usize] = Some(&shadow);
        let layout = gpu.device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: None,
            bind_group_layouts: &groups,
            immediate_size: 0,
        });
        let target = || Some(wgpu::TextureFormat::Rgba32Float.into());
        let pipeline = gpu.device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: None,
            layout: Some(&layout),
            vertex: wgpu::VertexState {
                module: &module,
                entry_point: Some("probe_vertex"),
                compilation_options: Default::default(),
                buffers: &[],
            },
            primitive: Default::default(),
            depth_stencil: None,
            multisample: Default::default(),
            fragment: Some(wgpu::FragmentState {
                module: &module,
                entry_point: Some("probe_fragment"),
                compilation_options: Default::default(),
                targets: &[target(), target()],
            }),
            multiview_mask: None,
            cache: None,
        });
        let record_bytes = u64::from(record.size_bytes);
        Self { gpu, pipeline, inputs, shadow, inputs_group, shadow_group, record_bytes }
    }

    /// Places every plan's positions, which are in the case's axes; `records` are the plans' shadow records. Every plan
    /// has equally many positions; at most [`PLANS`] plans.
    ///
    /// # Panics
    /// When the numbers of plans or positions differ, or the device is lost.
    pub fn place(&self, records: &[Vec<u8>], positions: &[Vec<Vec3>]) -> Vec<Vec<Placed>> {
        assert!(records.len() == positions.len() && records.len() <= PLANS);
        let (gpu, device) = (self.gpu, &self.gpu.device);
        let width = positions.first().map_or(0, Vec::len);
        assert!(positions.iter().all(|row| row.len() == width));
        let size = (width as u32, records.len() as u32);

        // Lay the records at the alignment of dynamic offsets.
        let alignment = u64::from(device.limits().min_uniform_buffer_offset_alignment);
        let stride = self.record_bytes.next_multiple_of(alignment);
        let mut bytes = Vec::new();
        for record in records {
            bytes.extend_from_slice(record);
            bytes.resize(bytes.len().next_multiple_of(stride as usize), 0);
        }
        let plans = buffer(gpu, &bytes, wgpu::BufferUsages::UNIFORM);
        let texels: Vec<f32> =
            positions.iter().flatten().flat_map(|point| [point.x, point.y, point.z, 1.0]).collect();
        let source = images::vector_texture(gpu, size, &texels).create_view(&Default::default());
        let group = |layout, resource| {
            let entries = &[wgpu::BindGroupEntry { binding: 0, resource }];
            device.create_bind_group(&wgpu::BindGroupDescriptor { label: None, layout, entries })
        };
        let inputs = group(&self.inputs, wgpu::BindingResource::TextureView(&source));
        let shadow = group(
            &self.shadow,
            wgpu::BindingResource::Buffer(wgpu::BufferBinding {
                buffer: &plans,
                offset: 0,
                size: wgpu::BufferSize::new(self.record_bytes),
            }),
        );

        // Draw a row for each plan.
        let targets = [(); 2].map(|()| images::target(gpu, size, wgpu::TextureFormat::Rgba32Float));
        let views = targets.each_ref().map(|target| target.create_view(&Default::default()));
        let attachment = |view| {
            Some(wgpu::RenderPassColorAttachment {
                view,
                depth_slice: None,
                resolve_target: None,
                ops: wgpu::Operations::default(),
            })
        };
        let mut encoder = device.create_command_encoder(&Default::default());
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            color_attachments: &[attachment(&views[0]), attachment(&views[1])],
            ..Default::default()
        });
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(self.inputs_group, &inputs, &[]);
        for row in 0..size.1 {
            pass.set_scissor_rect(0, row, size.0, 1);
            pass.set_bind_group(self.shadow_group, &shadow, &[row * stride as u32]);
            pass.draw(0..3, 0..1);
        }
        drop(pass);
        gpu.queue.submit([encoder.finish()]);

        // Read both halves back.
        let [one, two] = targets.map(|target| floats(gpu, &target));
        let placed = one.into_iter().zip(two).map(|(one, two)| Placed {
            facet: one[0] as u32,
            texel: DVec2::new(f64::from(one[1]), f64::from(one[2])),
            signed_depth: f64::from(one[3]),
            w: f64::from(two[0]),
            covered: two[1] == 1.0,
        });
        let placed: Vec<_> = placed.collect();
        placed.chunks(width.max(1)).map(<[_]>::to_vec).collect()
    }
}

/// Texels of an `Rgba32Float` texture.
fn floats(gpu: &TestDevice, texture: &wgpu::Texture) -> Vec<[f32; 4]> {
    let bytes = read_back::texture_bytes(&gpu.device, &gpu.queue, texture);
    let bytes = bytes.expect("the texture has COPY_SRC usage");
    let float = |texel: &[u8], k: usize| f32::from_le_bytes(std::array::from_fn(|byte| texel[4 * k + byte]));
    bytes.chunks_exact(16).map(|texel| std::array::from_fn(|k| float(texel, k))).collect()
}

const PROBE: &str = "
@group(INPUTS) @binding(0) var probe_positions: texture_2d<f32>;

struct ProbePlaced { @location(0) place: vec4<f32>, @location(1) more: vec4<f32> }

@vertex
fn probe_vertex(@builtin(vertex_index) corner: u32) -> @builtin(position) vec4<f32> {
    return vec4<f32>(select(-1.0, 3.0, corner == 2u), select(1.0, -3.0, corner == 1u), 0.0, 1.0);
}

@fragment
fn probe_fragment(@builtin(position) pixel: vec4<f32>) -> ProbePlaced {
    let point = PREFIX_facet_position(textureLoad(probe_positions, vec2<i32>(pixel.xy), 0).xyz);
    let index = INDEX;
    let place = PREFIX_place_in_facet(PREFIX_shadow.facets[index], point);
    let covered = select(0.0, 1.0, place.covered);
    return ProbePlaced(
        vec4<f32>(f32(index), place.texel, place.ndc.z),
        vec4<f32>(place.w, covered, 0.0, 0.0),
    );
}
";
