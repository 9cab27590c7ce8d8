// What the camera sees, as all passes of a picture read it.

@group(0) @binding(1) var receivers: texture_depth_2d;

/// The depth of what a pixel shows; 0 for the sky.
fn seen_depth(clip: vec4f) -> f32 {
    return textureLoad(receivers, vec2i(clip.xy), 0);
}
