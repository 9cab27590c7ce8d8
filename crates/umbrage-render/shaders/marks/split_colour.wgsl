// The colour of a split. It needs `SPLIT_COLOURS`, which come from Rust.

fn split_colour(split: u32) -> vec3f {
    var colours = SPLIT_COLOURS;
    return colours[split % SPLIT_COLOUR_COUNT];
}
