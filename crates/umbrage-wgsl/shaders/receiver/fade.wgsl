// The end of all shadows.

import package::frame::umbrage_frame;

/// Fades to lit before the depth at which shadows end, over a share of the light's last slice.
fn umbrage_faded(visibility: f32, light: u32, depth: f32) -> f32 {
    let last = umbrage_frame.lights[light].first_view + umbrage_frame.lights[light].view_count - 1u;
    let start = umbrage_frame.views[last].depth_start;
    let end = umbrage_frame.shadow_end;
    return mix(1.0, visibility, smoothstep(0.0, 1.0, (end - depth) / max((end - start) * umbrage_frame.blend, 1e-30)));
}
