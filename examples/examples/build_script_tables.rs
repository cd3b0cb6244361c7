//! Tables and shaders for an engine that renders by itself.
//!
//! `build.rs` compiled `valley.cssm`; this program includes the result. It links no graphics interface: core and
//! generated code are enough to plan facets, fill the buffers that the generated shaders read, and list the passes
//! that the engine has to record.
//!
//! Run with `cargo run -p cssm-examples --example build_script_tables`.

use std::error::Error;
use std::mem::{offset_of, size_of};

use cssm::core::glam::{DVec3, Vec4};
use cssm::core::table::{GroupContent, ShaderKind, write_capture_record, write_shadow_record};
use cssm::{Light, SceneBounds, View, plan};

include!(concat!(env!("OUT_DIR"), "/valley.rs"));

fn main() -> Result<(), Box<dyn Error>> {
    // The declaration and its table come from the build script.
    let (case, table) = (valley::case(), &valley::TABLE);
    println!(
        "case {}: {} facets at most, map {} x {}",
        case.name,
        table.cells(),
        table.map_width,
        table.map_height
    );

    // Plan a frame: any projection, any light, any place in the world.
    let (eye, target) = (DVec3::new(4.2e6, 310.0, -8.8e5), DVec3::new(4.2e6, 300.0, -8.81e5));
    let view = View::perspective(eye, target, DVec3::Y, 1.0, 0.1, f64::INFINITY, (1920, 1080))?;
    let light = Light::directional_travelling(DVec3::new(0.4, -0.7, 0.3))?;
    let plan = plan(&case, &view, &light, &SceneBounds::default())?;
    println!("configuration {}, {} facets with receivers", plan.configuration, plan.facets.len());

    // Fill the buffers: bytes for the engine's own uploads, or structs where it wants to look inside. Plans are in world
    // axes and f64; records are turned to camera axes and rounded once.
    let bytes = write_shadow_record(table, &plan);
    assert_eq!(bytes.len(), size_of::<valley::ValleyShadow>());
    let shadow: valley::ValleyShadow = bytemuck::pod_read_unaligned(&bytes);
    for facet in &plan.facets {
        let uploaded = &shadow.facets[facet.first_cell() as usize];
        let row_w = plan.camera_from_world * facet.rows.w.truncate();
        let rounding = Vec4::from_array(uploaded.row_w) - row_w.extend(facet.rows.w.w).as_vec4();
        assert!(rounding.length() <= 1e-6 * row_w.length() as f32);
        assert_eq!(write_capture_record(table, &plan, facet).len(), size_of::<valley::ValleyCapture>());
    }
    println!(
        "shadow record: {} bytes, facets from byte {}",
        bytes.len(),
        offset_of!(valley::ValleyShadow, facets)
    );

    // List what the engine records each frame.
    for facet in plan.facets.iter().take(3) {
        let tile = facet.tile;
        println!(
            "facet {}: viewport {} x {} at ({}, {})",
            facet.first_cell(),
            tile.width,
            tile.height,
            tile.x,
            tile.y
        );
    }
    for pass in table.passes.iter() {
        let reads: Vec<_> = pass.reads.iter().map(|resource| resource.name()).collect();
        let writes: Vec<_> = pass.writes.iter().map(|resource| resource.name()).collect();
        println!("pass {}: {} -> {}", pass.vertex, reads.join(", "), writes.join(", "));
    }

    // The function for the engine's materials, and where its bindings go.
    let group =
        table.group(ShaderKind::Function, GroupContent::Shadow).ok_or("the case declares a function")?;
    for binding in group.bindings.iter() {
        println!("@group({}) @binding({}) {}", group.group, binding.binding, binding.name);
    }
    assert!(valley::FUNCTION_WGSL.contains("fn valley_visibility("));
    println!("function: {} lines of WGSL", valley::FUNCTION_WGSL.lines().count());
    Ok(())
}
