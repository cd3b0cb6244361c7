//! Many lights in one map: each as good as alone, nothing drawn that is there already, budgets kept, no frame lost.

use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::LazyLock;

use cssm_lab::gpu::{Gpu, SceneBuffers, Surface};
use cssm_lab::lights::{Bench, Host, Town};
use cssm_lab::progress::Progress;
use cssm_lab::scene::Scene;
use cssm_lab::truth::{Frame, Tracer};
use cssm_runtime::lights::{LightDescription, LightOptions, LightReport, LightState, Update};
use cssm_runtime::{Command, Culling, FrameCommands, Options};

const SIZE: (u32, u32) = (320, 180);
const MAP_SIDE: u32 = 2048;

static SCENE: LazyLock<Scene> = LazyLock::new(Scene::city);

fn town(map_side: u32) -> Town<'static> {
    Town::new(&SCENE, SIZE, map_side).unwrap()
}

fn open(town: &Town) -> (Gpu, SceneBuffers) {
    let gpu = Gpu::open(&town.cases.iter().collect::<Vec<_>>(), SIZE).unwrap();
    let buffers = SceneBuffers::new(&gpu, &SCENE).unwrap();
    (gpu, buffers)
}

/// Lights that have texels, by their position in the report.
fn with_texels(report: &LightReport) -> usize {
    report.lights.iter().filter(|light| light.region.is_some()).count()
}

#[test]
fn every_light_is_as_good_in_company_as_alone() {
    let town = town(MAP_SIDE);
    let (gpu, buffers) = open(&town);
    let tracer = Tracer::new(&SCENE);
    let mut host = Host::new(&gpu, &town, &buffers, &LightOptions::default()).unwrap();
    host.frame(&town.view, 0).unwrap();
    let frame = Frame::trace(&tracer, &town.view, &town.lights[0].light, &|_| ());
    let surface = Surface::new(&gpu, &town.view, &frame).unwrap();
    let bench = Bench {
        gpu: &gpu,
        scene: &SCENE,
        tracer: &tracer,
        buffers: &buffers,
        frame: &frame,
        view: town.view,
        surface: &surface,
    };

    // Judge the eight lights that most pixels face.
    let report = host.runner.report().clone();
    let mut lights: Vec<usize> =
        (0..town.lights.len()).filter(|light| report.lights[*light].region.is_some()).collect();
    let facing = |light: &usize| {
        let lit = &town.lights[*light].light;
        let reached = frame.visible().filter(|(_, seen)| lit.reaches(town.view.eye_world + seen.position));
        std::cmp::Reverse(reached.count())
    };
    lights.sort_by_cached_key(facing);
    let mut pixels = 0;
    for light in lights.iter().take(8) {
        let case = &town.cases[town.case(*light).0 as usize];
        let planted = &town.lights[*light];
        let found =
            bench.judge(&host.runner, host.handles[*light], &planted.name, case, planted.light).unwrap();
        pixels += found.judged_pixels;
        assert!(found.excess() <= 2e-4, "{found:?}");
        assert!(found.interior_in_company <= found.interior_alone + 1, "{found:?}");
    }
    assert!(pixels > 40_000, "{pixels} pixels were judged");

    // The judge tells one light's shadows from another's.
    let (sun, other) = (&town.lights[0], lights[1]);
    let swapped =
        bench.judge(&host.runner, host.handles[other], "swapped", &town.cases[0], sun.light).unwrap();
    assert!(swapped.excess() > 0.05, "{swapped:?}");
    assert!(host.judge(&bench, 1, Progress::Hidden).unwrap()[0].excess() <= 2e-4);
}

#[test]
fn a_still_camera_draws_what_moves_and_nothing_else() {
    let town = town(MAP_SIDE);
    let (gpu, buffers) = open(&town);
    let mut host = Host::new(&gpu, &town, &buffers, &LightOptions::default()).unwrap();
    let shown = |host: &Host| {
        let report = host.runner.report().clone();
        let texels = host.runner.map().unwrap();
        let tiles: Vec<_> =
            report.lights.iter().flat_map(|light| light.tiles.iter().map(|tile| tile.tile)).collect();
        let inside = tiles.iter().flat_map(|tile| {
            (tile.y..tile.y + tile.height)
                .flat_map(move |y| (tile.x..tile.x + tile.width).map(move |x| (x, y)))
        });
        inside.map(|(x, y)| texels[(y * MAP_SIDE + x) as usize]).collect::<Vec<_>>()
    };

    host.frame(&town.view, 0).unwrap();
    let first = host.runner.report().clone();
    assert!(first.redrawn_texels > 0 && first.planned > 8);
    host.frame(&town.view, 0).unwrap();
    let report = host.runner.report();
    assert_eq!((report.redrawn_texels, report.draws, report.planned), (0, 0, 0));

    // Cars drive: some tiles change, static casters are drawn apart once, and then never again.
    let mut restored = Vec::new();
    for cars in 1..=4 {
        host.frame(&town.view, cars).unwrap();
        let report = host.runner.report();
        assert!(report.redrawn_texels > 0 && report.redrawn_texels < first.redrawn_texels / 2);
        assert!(report.triangles < first.triangles / 4, "{} of {}", report.triangles, first.triangles);
        restored.push(report.static_texels);
    }
    assert!(restored[0] > 0, "{restored:?}");
    assert!(restored[1..].iter().sum::<u64>() < restored[0], "{restored:?}");

    // What was drawn bit by bit is what a fresh service draws at once.
    let mut fresh = Host::new(&gpu, &town, &buffers, &LightOptions::default()).unwrap();
    fresh.frame(&town.view, 4).unwrap();
    let (bit_by_bit, at_once) = (shown(&host), shown(&fresh));
    assert_eq!(bit_by_bit.len(), at_once.len());
    let differing = bit_by_bit.iter().zip(&at_once).filter(|(one, two)| one != two).count();
    assert_eq!(differing, 0);

    // And a car that drove elsewhere would be seen.
    fresh.frame(&town.view, 9).unwrap();
    let moved = shown(&fresh);
    assert!(bit_by_bit.iter().zip(&moved).any(|(one, two)| one != two));
}

#[test]
fn a_slow_camera_redraws_less_than_a_fast_one() {
    let town = town(MAP_SIDE);
    let (gpu, buffers) = open(&town);
    let costs = |hold: bool, name: &str| {
        let mut host =
            Host::new(&gpu, &town, &buffers, &LightOptions { hold, ..Default::default() }).unwrap();
        let motion = cssm_lab::lights::MOTIONS.iter().find(|motion| motion.name == name).unwrap();
        host.costs(motion, 10).unwrap()
    };
    let (slow, fast) = (costs(true, "slow"), costs(true, "fast"));
    let never_held = costs(false, "slow");
    assert!(slow.redrawn_texels < 0.6 * fast.redrawn_texels, "{slow:?} {fast:?}");
    assert!(slow.redrawn_texels < 0.6 * never_held.redrawn_texels, "{slow:?} {never_held:?}");
}

#[test]
fn budgets_are_kept_and_said() {
    let town = town(MAP_SIDE);
    let (gpu, buffers) = open(&town);
    let options = LightOptions { redrawn_texels: 100_000, ..Default::default() };
    let mut host = Host::new(&gpu, &town, &buffers, &options).unwrap();
    host.frame(&town.view, 0).unwrap();
    host.frame(&town.view, 0).unwrap();

    // Cars wait where the budget ends, and every change arrives in the end.
    host.frame(&town.view, 30).unwrap();
    let report = host.runner.report().clone();
    assert!(report.redrawn_texels <= 100_000, "{}", report.redrawn_texels);
    let mut frames = 0;
    while host.runner.report().waiting > 0 && frames < 100 {
        host.frame(&town.view, 30).unwrap();
        assert!(host.runner.report().redrawn_texels <= 100_000);
        frames += 1;
    }
    assert!(frames > 0, "nothing waited");

    // Update rates: lights that take turns redraw less in a frame.
    let mut host = Host::new(&gpu, &town, &buffers, &LightOptions::default()).unwrap();
    for handle in host.handles.clone() {
        let usual = *host.runner.service.light(handle).unwrap();
        let seldom = LightDescription { update: Update::Every { frames: 4 }, ..usual };
        host.runner.service.update_light(handle, &seldom).unwrap();
    }
    let mut redrawn = Vec::new();
    for cars in 0..6 {
        host.frame(&town.view, cars).unwrap();
        redrawn.push(host.runner.report().redrawn_texels);
    }
    let waiting = host.runner.report().lights.iter().filter(|light| light.state == LightState::Waits);
    assert!(waiting.count() > 0, "{redrawn:?}");
}

#[test]
fn a_map_that_is_too_small_degrades_all_lights_evenly() {
    let (large, small) = (town(2048), town(512));
    let (gpu, buffers) = open(&large);
    let mut pixels = Vec::new();
    for town in [&large, &small] {
        let mut host = Host::new(&gpu, town, &buffers, &LightOptions::default()).unwrap();
        host.frame(&town.view, 0).unwrap();
        let report = host.runner.report();
        assert!(report.owned_texels <= report.map_texels);
        let regions: Vec<_> = report.lights.iter().filter_map(|light| light.region).collect();
        for (index, one) in regions.iter().enumerate() {
            for other in &regions[..index] {
                let apart = one.x + one.width <= other.x
                    || other.x + other.width <= one.x
                    || one.y + one.height <= other.y
                    || other.y + other.height <= one.y;
                assert!(apart, "{one:?} {other:?}");
            }
        }
        let unserved = report
            .lights
            .iter()
            .filter(|light| matches!(light.state, LightState::NoTexels | LightState::Failed(_)));
        pixels.push((with_texels(report), unserved.count(), report.lights[0].p95_pixels));
    }
    assert_eq!(pixels[0].1, 0, "{pixels:?}");
    assert!(pixels[1].0 + pixels[1].1 >= pixels[0].0, "{pixels:?}");
    assert!(pixels[1].2 > pixels[0].2, "{pixels:?}");
}

/// What each facet draws of each instance, which is known by its mesh and its rows: ranges of corners.
type Drawn = BTreeMap<Key, Vec<Range<u32>>>;
type Key = (u32, String, [u32; 12]);

fn drawn(commands: &FrameCommands) -> Drawn {
    let (mut facet_here, mut mesh_here) = (0, String::new());
    let mut drawn = Drawn::new();
    for command in &commands.commands {
        match command {
            Command::Facet { facet, .. } => facet_here = facet.0,
            Command::Mesh(mesh) => mesh_here = format!("{mesh:?}"),
            Command::Draw { first, count, instances, .. } => {
                for row in instances.clone() {
                    let rows = commands.rows[row as usize].0;
                    let bits = std::array::from_fn(|at| rows[at / 4][at % 4].to_bits());
                    let key = (facet_here, mesh_here.clone(), bits);
                    drawn.entry(key).or_default().push(*first..first + count);
                }
            }
            Command::Pipeline(_) => {}
            other => panic!("{other:?} was not read back"),
        }
    }
    drawn
}

/// Corners that one list draws and another, of the same instances, does not.
fn corners_beyond(one: &Drawn, other: &Drawn) -> u32 {
    let of = |(key, ranges): (&Key, &Vec<Range<u32>>)| -> u32 {
        let other = &other[key];
        let lacks = |corner: &u32| !other.iter().any(|range| range.contains(corner));
        ranges.iter().map(|range| range.clone().filter(lacks).count() as u32).sum()
    };
    one.iter().map(of).sum()
}

#[test]
fn lights_culled_on_the_device_see_the_same() {
    let town = town(MAP_SIDE);
    let (gpu, buffers) = open(&town);
    let tracer = Tracer::new(&SCENE);
    let options = |culling| LightOptions {
        service: Options { culling, ..Options::default() },
        ..LightOptions::default()
    };
    let [mut on_cpu, mut on_gpu] = [Culling::Cpu, Culling::Gpu].map(|culling| {
        let host = Host::new(&gpu, &town, &buffers, &options(culling)).unwrap();
        assert_eq!(host.runner.service.culling(), culling);
        host
    });
    let frame = Frame::trace(&tracer, &town.view, &town.lights[0].light, &|_| ());
    let surface = Surface::new(&gpu, &town.view, &frame).unwrap();
    let (mut spared, mut changed) = (0, 0);
    let mut before: Vec<f32> = Vec::new();
    for cars in 0..3 {
        let reports = [&mut on_cpu, &mut on_gpu].map(|host| {
            host.frame(&town.view, cars).unwrap();
            let report = host.runner.report();
            (report.redrawn_texels, report.static_texels, with_texels(report))
        });
        assert_eq!(reports[0], reports[1]);
        assert!(reports[0].0 > 0, "nothing was drawn in frame {cars}");

        // Every facet of every light draws the same instances, and of those no more than the CPU, which also draws what
        // lies between two clusters that reach.
        let [cpu, gpu] = [&on_cpu, &on_gpu].map(|host| host.runner.commands().unwrap());
        assert_eq!(cpu.len(), gpu.len());
        for (cpu, gpu) in cpu.iter().zip(&gpu) {
            let lists = [(&cpu.still, &gpu.still), (&cpu.fixed, &gpu.fixed), (&cpu.dynamic, &gpu.dynamic)];
            for (cpu, gpu) in lists.map(|(cpu, gpu)| (drawn(cpu), drawn(gpu))) {
                assert!(cpu.keys().eq(gpu.keys()), "frame {cars}");
                assert_eq!(corners_beyond(&gpu, &cpu), 0, "frame {cars}");
                spared += corners_beyond(&cpu, &gpu);
            }
        }

        // So nothing differs that a light reaches. Where it does not, there is nothing to be seen, and texels may differ.
        let mut seen_now = Vec::new();
        for light in 0..8 {
            let seen = |host: &Host| host.runner.visibility(host.handles[light], &surface).unwrap();
            let (expected, found) = (seen(&on_cpu), seen(&on_gpu));
            let source = &town.lights[light].light;
            let reached =
                frame.visible().filter(|(_, seen)| source.reaches(town.view.eye_world + seen.position));
            let reached: Vec<usize> = reached.map(|(pixel, _)| pixel).collect();
            let differing = reached.iter().filter(|pixel| expected[**pixel] != found[**pixel]).count();
            assert_eq!(differing, 0, "light {light} in frame {cars}");
            seen_now.extend(reached.iter().map(|pixel| found[*pixel]));
        }
        let dark = seen_now.iter().filter(|visible| **visible < 0.5).count();
        assert!(dark > 1000, "only {dark} dark pixels");
        changed += before.iter().zip(&seen_now).filter(|(before, now)| before != now).count();
        before = seen_now;
    }
    assert!(spared > 1000, "no cluster was told apart");
    assert!(changed > 0, "cars that drive would be seen");
}
