// The end of all shadows.

/// Fades to lit before the depth at which shadows end, over a share of the slice that begins at `start`.
fn umbrage_faded(visibility: f32, start: f32, depth: f32) -> f32 {
    let end = umbrage_frame.shadow_end;
    return mix(1.0, visibility, smoothstep(0.0, 1.0, (end - depth) / max((end - start) * UMBRAGE_BLEND, 1e-30)));
}
