// Casters: positions only. In front of it goes umbrage's caster text, whose bindings are group 0.

@group(1) @binding(0) var<storage, read> instances: array<mat4x4f>;

fn caster_position(position: vec3f, instance: u32) -> vec4f {
    return umbrage_caster_position((instances[instance] * vec4f(position, 1.0)).xyz);
}

@vertex
fn caster(@location(0) position: vec3f, @location(3) instance: u32) -> @builtin(position) vec4f {
    return caster_position(position, instance);
}
