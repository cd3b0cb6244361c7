//! Maps that read the same, and scenes in one mesh.

use cssm_core::ShadowPlan;
use cssm_core::glam::{DAffine3, DMat4, DVec2, DVec3, DVec4};
use cssm_core::plan::DepthOrder;
use cssm_lab::scene::{Instance, Mesh, Scene};

/// A scene's triangles in a single mesh.
pub(crate) fn fused(scene: &Scene) -> Scene {
    let mut mesh = Mesh { name: "all".into(), positions: Vec::new(), indices: Vec::new(), mask: None };
    for instance in &scene.instances {
        let (part, start) = (&scene.meshes[instance.mesh], mesh.positions.len() as u32);
        mesh.positions.extend(part.positions.iter().map(|position| {
            let position = DVec3::from_array(position.map(f64::from));
            instance.world_from_object.transform_point3(position).as_vec3().to_array()
        }));
        mesh.indices.extend(part.indices.iter().map(|index| start + index));
    }
    let instance = Instance { mesh: 0, world_from_object: DAffine3::IDENTITY, colour: [0.5; 3] };
    let (name, views) = (format!("{} in one mesh", scene.name), scene.views.clone());
    Scene { name, meshes: vec![mesh], instances: vec![instance], views, lamps: Vec::new() }
}

/// How many texels differ that a receiver could read: the nearer of the two depths lies in the volume whose shadows can
/// reach the facet's receivers.
pub(crate) fn lost(plan: &ShadowPlan, map: &[f32], expected: &[f32]) -> usize {
    // The rasteriser moves corners by parts of a texel, and more where it clips triangles that reach behind a lamp.
    let tolerance_texels = if plan.light.w > 0.0 { 0.5 } else { 0.05 };
    let counts = plan.facets.iter().map(|facet| {
        let (rows, tile) = (&facet.rows, &facet.tile);
        let from_clip = DMat4::from_cols(rows.x, rows.y, rows.z, rows.w).transpose().inverse();
        let texel = DVec2::new(2.0 / f64::from(tile.width), 2.0 / f64::from(tile.height));
        let reads = |x: u32, y: u32| {
            let at = (y * plan.map_size_texels.0 + x) as usize;
            if map[at] == expected[at] {
                return false;
            }
            let depth = match plan.depth_order {
                DepthOrder::Standard => map[at].min(expected[at]),
                DepthOrder::Reversed => map[at].max(expected[at]),
            };
            let column = f64::from(x - tile.x) + 0.5;
            let row = f64::from(y - tile.y) + 0.5;
            let clip = DVec4::new(column * texel.x - 1.0, 1.0 - row * texel.y, f64::from(depth), 1.0);
            facet.casters.iter().all(|plane| {
                let slope =
                    plane.dot(from_clip.x_axis).abs() * texel.x + plane.dot(from_clip.y_axis).abs() * texel.y;
                plane.dot(from_clip * clip) > tolerance_texels * slope
            })
        };
        let texels =
            (tile.y..tile.y + tile.height).flat_map(|y| (tile.x..tile.x + tile.width).map(move |x| (x, y)));
        texels.filter(|(x, y)| reads(*x, *y)).count()
    });
    counts.sum()
}
