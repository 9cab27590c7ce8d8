// The page's own shader of casters. The text of `umbrage wgsl --stage caster` stands in front of it.

@vertex fn vertex(@location(0) position: vec3f) -> @builtin(position) vec4f {
    return umbrage_caster_position(position);
}
