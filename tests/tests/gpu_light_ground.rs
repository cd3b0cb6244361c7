//! Lights of the light service whose cases make masks of planes: captured, prefiltered and resolved side by side, each as the
//! twin and the case alone have it; also where a held plan serves a later eye, and where only some tiles are drawn and
//! filtered anew.

use cssm_core::LightCase;
use cssm_core::case::{Bias, Casters, Filter, LightKind, MaskDepth, MaskNormal, Resolve};
use cssm_core::glam::{DAffine3, DQuat, DVec3};
use cssm_core::table::CaseTable;
use cssm_core::twin::DepthMap;
use cssm_core::{Light, View};
use cssm_runtime::lights::{
    CaseHandle, LightDescription, LightFrame, LightHandle, LightOptions, LightReport, ViewId,
};
use cssm_runtime::{
    CasterInstance, LightService, MaskInputs, MeshHandle, Options, PreparedLights, read_back, wgpu,
};
use cssm_tests::gpu::casters::GeometryBuffers;
use cssm_tests::gpu::ground::{Masked, bounds};
use cssm_tests::gpu::resolve::Visible;
use cssm_tests::gpu::score::Score;
use cssm_tests::gpu::stage::{Drawn, Stage};
use cssm_tests::gpu::yard::{ORIGIN, Yard, lights, views};
use cssm_tests::gpu::{TestDevice, exclusive, images};

const SIZE: (u32, u32) = (160, 90);
const MAP_SIDE: u32 = 1024;
/// The ground, and a face of a box.
const PLANES: u32 = 2;
/// Levels of a channel that the rounding of one eye's rows against another's may take.
const LEVELS: u8 = 2;

/// Where the eye and the box that moves are in each frame, metres: the eye drifts, then the box does.
const FRAMES: [(f64, f64); 5] = [(0.0, 0.0), (0.04, 0.0), (0.08, 0.0), (0.08, 1.5), (0.09, 1.5)];

/// A case whose record fits into the smallest uniform buffers.
fn case(name: &str, light: LightKind) -> LightCase {
    let configuration = if light.is_local() { "cube" } else { "face_columns" };
    let mask = Resolve::Mask { depth: MaskDepth::Linear, normal: MaskNormal::Texture };
    LightCase::builder(name)
        .prefix(&name.to_lowercase())
        .light(light)
        .configurations(&[configuration])
        .filter(Filter::GroundMasks { planes: PLANES, blur_metres: 0.4, reach_texels: 6 })
        .bias(Bias::ReceiverPlane)
        .casters(Casters::Opaque)
        .map_size_texels(MAP_SIDE, MAP_SIDE)
        .resolve(&[mask])
        .build()
        .unwrap()
}

/// A service with a sun and a lamp, and the yard in it.
struct Town<'a> {
    gpu: &'a TestDevice,
    cases: Vec<LightCase>,
    service: LightService,
    lights: Vec<LightHandle>,
    meshes: Vec<MeshHandle>,
    prepared: PreparedLights,
    _buffers: Vec<GeometryBuffers>,
}

impl<'a> Town<'a> {
    fn new(gpu: &'a TestDevice, yard: &Yard) -> Self {
        let kinds = [("Sun", LightKind::Directional), ("Lamp", LightKind::Omni)];
        let cases: Vec<LightCase> = kinds.map(|(name, kind)| case(name, kind)).into();
        let tables: Vec<CaseTable> =
            cases.iter().map(|case| cssm_codegen::generate(case).unwrap().table).collect();
        let declared: Vec<_> = cases.iter().zip(&tables).collect();
        let mut service =
            LightService::new(&gpu.device, &gpu.queue, &declared, &LightOptions::default()).unwrap();
        let mut add = |(number, light): (u32, Light)| {
            service.add_light(&LightDescription::new(CaseHandle(number), light)).unwrap()
        };
        let placed = kinds.map(|(_, kind)| lights(kind)[0]);
        let lights = (0..).zip(placed).map(&mut add).collect();
        let buffers = yard.upload(gpu);
        let meshes =
            buffers.iter().map(|buffers| service.add_mesh(&buffers.description()).unwrap()).collect();
        Self { gpu, cases, service, lights, meshes, prepared: PreparedLights::new(), _buffers: buffers }
    }

    /// Draws a frame whose last place moves; what every light made of it.
    fn frame(&mut self, view: &View, yard: &Yard, visible: &Visible) -> (LightReport, Vec<Drawn>) {
        let casters: Vec<CasterInstance> = yard
            .places
            .iter()
            .map(|(shape, at)| CasterInstance { mesh: self.meshes[*shape], world_from_object: *at })
            .collect();
        let (still, moving) = casters.split_at(casters.len() - 1);
        let frame = LightFrame { bounds: bounds(PLANES), ..LightFrame::new(view, still, moving) };
        self.service.prepare(&frame, &mut self.prepared).unwrap();
        let mut encoder = self.gpu.device.create_command_encoder(&Default::default());
        self.service.capture(&mut encoder, &self.prepared, None).unwrap();

        // Resolve every light through its mask pass.
        let (gpu, size) = (self.gpu, visible.size);
        let depth = images::float_texture(gpu, size, &visible.linear_depths());
        let normals = images::vector_texture(gpu, size, &visible.normals(self.cases[0].axes));
        let [depth, normals] = [depth, normals].map(|texture| texture.create_view(&Default::default()));
        let inputs = MaskInputs { depth: &depth, normal: Some(&normals) };
        let masks: Vec<wgpu::Texture> = self
            .lights
            .iter()
            .map(|light| {
                let target = images::target(gpu, size, wgpu::TextureFormat::R8Unorm);
                let shown = target.create_view(&Default::default());
                self.service.mask(&mut encoder, &self.prepared, *light, &inputs, &shown, None).unwrap();
                target
            })
            .collect();
        gpu.queue.submit([encoder.finish()]);

        let map = self.map();
        let drawn = |(light, mask): (&LightHandle, &wgpu::Texture)| Drawn {
            plan: self.service.plan(*light, ViewId::default()).unwrap().rebased(view),
            map: map.clone(),
            mask: Some(images::red(gpu, mask)),
            material: None,
        };
        let drawn = self.lights.iter().zip(&masks).map(drawn).collect();
        (self.prepared.report().clone(), drawn)
    }

    /// The map that all lights share.
    fn map(&self) -> DepthMap {
        let map = self.service.map();
        let bytes = read_back::texture_bytes(&self.gpu.device, &self.gpu.queue, map).unwrap();
        let depth = |texel: &[u8]| f64::from(f32::from_le_bytes([texel[0], texel[1], texel[2], texel[3]]));
        DepthMap {
            width: map.width(),
            height: map.height(),
            depths: bytes.chunks_exact(4).map(depth).collect(),
        }
    }
}

/// The yard with a box before the eye that has moved so far.
fn yard(moved: f64) -> Yard {
    let mut yard = Yard::new();
    let at = ORIGIN + DVec3::new(-2.5 + moved, 0.0, -7.0);
    let size = DVec3::new(1.0, 1.5, 1.0);
    yard.places.push((1, DAffine3::from_scale_rotation_translation(size, DQuat::IDENTITY, at)));
    yard
}

fn view(drift: f64) -> View {
    let view = views(SIZE)[0];
    View { eye_world: view.eye_world + DVec3::new(drift, 0.0, 0.0), ..view }
}

#[test]
fn masks_of_planes_are_as_good_in_company_as_alone() {
    let gpu = exclusive();
    let mut town = Town::new(&gpu, &yard(0.0));
    let mut earlier: Vec<Drawn> = Vec::new();
    let (mut held, mut in_part) = (0, 0);
    for (number, (drift, moved)) in FRAMES.into_iter().enumerate() {
        let (view, yard) = (view(drift), yard(moved));
        let visible = Visible::new(&view, &yard.triangles_from_eye(&view));
        let (report, drawn) = town.frame(&view, &yard, &visible);
        let drifts = number > 0 && drift != FRAMES[number - 1].0;
        for light in &report.lights {
            held += u32::from(drifts && light.held_frames > 0);
            let redrawn = light.tiles.iter().filter(|tile| tile.redrawn).count();
            in_part += u32::from((1..light.tiles.len()).contains(&redrawn));
        }
        for (light, drawn) in drawn.iter().enumerate() {
            let case = &town.cases[light];
            let found = Masked::of(case, drawn, &visible);
            let what = format!("frame {number}, {}: {found:?}", case.name);
            println!("{what}, {} planned, {} texels redrawn", report.planned, report.redrawn_texels);
            assert!(found.pixels > 3000 && found.soft > 100, "{what}");
            assert!(found.mask_wrong * 1000 <= found.pixels, "{what}");

            // All other receivers compare depths.
            let mut score = Score::default();
            score.add(case, drawn, &visible);
            assert!(score.mask_wrong * 500 <= score.judged, "{what} {score:?}");

            // The case alone, by the same plan, shows the same.
            let alone =
                Stage::new(&gpu, &yard, case, &Options::default()).draw(drawn.plan.clone(), &view, &visible);
            let different = differing(drawn, &alone);
            assert!(different * 500 <= visible.hits.len(), "{what}: {different} differ from the case alone");

            // A twin without masks disagrees.
            let gathered = LightCase { filter: Filter::Gather2x2, ..case.clone() };
            let without = Masked::of(&gathered, drawn, &visible).mask_wrong;
            assert!(without > 50 + 5 * found.mask_wrong, "{what}: {without}");
        }

        // Where the box has moved, masks of an earlier frame are wrong.
        if number > 0 && moved != FRAMES[number - 1].1 {
            for ((case, drawn), earlier) in town.cases.iter().zip(&drawn).zip(&earlier) {
                let stale = Drawn {
                    plan: drawn.plan.clone(),
                    map: drawn.map.clone(),
                    mask: earlier.mask.clone(),
                    material: None,
                };
                let wrong = Masked::of(case, &stale, &visible).mask_wrong;
                assert!(wrong > 50, "{}: {wrong} pixels of an old mask are wrong", case.name);
            }
        }
        earlier = drawn;
    }
    assert!(held > 0, "no plan served a later eye");
    assert!(in_part > 0, "all tiles of a light were drawn anew whenever any was");
}

/// Pixels at which two masks differ by more than rounding.
fn differing(one: &Drawn, other: &Drawn) -> usize {
    let (one, other) = (one.mask.as_ref().unwrap(), other.mask.as_ref().unwrap());
    one.iter().zip(other).filter(|(one, other)| one.abs_diff(**other) > LEVELS).count()
}
