// From light to what a screen can show.

/// Linear light to what a screen can show (the filmic curve fitted by Narkowicz, 2016).
fn tone_mapped(light: vec3f) -> vec3f {
    let x = light * 0.75;
    return clamp(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14), vec3f(0.0), vec3f(1.0));
}
