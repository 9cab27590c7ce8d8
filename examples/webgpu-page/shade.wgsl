// The page's own shader: a matte world under the first light. The text of `umbrage wgsl` stands in front of it.

@group(0) @binding(0) var<uniform> camera_rows: mat4x4f; // the rows of clip_from_world

struct Varying {
    @builtin(position) pixel: vec4f,
    @location(0) position: vec3f,
    @location(1) normal: vec3f,
}

@vertex fn vertex(@location(0) position: vec3f, @location(1) normal: vec3f) -> Varying {
    return Varying(vec4f(position, 1.0) * camera_rows, position, normal);
}

@fragment fn fragment(in: Varying) -> @location(0) vec4f {
    let normal = normalize(in.normal);
    let visibility = umbrage_visibility(in.position, normal, in.pixel.xy);
    let sunlight = max(dot(normal, umbrage_frame.lights[0].place.xyz), 0.0);
    let colour = umbrage_shade(vec3f(0.16, 0.19, 0.25), vec3f(0.9, 0.8, 0.65) * sunlight, visibility);
    return vec4f(pow(colour, vec3f(1.0 / 2.2)), 1.0);
}
