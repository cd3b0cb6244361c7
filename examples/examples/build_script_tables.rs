//! Tables and SPIR-V for an engine that renders by itself, on any graphics interface.
//!
//! `build.rs` compiled `valley.cssm`; this program includes the result and uses core and generated code alone. It does
//! what such an engine does each frame: plan, write records into one buffer, place casters, list draws and passes. It
//! reads the generated words as a Vulkan engine would load them and holds their entry points and bindings against the
//! table. The f64 twin stands in for the device: it captures the map that the listed draws would.
//!
//! Run with `cargo run -p cssm-examples --example build_script_tables`.

use std::error::Error;
use std::mem::{offset_of, size_of};

use cssm::core::glam::{DAffine3, DVec3, Vec4};
use cssm::core::table::{
    CaseTable, GroupContent, ShaderKind, caster_rows, write_capture_record, write_shadow_record,
};
use cssm::core::twin;
use cssm::{Light, SceneBounds, ShadowPlan, View, plan};
use cssm_examples::write_picture;

include!(concat!(env!("OUT_DIR"), "/valley.rs"));
include!(concat!(env!("OUT_DIR"), "/meadow_stem.rs"));

/// Alignment of uniform records in the engine's buffer.
const ALIGNMENT: usize = 256;

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

    // Load the shader modules, and bind what the table says.
    for shader in table.shaders.iter().filter(|shader| !shader.spirv.is_empty()) {
        let module = Module::read(&shader.spirv)?;
        let pass = table.pass(shader.kind).ok_or("every module with words has a pass")?;
        let mut expected: Vec<_> = table
            .groups
            .iter()
            .filter(|group| group.shader == shader.kind)
            .flat_map(|group| group.bindings.iter().map(|binding| (group.group, binding.binding)))
            .collect();
        expected.sort_unstable();
        assert_eq!(module.bindings, expected, "{}", shader.kind.name());
        let names: Vec<_> = [Some(&pass.vertex), pass.fragment.as_ref()].into_iter().flatten().collect();
        assert!(names.iter().all(|name| module.entry_points.iter().any(|found| *found == ***name)));
        println!(
            "{}: {} words, entry points {}",
            shader.kind.name(),
            shader.spirv.len() / 4,
            module.entry_points.join(", ")
        );
    }

    // The same for shaders around a vertex function of the engine's own.
    let casters = &meadow_stem::CASTERS;
    for shader in casters.shaders.iter() {
        let module = Module::read(&shader.spirv)?;
        let bound = casters.bindings.iter().map(|binding| (binding.group, binding.binding));
        assert!(bound.into_iter().all(|binding| module.bindings.contains(&binding)));
        assert!(module.entry_points.iter().any(|name| *name == *shader.vertex));
    }
    for attribute in casters.attributes.iter() {
        println!(
            "caster {}: location {} is {}: {}",
            casters.name, attribute.location, attribute.name, attribute.ty
        );
    }

    // Plan a frame: any projection, any light, any place in the world.
    let (eye, target) = (DVec3::new(4.2e6, 310.0, -8.8e5), DVec3::new(4.2e6, 300.0, -8.8005e5));
    let view = View::perspective(eye, target, DVec3::Y, 1.0, 0.1, f64::INFINITY, (1920, 1080))?;
    let light = Light::directional_travelling(DVec3::new(0.4, -0.7, 0.3))?;
    let plan = plan(&case, &view, &light, &SceneBounds::default())?;
    println!("configuration {}, {} facets with receivers", plan.configuration, plan.facets.len());

    // Fill the uniform buffer: one capture record for each facet, then the shadow record.
    let (buffer, stride, shadow_offset) = uniform_buffer(table, &plan);
    check_records(&plan, &buffer[shadow_offset..])?;
    println!("uniform buffer: {} bytes, a facet every {stride}, the plan from {shadow_offset}", buffer.len());

    // Place the casters: houses on a slope. Rows are what the capture's instance attributes take.
    let houses: Vec<_> = (0..24).map(|number| house(eye, number)).collect();
    let rows: Vec<_> = houses.iter().filter_map(|house| caster_rows(&plan, house)).collect();
    assert_eq!(rows.len(), houses.len(), "all of them are within reach of f32");

    // List what the engine records: for each facet its tile, its record and the casters that its shadows come from.
    let mut draws = 0;
    for (position, facet) in plan.facets.iter().enumerate() {
        let reaches = |house: &&DAffine3| {
            let centre = house.translation - plan.eye_world;
            let half = DVec3::splat(10.0);
            facet.reached_by(&cssm::BoundingBox { min: centre - half, max: centre + half })
        };
        let count = houses.iter().filter(reaches).count();
        draws += count;
        if count > 0 && position < 4 {
            let (tile, offset) = (facet.tile, position * stride);
            println!(
                "facet {}: viewport {} x {} at ({}, {}), record at {offset}, {count} casters",
                facet.first_cell(),
                tile.width,
                tile.height,
                tile.x,
                tile.y
            );
        }
    }
    assert!(draws > 0 && draws < houses.len() * plan.facets.len(), "facets draw what reaches them");
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

    // What the device would hold after the capture, by the f64 twin.
    let triangles: Vec<_> = houses.iter().flat_map(|house| triangles(house, eye)).collect();
    let map = twin::capture(&plan, &triangles);
    let cleared = plan.depth_order.cleared();
    let covered = map.depths.iter().filter(|depth| **depth != cleared).count();
    println!("{covered} texels hold houses");
    assert!(covered > 2000, "the houses are in the map");
    let grey: Vec<u8> = map.depths.iter().map(|depth| (depth * 255.0) as u8).collect();
    write_picture("build_script_tables", (table.map_width, table.map_height), &grey)
}

/// What a loader looks for in a SPIR-V module.
struct Module {
    entry_points: Vec<String>,
    /// Descriptor sets and bindings, in order.
    bindings: Vec<(u32, u32)>,
}

impl Module {
    /// Walks the instructions of a module: a length and an opcode, then operands.
    fn read(bytes: &[u8]) -> Result<Self, Box<dyn Error>> {
        const MAGIC: u32 = 0x0723_0203;
        const ENTRY_POINT: u32 = 15;
        const DECORATE: u32 = 71;
        const BINDING: u32 = 33;
        const DESCRIPTOR_SET: u32 = 34;
        let words: Vec<u32> = bytemuck::pod_collect_to_vec(bytes);
        if words.len() < 5 || words[0] != MAGIC {
            return Err("this is no SPIR-V".into());
        }
        let (mut entry_points, mut sets, mut numbers) = (Vec::new(), Vec::new(), Vec::new());
        let mut rest = &words[5..];
        while let Some(first) = rest.first() {
            let (length, opcode) = ((first >> 16) as usize, first & 0xffff);
            let (instruction, after) = rest.split_at_checked(length.max(1)).ok_or("a cut instruction")?;
            match (opcode, instruction) {
                (ENTRY_POINT, [_, _, _, name @ ..]) => {
                    let letters = name.iter().flat_map(|word| word.to_le_bytes());
                    let name: Vec<u8> = letters.take_while(|letter| *letter != 0).collect();
                    entry_points.push(String::from_utf8(name)?);
                }
                (DECORATE, [_, variable, DESCRIPTOR_SET, set]) => sets.push((*variable, *set)),
                (DECORATE, [_, variable, BINDING, number]) => numbers.push((*variable, *number)),
                _ => {}
            }
            rest = after;
        }
        let number = |variable: u32| numbers.iter().find(|(known, _)| *known == variable);
        let mut bindings: Vec<_> =
            sets.iter().filter_map(|(variable, set)| Some((*set, number(*variable)?.1))).collect();
        bindings.sort_unstable();
        Ok(Self { entry_points, bindings })
    }
}

/// All records of a frame: the buffer, the distance between facets, where the plan's record begins.
fn uniform_buffer(table: &CaseTable, plan: &ShadowPlan) -> (Vec<u8>, usize, usize) {
    let stride = size_of::<valley::ValleyCapture>().next_multiple_of(ALIGNMENT);
    let shadow_offset = stride * table.cells() as usize;
    let mut buffer = vec![0; shadow_offset];
    for (position, facet) in plan.facets.iter().enumerate() {
        let record = write_capture_record(table, plan, facet);
        buffer[position * stride..][..record.len()].copy_from_slice(&record);
    }
    buffer.extend(write_shadow_record(table, plan));
    (buffer, stride, shadow_offset)
}

/// Looks at the plan's record through the generated struct: plans are in world axes and f64, records in camera axes and
/// rounded once.
fn check_records(plan: &ShadowPlan, bytes: &[u8]) -> Result<(), Box<dyn Error>> {
    assert_eq!(bytes.len(), size_of::<valley::ValleyShadow>());
    assert!(offset_of!(valley::ValleyShadow, facets) < bytes.len());
    let shadow: valley::ValleyShadow = bytemuck::pod_read_unaligned(bytes);
    for facet in &plan.facets {
        let uploaded = &shadow.facets[facet.first_cell() as usize];
        let row_w = plan.camera_from_world * facet.rows.w.truncate();
        let rounding = Vec4::from_array(uploaded.row_w) - row_w.extend(facet.rows.w.w).as_vec4();
        assert!(rounding.length() <= 1e-6 * row_w.length() as f32);
    }
    Ok(())
}

/// Where a house stands: in rows before the eye.
fn house(eye: DVec3, number: usize) -> DAffine3 {
    let (column, row) = ((number % 6) as f64, (number / 6) as f64);
    let place = DVec3::new(column * 16.0 - 40.0, -14.0 - row * 2.0, -20.0 - row * 30.0);
    DAffine3::from_translation(eye + place) * DAffine3::from_rotation_y(number as f64)
}

/// Triangles of a house relative to the eye: a box of 5 x 4 x 5 metres.
fn triangles(house: &DAffine3, eye: DVec3) -> Vec<[DVec3; 3]> {
    let corner = |index: usize| {
        let sign = |axis: usize| if index >> axis & 1 == 0 { -1.0 } else { 1.0 };
        house.transform_point3(DVec3::new(2.5 * sign(0), 2.0 * sign(1), 2.5 * sign(2))) - eye
    };
    let faces = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]];
    faces.iter().flat_map(|[a, b, c, d]| [[*a, *b, *c], [*a, *c, *d]]).map(|face| face.map(corner)).collect()
}
