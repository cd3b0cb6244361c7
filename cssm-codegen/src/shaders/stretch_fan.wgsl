// Numbers of a fan of six corners around a triangle: four triangles, twelve vertices.

/// First corner, in the mesh's triangle list, of the triangle that a vertex is drawn for.
fn fan_triangle(vertex: u32) -> u32 {
    return vertex / 12u * 3u;
}

/// Which of the six corners a vertex is.
fn fan_corner(vertex: u32) -> u32 {
    let corner = vertex % 3u;
    return select(vertex % 12u / 3u + corner, 0u, corner == 0u);
}
