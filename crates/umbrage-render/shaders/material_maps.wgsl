// The pictures of a material, beside that of its base colour, as group 2. It needs `material.wgsl`, `receiver.wgsl`,
// `picture.wgsl` and `reflection.wgsl`.

@group(2) @binding(3) var metallic_roughness_texture: texture_2d<f32>;
@group(2) @binding(4) var normal_texture: texture_2d<f32>;
@group(2) @binding(5) var occlusion_texture: texture_2d<f32>;
@group(2) @binding(6) var emission_texture: texture_2d<f32>;

/// Where a picture of the material is.
fn place_on(map: u32, uv: vec2f) -> vec2f {
    let place = material.places[map];
    return place.columns.xy * uv.x + place.columns.zw * uv.y + place.offset;
}

/// A normal of a picture, in the frame of the surface's texture coordinates: how those change from pixel to pixel says how
/// they lie (Mikkelsen 2010; Schüler 2006). Green is up, and v is down.
fn mapped_normal(normal: vec3f, receiver: Receiver, uv: vec2f, picture_normal: vec3f) -> vec3f {
    let across = dpdx(receiver.from_eye);
    let down = dpdy(receiver.from_eye);
    let uv_across = dpdx(uv);
    let uv_down = dpdy(uv);
    // A picture's rows go down, and so the two steps may be left-handed.
    let hand = sign(dot(cross(across, down), normal));
    let by_across = cross(down, normal) * hand;
    let by_down = cross(normal, across) * hand;
    let tangent = by_across * uv_across.x + by_down * uv_down.x;
    let bitangent = by_across * uv_across.y + by_down * uv_down.y;
    let longer = max(dot(tangent, tangent), dot(bitangent, bitangent));
    // Without texture coordinates there is no frame.
    if longer <= 0.0 {
        return normal;
    }
    let scale = inverseSqrt(longer);
    let turned = tangent * (scale * picture_normal.x) - bitangent * (scale * picture_normal.y) + normal * picture_normal.z;
    return turned * inverseSqrt(max(dot(turned, turned), 1e-30));
}

/// All that is known of a surface of a base colour.
fn surface_at(base: vec3f, receiver: Receiver, facing: vec3f) -> Surface {
    let rough_metal = textureSample(metallic_roughness_texture, base_sampler, place_on(0u, receiver.uv)).gb;
    let normal_uv = place_on(1u, receiver.uv);
    let picture_normal = textureSample(normal_texture, base_sampler, normal_uv).rgb * 2.0 - 1.0;
    let open = textureSample(occlusion_texture, base_sampler, place_on(2u, receiver.uv)).r;
    let emitted = textureSample(emission_texture, base_sampler, place_on(3u, receiver.uv)).rgb;
    let metallic = material.metallic * rough_metal.y;
    let scaled = vec3f(picture_normal.xy * material.normal_scale, picture_normal.z);
    var surface: Surface;
    surface.normal = mapped_normal(smooth_normal(receiver, facing), receiver, normal_uv, scaled);
    surface.diffuse = base * (1.0 - metallic);
    surface.head_on = mix(vec3f(0.04 * material.specular), base, metallic);
    surface.grazing = vec3f(mix(material.specular, 1.0, metallic));
    surface.roughness = clamp(material.roughness * rough_metal.x, SMOOTHEST, 1.0);
    surface.open = 1.0 + material.occlusion_strength * (open - 1.0);
    surface.emission = material.emission * emitted * picture.exposure;
    return surface;
}
