// From light to what a screen can show.

/// Where a light grey begins to be compressed, less the offset below.
const COMPRESSION_STARTS: f32 = 0.8 - 0.04;
/// How fast what is brighter than white loses its colour.
const DESATURATION: f32 = 0.15;

/// Linear light to what a screen can show: the Khronos PBR Neutral tone mapper (Khronos Group 2024), which gives base colours
/// back as they are, takes off what a surface without metal reflects (4 %), and compresses what is brighter than 0.8.
fn tone_mapped(light: vec3f) -> vec3f {
    // Sums of what may be very bright stay numbers.
    let bounded = min(light, vec3f(1e15));
    let least = min(bounded.r, min(bounded.g, bounded.b));
    let offset = select(0.04, least - 6.25 * least * least, least < 0.08);
    let colour = bounded - offset;
    let peak = max(colour.r, max(colour.g, colour.b));
    if peak < COMPRESSION_STARTS {
        return colour;
    }
    let room = 1.0 - COMPRESSION_STARTS;
    let new_peak = 1.0 - room * room / (peak + room - COMPRESSION_STARTS);
    let white = 1.0 - 1.0 / (DESATURATION * (peak - new_peak) + 1.0);
    return mix(colour * (new_peak / peak), vec3f(new_peak), white);
}
