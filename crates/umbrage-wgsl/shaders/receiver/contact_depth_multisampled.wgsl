// The camera's depth, of several samples a pixel: `textureLoad` has the sample where it has the level of other textures.

@group(0) @binding(1) var umbrage_contact_depth: texture_multisampled_2d<f32>;
