// Fetches a caster's texture coordinates from the engine's own buffer.

/// Coordinates of the caster's mask at a corner of the mesh's triangle list.
fn mesh_uv(corner: u32) -> vec2<f32> {
    let word = mesh_layout[1].y + mesh_vertex(corner) * mesh_layout[1].z;
    let words = vec3<u32>(mesh_uvs[word], mesh_uvs[word + 1u], 0u);
    return decoded(words, mesh_layout[1].w).xy;
}
