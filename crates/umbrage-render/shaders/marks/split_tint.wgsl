// Surfaces with a tint of the view that serves them, for the first light. It needs `scene.wgsl`, `receiver.wgsl`, umbrage's
// receiver text and `split_colour.wgsl`.

fn painted(base: vec3f, receiver: Receiver, facing: vec3f) -> vec3f {
    let view = umbrage_view_of(0u, scene.eye + receiver.from_eye, facing);
    if view == UMBRAGE_NO_VIEW {
        return base;
    }
    return mix(base, split_colour(view - umbrage_frame.lights[0].first_view), 0.6);
}
