// Colours every pixel by the facet that it reads: the walk of the plan as data, whichever shape it has.
// `Settings`, and the names of rows and curves, stand before this text.

@group(0) @binding(0) var<uniform> settings: Settings;
@group(0) @binding(1) var numbers: texture_2d<f32>;
@group(0) @binding(2) var stored_depth: texture_depth_2d;
@group(0) @binding(3) var linear_depth: texture_2d<f32>;

fn number(index: u32) -> vec4<f32> {
    return textureLoad(numbers, vec2<u32>(index % ROW_TEXELS, index / ROW_TEXELS), 0);
}

@vertex
fn overlay_vertex(@builtin(vertex_index) index: u32) -> @builtin(position) vec4<f32> {
    let x = select(-1.0, 3.0, index == 2u);
    let y = select(1.0, -3.0, index == 1u);
    return vec4<f32>(x, y, 0.0, 1.0);
}

// The sector of a point, halves counted through.
fn sector_of(point: vec4<f32>) -> u32 {
    let is_behind = settings.has_split == 1u && dot(number(PLAN_SPLIT), point) < 0.0;
    let half = u32(is_behind);
    let start = half * settings.sectors;
    if settings.borders == 0u {
        return start;
    }
    var walked = 0u;
    if dot(number(settings.borders + start), point) >= 0.0 {
        while walked + 1u < settings.sectors
            && dot(number(settings.borders + start + walked + 1u), point) >= 0.0 {
            walked++;
        }
    } else {
        walked = settings.sectors - 1u;
        while walked > 0u && dot(number(settings.borders + start + walked), point) < 0.0 {
            walked--;
        }
    }
    return start + walked;
}

fn cell_of(point: vec4<f32>) -> u32 {
    if settings.has_dominant == 1u
        && abs(dot(number(PLAN_DOMINANT), point)) <= point.w
        && dot(number(PLAN_DOMINANT_FRONT), point) >= 0.0 {
        return settings.cell_count - 1u;
    }
    let sector = sector_of(point);
    var band = 0u;
    if settings.distances > 0u {
        let distance = dot(number(settings.distances + sector), point);
        var unit = point.w;
        if settings.units > 0u {
            unit = dot(number(settings.units + sector), point);
        }
        for (var limit = 0u; limit + 1u < settings.bands; limit++) {
            let limits = number(settings.thresholds + sector * settings.threshold_rows + limit / 4u);
            band += u32(distance >= limits[limit % 4u] * unit);
        }
    }
    return sector * settings.bands + band;
}

// A pixel's point relative to the eye, camera axes; w = 0 in the sky.
fn point_at(pixel: vec2<i32>, depth: f32) -> vec4<f32> {
    let place = vec2<f32>(pixel) + 0.5;
    let ray = settings.ray_corner + settings.ray_across * place.x + settings.ray_down * place.y;
    return vec4<f32>(ray.xyz * depth, select(0.0, 1.0, depth > 0.0));
}

fn depth_of_stored(stored: f32) -> f32 {
    let inverse = stored * settings.inverse_depth.x + settings.inverse_depth.y;
    return select(0.0, 1.0 / inverse, stored > 0.0 && inverse > 0.0);
}

// What y/w of a bent facet becomes.
fn bent(curve: vec4<f32>, k: f32) -> f32 {
    var value = k;
    if curve.x == PERSPECTIVE {
        value = k / (1.0 + curve.w * k);
    }
    if curve.x == LOGARITHMIC {
        // The reference is in the shift already.
        let horizon = curve.w;
        value = -log(max(k, 1e-30));
        if k * horizon <= 1.0 {
            value = log(horizon) + 1.0 - horizon * k;
        }
    }
    return curve.y * value + curve.z;
}

// A facet's colour at a point; a pixel next to another cell is the border.
fn shade(point: vec4<f32>, right: vec4<f32>, below: vec4<f32>) -> vec4<f32> {
    if point.w == 0.0 {
        return vec4<f32>(0.0);
    }
    let cell = cell_of(point);
    let owner = number(settings.cells + cell).x;
    if cell >= settings.cell_count || owner < 0.0 {
        return vec4<f32>(0.0);
    }
    let facet = settings.facets + u32(owner) * FACET_ROWS;
    var colour = number(facet + FACET_COLOUR).rgb;

    // Draw texels as a checker.
    if settings.checker_texels > 0.0 {
        let w = dot(number(facet + FACET_W), point);
        let tile = number(facet + FACET_TILE);
        let x = dot(number(facet + FACET_X), point) / w;
        let y = bent(number(facet + FACET_CURVE), dot(number(facet + FACET_Y), point) / w);
        let texel = tile.xy + vec2<f32>(0.5 + 0.5 * x, 0.5 - 0.5 * y) * tile.zw;
        let square = vec2<i32>(floor(texel / settings.checker_texels));
        if ((square.x + square.y) & 1) == 1 {
            colour *= 0.6;
        }
    }
    let is_border = (right.w > 0.0 && number(settings.cells + cell_of(right)).x != owner)
        || (below.w > 0.0 && number(settings.cells + cell_of(below)).x != owner);
    if is_border {
        return vec4<f32>(0.0, 0.0, 0.0, 1.0);
    }
    return vec4<f32>(colour, settings.opacity);
}

@fragment
fn overlay_stored(@builtin(position) place: vec4<f32>) -> @location(0) vec4<f32> {
    let pixel = vec2<i32>(place.xy);
    let last = vec2<i32>(textureDimensions(stored_depth)) - 1;
    let right = min(pixel + vec2<i32>(1, 0), last);
    let below = min(pixel + vec2<i32>(0, 1), last);
    return shade(
        point_at(pixel, depth_of_stored(textureLoad(stored_depth, pixel, 0))),
        point_at(right, depth_of_stored(textureLoad(stored_depth, right, 0))),
        point_at(below, depth_of_stored(textureLoad(stored_depth, below, 0))),
    );
}

@fragment
fn overlay_linear(@builtin(position) place: vec4<f32>) -> @location(0) vec4<f32> {
    let pixel = vec2<i32>(place.xy);
    let last = vec2<i32>(textureDimensions(linear_depth)) - 1;
    let right = min(pixel + vec2<i32>(1, 0), last);
    let below = min(pixel + vec2<i32>(0, 1), last);
    return shade(
        point_at(pixel, textureLoad(linear_depth, pixel, 0).x),
        point_at(right, textureLoad(linear_depth, right, 0).x),
        point_at(below, textureLoad(linear_depth, below, 0).x),
    );
}
