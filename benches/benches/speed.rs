//! Passes on the device and work on the CPU, in turns, with the paper's numbers beside ours.
//!
//! `cargo bench -p cssm-benches --bench speed -- --write` writes `docs/speed.md`. Run as a test, it does the same with a
//! tiny image, small maps and few contenders, and throws the numbers away.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Parser;
use cssm_benches::cpu::{CommandJob, PlanJob, command_jobs, plan_jobs, time_in_turns};
use cssm_benches::error::BenchError;
use cssm_benches::paper;
use cssm_benches::report::{CpuTimes, markdown};
use cssm_benches::run::{Extent, Measurement, measure, opened_for};
use cssm_benches::situation::IMAGE_PIXELS;
use cssm_lab::gpu::Gpu;
use cssm_lab::progress::Progress;
use cssm_lab::scene::Scene;

/// The report's place in the repository, seen from this package.
const REPORT: &str = "../docs/speed.md";

/// Times shadows as ratios inside one run.
#[derive(Debug, Parser)]
struct Arguments {
    /// Turns after warm-up
    #[arg(long, default_value_t = 15)]
    runs: usize,
    /// Sides of the maps in texels; without it, the paper's
    #[arg(long, value_delimiter = ',', default_values_t = paper::MAP_SIDES_TEXELS)]
    maps: Vec<u32>,
    /// Writes docs/speed.md
    #[arg(long)]
    write: bool,
    /// Given by `cargo bench`; without it, a tiny run shows that everything works
    #[arg(long, hide = true)]
    bench: bool,
}

fn main() -> ExitCode {
    let result = if std::env::args().any(|argument| argument == "--bench") { full() } else { tiny() };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("speed: {error}");
            ExitCode::FAILURE
        }
    }
}

/// Measures and prints or writes the report.
fn full() -> Result<(), BenchError> {
    let Arguments { runs, maps, write, .. } = Arguments::parse();
    let extent = Extent {
        image_pixels: IMAGE_PIXELS,
        map_sides_texels: &maps,
        contenders: usize::MAX,
        runs,
        warm_up_runs: 2,
        progress: Progress::Shown,
    };
    let (measured, cpu) = measure_all(&extent, &[Scene::palm(), Scene::city()])?;
    let text = markdown(&measured, &cpu);
    if !write {
        print!("{text}");
        return Ok(());
    }
    let path: PathBuf = Path::new(env!("CARGO_MANIFEST_DIR")).join(REPORT);
    std::fs::write(&path, text).map_err(|source| BenchError::Write { path, source })
}

/// Runs everything once; names of other tests on the command line mean that this one is not asked for.
fn tiny() -> Result<(), BenchError> {
    let names: Vec<_> = std::env::args().skip(1).filter(|argument| !argument.starts_with('-')).collect();
    let listed = std::env::args().any(|argument| argument == "--list");
    if listed || !(names.is_empty() || names.iter().any(|name| "speed".contains(name.as_str()))) {
        return Ok(());
    }
    let extent = Extent {
        image_pixels: (64, 64),
        map_sides_texels: &[320],
        contenders: 3,
        runs: 1,
        warm_up_runs: 0,
        progress: Progress::Hidden,
    };
    let (measured, cpu) = measure_all(&extent, &[Scene::palm()])?;
    let text = markdown(&measured, &cpu);
    println!("speed: a report of {} lines, not kept", text.lines().count());
    Ok(())
}

/// Measures passes on palm, planning on palm, and command building on every scene.
fn measure_all(extent: &Extent<'_>, scenes: &[Scene]) -> Result<(Measurement, Vec<CpuTimes>), BenchError> {
    let palm = Scene::palm();
    let jobs = plan_jobs(&palm)?;
    let mut cases = opened_for(&palm, extent)?;
    cases.extend(jobs.iter().map(|job| job.case.clone()));
    let gpu = Gpu::open(&cases.iter().collect::<Vec<_>>(), extent.image_pixels)?;
    let measured = measure(&gpu, &palm, extent)?;

    let runs = (extent.warm_up_runs, extent.runs);
    let plans = time_in_turns("Planning a frame".to_owned(), &jobs, |job| &job.name, PlanJob::run, runs)?;
    let mut cpu = vec![plans];
    for scene in scenes {
        let jobs = command_jobs(&gpu, scene)?;
        let heading = format!("Building a capture's commands, {}", scene.name);
        cpu.push(time_in_turns(heading, &jobs, |job| &job.name, CommandJob::run, runs)?);
    }
    Ok((measured, cpu))
}
