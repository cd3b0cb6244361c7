//! Criterion's view of the work on the CPU: planning every declaration that ships, alone and frame by frame,
//! holding its plan, and building a capture's
//! commands.

use std::hint::black_box;
use std::process::ExitCode;

use criterion::Criterion;
use cssm_benches::cpu::{command_jobs, plan_jobs};
use cssm_benches::error::BenchError;
use cssm_core::LightCase;
use cssm_lab::gpu::Gpu;
use cssm_lab::scene::Scene;

fn main() -> ExitCode {
    let mut criterion = Criterion::default().configure_from_args();
    if let Err(error) = run(&mut criterion) {
        eprintln!("planning: {error}");
        return ExitCode::FAILURE;
    }
    criterion.final_summary();
    ExitCode::SUCCESS
}

fn run(criterion: &mut Criterion) -> Result<(), BenchError> {
    planning(criterion)?;
    remaking(criterion)?;
    holding(criterion)?;
    commands(criterion)
}

fn planning(criterion: &mut Criterion) -> Result<(), BenchError> {
    let mut group = criterion.benchmark_group("plan");
    for job in plan_jobs(&Scene::palm())? {
        job.run()?;
        group.bench_function(&job.name, |bencher| bencher.iter(|| black_box(&job).run()));
    }
    group.finish();
    Ok(())
}

fn remaking(criterion: &mut Criterion) -> Result<(), BenchError> {
    let mut group = criterion.benchmark_group("remake");
    for job in plan_jobs(&Scene::palm())? {
        let mut remade = job.remade()?;
        group.bench_function(&job.name, |bencher| bencher.iter(|| black_box(remade())));
    }
    group.finish();
    Ok(())
}

fn holding(criterion: &mut Criterion) -> Result<(), BenchError> {
    let mut group = criterion.benchmark_group("hold");
    for job in plan_jobs(&Scene::palm())? {
        let mut held = job.held()?;
        group.bench_function(&job.name, |bencher| bencher.iter(|| black_box(held())));
    }
    group.finish();
    Ok(())
}

fn commands(criterion: &mut Criterion) -> Result<(), BenchError> {
    let scene = Scene::palm();
    let cases: Vec<LightCase> = plan_jobs(&scene)?.into_iter().map(|job| job.case).collect();
    let gpu = Gpu::open(&cases.iter().collect::<Vec<_>>(), (1, 1))?;
    let mut group = criterion.benchmark_group("commands");
    for job in command_jobs(&gpu, &scene)? {
        job.run()?;
        group.bench_function(&job.name, |bencher| bencher.iter(|| black_box(&job).run()));
    }
    group.finish();
    Ok(())
}
