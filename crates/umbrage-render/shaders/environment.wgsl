// The light of an environment picture. It needs `scene.wgsl` and `picture.wgsl`.

/// The picture in rows from zenith to nadir, its middle ahead of −Z; each mip as a rougher surface sees it.
@group(0) @binding(3) var environment: texture_2d<f32>;
@group(0) @binding(4) var environment_sampler: sampler;

/// Light from a direction, through so many mips of blur.
fn environment_light(direction: vec3f, mip: f32) -> vec3f {
    let turn = atan2(direction.x, -direction.z) * (0.5 / 3.14159265);
    let drop = acos(clamp(direction.y, -1.0, 1.0)) / 3.14159265;
    let stored = textureSampleLevel(environment, environment_sampler, vec2f(turn + 0.5, drop), mip).rgb;
    return stored * (picture.environment_scale * picture.exposure);
}

/// Light that reaches a surface from all around, for a unit normal (Ramamoorthi and Hanrahan 2001).
fn ambient_light(normal: vec3f) -> vec3f {
    let n = normal;
    let light = picture.around[0].rgb
        + picture.around[1].rgb * n.y + picture.around[2].rgb * n.z + picture.around[3].rgb * n.x
        + picture.around[4].rgb * (n.x * n.y) + picture.around[5].rgb * (n.y * n.z)
        + picture.around[6].rgb * (3.0 * n.z * n.z - 1.0)
        + picture.around[7].rgb * (n.x * n.z) + picture.around[8].rgb * (n.x * n.x - n.y * n.y);
    return max(light, vec3f(0.0));
}

/// Light that a surface of some roughness reflects from a direction.
fn reflected_light(direction: vec3f, roughness: f32) -> vec3f {
    return environment_light(direction, roughness * f32(textureNumLevels(environment) - 1u));
}

/// The colour of haze before what lies in a direction: that of the horizon there, without what shines on it.
fn haze_light(direction: vec3f) -> vec3f {
    return reflected_light(direction, 0.7);
}

/// What is seen in a direction.
fn sky_seen(direction: vec3f) -> vec3f {
    return environment_light(direction, 0.0);
}
