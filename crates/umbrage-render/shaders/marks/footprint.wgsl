// What a pixel covers of a map. It needs `scene.wgsl`, `receiver.wgsl` and umbrage's receiver text.

/// What a receiver's pixel covers of a view's map.
fn footprint_of(view: u32, receiver: Receiver, facing: vec3f) -> mat2x2f {
    let world = scene.eye + receiver.from_eye;
    let lookup = umbrage_lookup(view, 0u, world, facing);
    return umbrage_footprint(lookup, UmbrageReceiver(world, facing, receiver.clip.xy, umbrage_view_depth(world)));
}
