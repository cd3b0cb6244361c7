//! Shadow maps of the shipped cases, drawn by the f64 twin and locked as pictures.
//!
//! No driver takes part, so the pictures hold on any machine; the comparator allows what rounding of transcendental
//! functions and of scene construction may change.

use cssm_core::case::LightCase;
use cssm_core::glam::DVec3;
use cssm_core::twin::{DepthMap, Triangle, capture};
use cssm_core::{Light, SceneBounds, ShadowPlan, View, plan};
use cssm_lab::scene::Scene;
use insta::internals::SnapshotContents;
use insta::{Comparator, Settings, Snapshot};
use shaders_gen::shipped;

/// Largest difference of a stored 16-bit depth that counts as equal.
const DEPTH_TOLERANCE: u16 = 32;
/// Share of texels that may differ more: triangle edges that rounding moved over a texel centre.
const EDGE_SHARE: f64 = 2e-3;

/// Decodes both pictures and compares texel by texel.
#[derive(Clone)]
struct DepthPictures;

impl Comparator for DepthPictures {
    fn matches(&self, reference: &Snapshot, test: &Snapshot) -> bool {
        match (reference.contents(), test.contents()) {
            (SnapshotContents::Binary(Some(reference)), SnapshotContents::Binary(Some(test))) => {
                differing_share(reference.as_slice(), test.as_slice())
                    .is_some_and(|share| share <= EDGE_SHARE)
            }
            _ => false,
        }
    }

    fn dyn_clone(&self) -> Box<dyn Comparator> {
        Box::new(self.clone())
    }
}

/// Share of texels that differ by more than the tolerance; `None` when the sizes differ or a file is no picture.
fn differing_share(reference: &[u8], test: &[u8]) -> Option<f64> {
    let (reference, test) = (decode(reference)?, decode(test)?);
    if reference.0 != test.0 {
        return None;
    }
    let differs = |(one, two): &(&u16, &u16)| one.abs_diff(**two) > DEPTH_TOLERANCE;
    let count = reference.1.iter().zip(&test.1).filter(differs).count();
    Some(count as f64 / reference.1.len() as f64)
}

fn encode(map: &DepthMap) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, map.width, map.height);
    encoder.set_color(png::ColorType::Grayscale);
    encoder.set_depth(png::BitDepth::Sixteen);
    let texels = map.depths.iter().flat_map(|depth| ((depth * 65535.0).round() as u16).to_be_bytes());
    let texels: Vec<u8> = texels.collect();
    encoder.write_header().unwrap().write_image_data(&texels).unwrap();
    bytes
}

fn decode(bytes: &[u8]) -> Option<((u32, u32), Vec<u16>)> {
    let mut reader = png::Decoder::new(std::io::Cursor::new(bytes)).read_info().ok()?;
    let mut buffer = vec![0; reader.output_buffer_size()?];
    let info = reader.next_frame(&mut buffer).ok()?;
    let texels = buffer.chunks_exact(2).map(|pair| u16::from_be_bytes([pair[0], pair[1]]));
    Some(((info.width, info.height), texels.collect()))
}

/// The first view of a scene, its plan under a case, and its triangles relative to the eye.
fn situation(scene: &Scene, case: &LightCase) -> (ShadowPlan, Vec<Triangle>) {
    let viewpoint = scene.views[0];
    let (eye, target) = (viewpoint.eye_world, viewpoint.target_world);
    let view = View::perspective(eye, target, DVec3::Y, 1.0, 0.1, f64::INFINITY, (640, 360)).unwrap();
    let light = Light::directional_travelling(viewpoint.light_travels).unwrap();
    let plan = plan(case, &view, &light, &SceneBounds { receivers: scene.bounds_world() }).unwrap();
    let triangles = scene.instances.iter().flat_map(|instance| {
        let mesh = &scene.meshes[instance.mesh];
        let corner = move |index: &u32| {
            let [x, y, z] = mesh.positions[*index as usize].map(f64::from);
            instance.world_from_object.transform_point3(DVec3::new(x, y, z)) - eye
        };
        mesh.indices.chunks_exact(3).map(move |corners| [&corners[0], &corners[1], &corners[2]].map(corner))
    });
    (plan, triangles.collect())
}

fn sized(text: &str, size: u32) -> LightCase {
    let mut case = cssm_codegen::dsl::parse_file("case.cssm", text).unwrap().remove(0);
    (case.map.width, case.map.height) = (size, size);
    case
}

fn lock(name: &str, scene: &Scene, case: &LightCase) -> Vec<u8> {
    let (plan, triangles) = situation(scene, case);
    let picture = encode(&capture(&plan, &triangles));
    let mut settings = Settings::clone_current();
    settings.set_snapshot_path("maps");
    settings.set_prepend_module_to_snapshot(false);
    settings.set_comparator(Box::new(DepthPictures));
    settings.bind(|| insta::assert_binary_snapshot!(&format!("{name}.png"), picture.clone()));
    picture
}

#[test]
fn maps_of_the_shipped_cases_are_locked() {
    let (palm, city) = (Scene::palm(), Scene::city());
    lock("palm_sun", &palm, &sized(shipped::SUN, 512));
    lock("palm_pssm4_log", &palm, &sized(shipped::PSSM4_LOG, 512));
    lock("palm_standard", &palm, &sized(shipped::STANDARD, 512));
    lock("city_sun", &city, &sized(shipped::SUN, 512));
    lock("city_pssm4_log", &city, &sized(shipped::PSSM4_LOG, 512));
}

#[test]
fn fewer_bands_change_the_picture() {
    let palm = Scene::palm();
    let of = |bands: &str| {
        let case = sized(&shipped::SUN.replace("bands(8)", bands), 256);
        let (plan, triangles) = situation(&palm, &case);
        encode(&capture(&plan, &triangles))
    };
    let (eight, five) = (of("bands(8)"), of("bands(5)"));
    assert_eq!(differing_share(&eight, &of("bands(8)")), Some(0.0));
    assert!(differing_share(&eight, &five).unwrap() > 10.0 * EDGE_SHARE);
}

#[test]
fn a_missing_caster_is_seen() {
    let palm = Scene::palm();
    let case = sized(shipped::SUN, 256);
    let (plan, mut triangles) = situation(&palm, &case);
    let whole = encode(&capture(&plan, &triangles));
    triangles.truncate(triangles.len() / 2);
    assert!(differing_share(&whole, &encode(&capture(&plan, &triangles))).unwrap() > EDGE_SHARE);
}
