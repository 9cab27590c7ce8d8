// A surface of any material in the light of all lights, of the sky and of itself. It needs `material.wgsl`,
// `material_maps.wgsl`, `reflection.wgsl`, and what `matte.wgsl` needs.

/// The light of the sky and of all around, and what the surface sends out by itself.
fn light_around(surface: Surface, toward_eye: vec3f) -> vec3f {
    let normal_eye = max(abs(dot(surface.normal, toward_eye)), 1e-4);
    let share = reflected_share(surface, normal_eye);
    let scattered = surface.diffuse * (1.0 - share) * ambient_light(surface.normal);
    let mirrored = share * reflected_light(reflect(-toward_eye, surface.normal), surface.roughness);
    return (scattered + mirrored) * surface.open + surface.emission;
}

/// What the screen shows of a surface of a base colour. `facing` is its geometric normal, turned to the eye.
fn seen_surface(base: vec3f, receiver: Receiver, facing: vec3f) -> vec4f {
    let surface = surface_at(base, receiver, facing);
    if material.unlit == 1u {
        return vec4f(min(base, vec3f(1.0)), 1.0);
    }
    let toward_eye = -receiver.from_eye * inverseSqrt(max(dot(receiver.from_eye, receiver.from_eye), 1e-30));
    var shading = umbrage_shading(light_around(surface, toward_eye));
    for (var i = 0u; i < scene.light_count; i++) {
        let arriving = arriving_light(scene.lights[i], scene.eye + receiver.from_eye);
        if dot(surface.normal, arriving.direction) > 0.0 && any(arriving.colour > vec3f(0.0)) {
            let lit = arriving.colour * reflected(surface, toward_eye, arriving.direction);
            shading = umbrage_add_light(shading, lit, visibility_at(i, receiver, facing));
        }
    }
    return vec4f(tone_mapped(through_haze(umbrage_shaded(shading), receiver.from_eye)), 1.0);
}
