// Fetches a caster's vertices from the engine's own buffers: a triangle that bent rows bend is seen as a whole.

/// A corner of a caster's triangle, or of what is drawn for it.
struct CasterVertex {
    /// Its number in the draw.
    @builtin(vertex_index) number: u32,
    /// First of the instance's rows; they take the object's space to the capture's axes, relative to the eye.
    @location(1) eye_from_object_x: vec4<f32>,
    /// Second row.
    @location(2) eye_from_object_y: vec4<f32>,
    /// Third row.
    @location(3) eye_from_object_z: vec4<f32>,
}

/// Position of a corner of the mesh's triangle list in the capture's axes.
fn corner_position(caster: CasterVertex, corner: u32) -> vec4<f32> {
    let word = mesh_layout[0].x + mesh_vertex(corner) * mesh_layout[0].y;
    let words = vec3<u32>(mesh_positions[word], mesh_positions[word + 1u], mesh_positions[word + 2u]);
    let object = vec4<f32>(decoded(words, mesh_layout[1].x), 1.0);
    return vec4<f32>(
        dot(caster.eye_from_object_x, object),
        dot(caster.eye_from_object_y, object),
        dot(caster.eye_from_object_z, object),
        1.0,
    );
}

/// The vertex of a corner of the mesh's triangle list.
fn mesh_vertex(corner: u32) -> u32 {
    let index = mesh_layout[0].z + corner;
    switch mesh_layout[0].w {
        case 0u: {
            return corner;
        }
        case 1u: {
            return extractBits(mesh_indices[index / 2u], 16u * (index % 2u), 16u);
        }
        default: {
            return mesh_indices[index];
        }
    }
}

/// The floats that a vertex fetch makes of words.
fn decoded(words: vec3<u32>, format: u32) -> vec3<f32> {
    switch format {
        case 0u: {
            return bitcast<vec3<f32>>(words);
        }
        case 1u: {
            return vec3<f32>(half_floats(words.x), half_floats(words.y).x);
        }
        case 2u: {
            return vec3<f32>(unpack2x16snorm(words.x), unpack2x16snorm(words.y).x);
        }
        case 3u: {
            return vec3<f32>(unpack2x16unorm(words.x), unpack2x16unorm(words.y).x);
        }
        case 4u: {
            return unpack4x8snorm(words.x).xyz;
        }
        case 5u: {
            return unpack4x8unorm(words.x).xyz;
        }
        default: {
            return vec3<f32>((vec3<u32>(words.x) >> vec3<u32>(0u, 10u, 20u)) & vec3<u32>(1023u)) / 1023.0;
        }
    }
}

/// The two half floats of a word; infinities are large numbers.
fn half_floats(word: u32) -> vec2<f32> {
    let halves = vec2<u32>(word & 0xffffu, word >> 16u);
    let magnitudes = halves & vec2<u32>(0x7fffu);
    let normal = bitcast<vec2<f32>>((magnitudes << vec2<u32>(13u)) + vec2<u32>(112u << 23u));
    let small = vec2<f32>(magnitudes) * SMALLEST_HALF;
    let values = select(normal, small, magnitudes < vec2<u32>(0x400u));
    return select(values, -values, halves > vec2<u32>(0x7fffu));
}

/// The smallest half float above zero.
const SMALLEST_HALF: f32 = 5.9604645e-8;
