//! Shadow maps of the shipped cases, drawn by the f64 twin and locked as pictures.
//!
//! No driver takes part, so the pictures hold on any machine; the comparator allows what rounding of transcendental
//! functions and of scene construction may change.

use cssm_core::case::LightCase;
use cssm_core::glam::{DVec2, DVec3};
use cssm_core::twin::{DepthMap, Triangle, capture_tested};
use cssm_core::{SceneBounds, ShadowPlan, plan};
use cssm_lab::catalogue;
use cssm_lab::scene::{AlphaMask, Scene};
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

/// Sixteen bits of a depth. A local light's is one over distance, most of it near zero: its fourth root is stored.
fn encode(map: &DepthMap, is_local: bool) -> Vec<u8> {
    let spread = |depth: f64| if is_local { depth.sqrt().sqrt() } else { depth };
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, map.width, map.height);
    encoder.set_color(png::ColorType::Grayscale);
    encoder.set_depth(png::BitDepth::Sixteen);
    let texels =
        map.depths.iter().flat_map(|depth| ((spread(*depth) * 65535.0).round() as u16).to_be_bytes());
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

/// What the twin draws: a plan, triangles relative to the eye, and the mask and texture coordinates of those that have
/// one.
struct Situation<'a> {
    plan: ShadowPlan,
    triangles: Vec<Triangle>,
    cutouts: Vec<Option<(&'a AlphaMask, [DVec2; 3])>>,
}

impl<'a> Situation<'a> {
    /// The first situation of a scene with a light that the case is made for; else the first of its kind.
    fn new(scene: &'a Scene, case: &LightCase) -> Self {
        let planned = |situation: &catalogue::Situation| {
            let bounds = SceneBounds::of(scene.bounds_world());
            plan(case, &situation.view, &situation.light, &bounds).unwrap()
        };
        let made_for = |plan: &ShadowPlan| plan.choice.complete && plan.choice.made_for_position.is_empty();
        let situations = catalogue::situations(scene, (640, 360)).unwrap();
        let own = situations.iter().filter(|situation| situation.light.kind() == case.light);
        let mut plans: Vec<ShadowPlan> = own.map(planned).collect();
        let best = plans.iter().position(made_for).unwrap_or(0);
        let plan = plans.swap_remove(best);
        let eye = plan.eye_world;
        let mut situation = Self { plan, triangles: Vec::new(), cutouts: Vec::new() };
        for instance in &scene.instances {
            let mesh = &scene.meshes[instance.mesh];
            for corners in mesh.indices.chunks_exact(3) {
                let corners = [corners[0], corners[1], corners[2]].map(|corner| corner as usize);
                situation.triangles.push(corners.map(|corner| {
                    let object = DVec3::from(mesh.positions[corner].map(f64::from));
                    instance.world_from_object.transform_point3(object) - eye
                }));
                situation.cutouts.push(
                    mesh.mask.as_ref().map(|mask| {
                        (mask, corners.map(|corner| DVec2::from(mask.uvs[corner].map(f64::from))))
                    }),
                );
            }
        }
        situation
    }

    fn map(&self) -> Vec<u8> {
        let map = capture_tested(&self.plan, &self.triangles, |index, weights| {
            self.cutouts[index].is_none_or(|(mask, uvs)| {
                let uv = uvs[0] * weights.x + uvs[1] * weights.y + uvs[2] * weights.z;
                !mask.is_hole(uv.x, uv.y)
            })
        });
        encode(&map, self.plan.light.w > 0.0)
    }
}

fn sized(text: &str, size: u32) -> LightCase {
    let mut case = cssm_codegen::dsl::parse_file("case.cssm", text).unwrap().remove(0);
    (case.map.width, case.map.height) = (size, size);
    case
}

fn lock(name: &str, scene: &Scene, case: &LightCase) -> Vec<u8> {
    let picture = Situation::new(scene, case).map();
    let mut settings = Settings::clone_current();
    settings.set_snapshot_path("maps");
    settings.set_prepend_module_to_snapshot(false);
    settings.set_comparator(Box::new(DepthPictures));
    settings.bind(|| insta::assert_binary_snapshot!(&format!("{name}.png"), picture.clone()));
    picture
}

#[test]
fn maps_of_the_shipped_cases_are_locked() {
    for scene in [Scene::palm(), Scene::city(), Scene::pavilion(), Scene::forest()] {
        for text in shipped::ALL {
            let case = sized(text, 256);
            lock(&format!("{}_{}", scene.name, case.prefix), &scene, &case);
        }
    }
}

#[test]
fn maps_of_every_configuration_and_distribution_are_locked() {
    let scene = Scene::palm();
    for kind in catalogue::KINDS {
        for entry in catalogue::entries(kind).unwrap() {
            let mut case = entry.case;
            (case.map.width, case.map.height) = (256, 256);
            lock(&format!("every_{}", entry.name.replace(' ', "_")), &scene, &case);
        }
    }
}

#[test]
fn fewer_bands_change_the_picture() {
    let palm = Scene::palm();
    let of = |bands: &str| {
        let case = sized(&shipped::SUN.replace("bands(8)", bands), 256);
        Situation::new(&palm, &case).map()
    };
    let (eight, five) = (of("bands(8)"), of("bands(5)"));
    assert_eq!(differing_share(&eight, &of("bands(8)")), Some(0.0));
    assert!(differing_share(&eight, &five).unwrap() > 10.0 * EDGE_SHARE);
}

#[test]
fn a_missing_caster_is_seen() {
    let palm = Scene::palm();
    let case = sized(shipped::SUN, 256);
    let mut situation = Situation::new(&palm, &case);
    let whole = situation.map();
    situation.triangles.truncate(situation.triangles.len() / 2);
    assert!(differing_share(&whole, &situation.map()).unwrap() > EDGE_SHARE);
}

#[test]
fn leaves_without_their_holes_are_seen() {
    let forest = Scene::forest();
    let mut situation = Situation::new(&forest, &sized(shipped::SUN, 256));
    let cut = situation.map();
    situation.cutouts.fill(None);
    assert!(differing_share(&cut, &situation.map()).unwrap() > EDGE_SHARE);
}
