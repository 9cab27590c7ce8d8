// The camera's depth, of one sample a pixel.

@group(0) @binding(1) var umbrage_contact_depth: texture_2d<f32>;
