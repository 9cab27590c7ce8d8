// A surface's own colour, as group 2.

@group(2) @binding(0) var<uniform> base_colour: vec4f;
@group(2) @binding(1) var base_texture: texture_2d<f32>;
@group(2) @binding(2) var base_sampler: sampler;
