//! Holes in triangles: which triangles of a scene have a mask, and where they lie in it.

use cssm_core::glam::DVec2;

use crate::scene::{AlphaMask, Mesh, Scene};

/// The masks of a scene's triangles.
pub(super) struct Cutouts {
    /// One for each mesh; without vertices, which the triangles carry.
    masks: Vec<Option<AlphaMask>>,
    /// Index in `placed` of each triangle.
    of_triangle: Vec<Option<u32>>,
    placed: Vec<Placed>,
}

/// A triangle in the texture of its mesh.
struct Placed {
    mesh: u32,
    corner: DVec2,
    edges: [DVec2; 2],
}

impl Cutouts {
    /// The masks of a scene's meshes, still without triangles.
    pub(super) fn new(scene: &Scene) -> Self {
        let textures = scene.meshes.iter().map(|mesh| {
            let mask = mesh.mask.as_ref()?;
            Some(AlphaMask { uvs: Vec::new(), alpha: mask.alpha.clone(), ..*mask })
        });
        Self { masks: textures.collect(), of_triangle: Vec::new(), placed: Vec::new() }
    }

    /// Adds the next triangle: three corners of a mesh. Corners without texture coordinates have no holes.
    pub(super) fn push(&mut self, index: usize, mesh: &Mesh, corners: &[u32]) {
        let uvs = mesh.mask.as_ref().and_then(|mask| {
            let uv = |corner: u32| {
                mask.uvs.get(corner as usize).map(|uv| DVec2::new(f64::from(uv[0]), f64::from(uv[1])))
            };
            Some([uv(corners[0])?, uv(corners[1])?, uv(corners[2])?])
        });
        self.of_triangle.push(uvs.map(|_| self.placed.len() as u32));
        self.placed.extend(uvs.map(|[corner, second, third]| Placed {
            mesh: index as u32,
            corner,
            edges: [second - corner, third - corner],
        }));
    }

    /// Whether a point of a triangle, given by the weights of its second and third corner, is a hole.
    #[inline]
    pub(super) fn is_hole(&self, triangle: u32, weights: [f64; 2]) -> bool {
        let Some(place) = self.of_triangle[triangle as usize] else {
            return false;
        };
        let Placed { mesh, corner, edges } = &self.placed[place as usize];
        let uv = *corner + edges[0] * weights[0] + edges[1] * weights[1];
        self.masks[*mesh as usize].as_ref().is_some_and(|mask| mask.is_hole(uv.x, uv.y))
    }
}
