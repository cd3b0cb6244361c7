//! Resolving on the device: the scene's depth and normals from ray casting, masks and the engine's own material.

use cssm_core::View;
use cssm_core::case::Axes;
use cssm_core::glam::{DMat3, DVec3};
use cssm_core::table::{CaseTable, GroupContent, ShaderKind};
use cssm_runtime::{PreparedFrame, ShadowService, wgpu};

use super::device::TestDevice;
use super::yard::{Hit, hit};

/// What every pixel of a view sees, from casting rays in f64.
#[derive(Debug)]
pub struct Visible {
    /// Size of the image.
    pub size: (u32, u32),
    /// What each pixel's centre hits; rays have depth 1, so [`Hit::along`] is the depth.
    pub hits: Vec<Option<Hit>>,
    /// The rays, world axes.
    pub rays: Vec<DVec3>,
    camera_from_world: DMat3,
}

impl Visible {
    /// Casts a ray through every pixel's centre; beyond the far plane there is sky.
    pub fn new(view: &View, triangles: &[[DVec3; 3]]) -> Self {
        let (width, height) = view.size_pixels;
        let centre = |pixel: u32| (f64::from(pixel % width) + 0.5, f64::from(pixel / width) + 0.5);
        let rays: Vec<_> = (0..width * height)
            .map(|pixel| {
                let (x, y) = centre(pixel);
                view.ray_world(x, y)
            })
            .collect();
        let drawn = |hit: &Hit| (view.near_metres..view.far_metres).contains(&hit.along);
        let hits = rays.iter().map(|ray| hit(triangles, *ray).filter(drawn)).collect();
        Self { size: view.size_pixels, hits, rays, camera_from_world: view.camera_from_world }
    }

    /// Depth in metres as an engine with linear depth stores it; 0 is sky.
    pub fn linear_depths(&self) -> Vec<f32> {
        self.hits.iter().map(|hit| hit.map_or(0.0, |hit| hit.along as f32)).collect()
    }

    /// Reversed-z with the view's own planes; 0 is sky.
    pub fn reversed_depths(&self, view: &View) -> Vec<f32> {
        let far_inverse = 1.0 / view.far_metres;
        let stored = |depth: f64| (1.0 / depth - far_inverse) / (1.0 / view.near_metres - far_inverse);
        self.hits.iter().map(|hit| hit.map_or(0.0, |hit| stored(hit.along) as f32)).collect()
    }

    /// Positions relative to the eye as an engine's material knows them, four floats each; the fourth is 0 for sky.
    pub fn positions(&self, axes: Axes) -> Vec<f32> {
        let texel = |(ray, hit): (&DVec3, &Option<Hit>)| {
            let point = self.turned(axes, *ray * hit.map_or(0.0, |hit| hit.along)).as_vec3();
            [point.x, point.y, point.z, if hit.is_some() { 1.0 } else { 0.0 }]
        };
        self.rays.iter().zip(&self.hits).flat_map(texel).collect()
    }

    /// Normals as an engine stores them, four floats each.
    pub fn normals(&self, axes: Axes) -> Vec<f32> {
        let texel = |hit: &Option<Hit>| {
            let normal = self.turned(axes, hit.map_or(DVec3::ZERO, |hit| hit.normal)).as_vec3();
            [normal.x, normal.y, normal.z, 0.0]
        };
        self.hits.iter().flat_map(texel).collect()
    }

    fn turned(&self, axes: Axes, vector: DVec3) -> DVec3 {
        match axes {
            Axes::Camera => self.camera_from_world * vector,
            Axes::World => vector,
        }
    }

    /// Whether all pixels within `radius` of one lie on the same plane, so that normals can be reconstructed.
    pub fn on_one_plane(&self, pixel: usize, radius: i32) -> bool {
        let Some(own) = self.hits[pixel] else { return false };
        let (width, height) = (self.size.0 as i32, self.size.1 as i32);
        let (x, y) = (pixel as i32 % width, pixel as i32 / width);
        let offset = own.normal.dot(self.rays[pixel]) * own.along;
        (-radius..=radius).flat_map(|dy| (-radius..=radius).map(move |dx| (x + dx, y + dy))).all(|(x, y)| {
            if x < 0 || y < 0 || x >= width || y >= height {
                return false;
            }
            let neighbour = (y * width + x) as usize;
            self.hits[neighbour].is_some_and(|hit| {
                let distance = own.normal.dot(self.rays[neighbour]) * hit.along - offset;
                hit.normal.dot(own.normal) > 0.999_999 && distance.abs() < 1e-6 * hit.along
            })
        })
    }
}

/// The engine's own material: a full-screen pass that finds position and normal itself and calls the generated
/// function, with the shadow group at the declared number.
#[derive(Debug)]
pub struct Material {
    pipeline: wgpu::RenderPipeline,
    inputs: wgpu::BindGroupLayout,
    inputs_group: u32,
    shadow_group: u32,
}

impl Material {
    /// Builds it from the generated function; `arguments` is what the function is called with.
    ///
    /// # Panics
    /// When the table has no function.
    pub fn new(gpu: &TestDevice, table: &CaseTable, service: &ShadowService, arguments: &str) -> Self {
        let function = table.shader(ShaderKind::Function).expect("the case declares a function");
        let group = table.group(ShaderKind::Function, GroupContent::Shadow).expect("it has a group");
        let own = MATERIAL.replace("VISIBILITY", &format!("{}_visibility({arguments})", table.prefix));
        // The engine's own group stands beside the declared one.
        let inputs_group = u32::from(group.group == 0);
        let own = own.replace("INPUTS", &inputs_group.to_string());
        let module = gpu.device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: None,
            source: wgpu::ShaderSource::Wgsl(format!("{}\n{own}", function.wgsl).into()),
        });
        let texture = |binding| wgpu::BindGroupLayoutEntry {
            binding,
            visibility: wgpu::ShaderStages::FRAGMENT,
            ty: wgpu::BindingType::Texture {
                sample_type: wgpu::TextureSampleType::Float { filterable: false },
                view_dimension: wgpu::TextureViewDimension::D2,
                multisampled: false,
            },
            count: None,
        };
        let inputs = gpu.device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
            label: None,
            entries: &[texture(0), texture(1)],
        });
        let mut groups = vec![None; group.group.max(inputs_group) as usize + 1];
        groups[inputs_group as usize] = Some(&inputs);
        groups[group.group as usize] = service.shadow_bind_group_layout();
        let layout = gpu.device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: None,
            bind_group_layouts: &groups,
            immediate_size: 0,
        });
        let pipeline = gpu.device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: None,
            layout: Some(&layout),
            vertex: wgpu::VertexState {
                module: &module,
                entry_point: Some("engine_vertex"),
                compilation_options: Default::default(),
                buffers: &[],
            },
            primitive: Default::default(),
            depth_stencil: None,
            multisample: Default::default(),
            fragment: Some(wgpu::FragmentState {
                module: &module,
                entry_point: Some("engine_fragment"),
                compilation_options: Default::default(),
                targets: &[Some(wgpu::TextureFormat::R8Unorm.into())],
            }),
            multiview_mask: None,
            cache: None,
        });
        Self { pipeline, inputs, inputs_group, shadow_group: group.group }
    }

    /// Records the pass; `positions` and `normals` are float textures of the target's size.
    pub fn draw(
        &self,
        gpu: &TestDevice,
        encoder: &mut wgpu::CommandEncoder,
        frame: &PreparedFrame,
        positions: &wgpu::TextureView,
        normals: &wgpu::TextureView,
        target: &wgpu::TextureView,
    ) {
        let entry = |binding, view| wgpu::BindGroupEntry {
            binding,
            resource: wgpu::BindingResource::TextureView(view),
        };
        let inputs = gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: None,
            layout: &self.inputs,
            entries: &[entry(0, positions), entry(1, normals)],
        });
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: target,
                depth_slice: None,
                resolve_target: None,
                ops: wgpu::Operations::default(),
            })],
            ..Default::default()
        });
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(self.inputs_group, &inputs, &[]);
        pass.set_bind_group(self.shadow_group, frame.shadow_bind_group(), &[]);
        pass.draw(0..3, 0..1);
    }
}

const MATERIAL: &str = "
@group(INPUTS) @binding(0) var engine_positions: texture_2d<f32>;
@group(INPUTS) @binding(1) var engine_normals: texture_2d<f32>;

@vertex
fn engine_vertex(@builtin(vertex_index) corner: u32) -> @builtin(position) vec4<f32> {
    return vec4<f32>(select(-1.0, 3.0, corner == 2u), select(1.0, -3.0, corner == 1u), 0.0, 1.0);
}

@fragment
fn engine_fragment(@builtin(position) pixel: vec4<f32>) -> @location(0) vec4<f32> {
    let position = textureLoad(engine_positions, vec2<i32>(pixel.xy), 0);
    let normal = textureLoad(engine_normals, vec2<i32>(pixel.xy), 0).xyz;
    if position.w == 0.0 { return vec4<f32>(1.0, 0.0, 0.0, 1.0); }
    return vec4<f32>(VISIBILITY, 0.0, 0.0, 1.0);
}
";
