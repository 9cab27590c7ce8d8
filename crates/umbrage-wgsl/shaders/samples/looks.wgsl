// What the passes know that fit views to the camera's depth: where the plan lets them choose, what was seen, and what they
// chose, which stays from frame to frame. `src/looks.rs` lays the same out.

struct UmbrageLook {
    /// In world space, the directions that are right and up on the map, one column for each rotation that may be chosen.
    rights: mat3x3f,
    ups: mat3x3f,
    /// Where the rectangle may lie along these, metres from the frame's origin: the least x and y, and the greatest.
    bounds: array<vec4f, 3>,
    /// The numbers of these rotations.
    steps: vec3u,
    /// Whether anything may be chosen: 0 where the plan says what the view covers.
    is_fitted: u32,
    /// The view depths of the receivers that the rectangle must hold, metres.
    depth_start: f32,
    depth_end: f32,
    /// How many times longer its sides must be than what the receivers reach over, and how long at least, metres.
    padding: f32,
    min_side: f32,
}

struct UmbrageLooks {
    /// The camera whose depth is looked at.
    world_from_clip: mat4x4f,
    depth_row: vec4f,
    /// How far the frame's origin moved since the frame before, metres.
    moved: vec3f,
    /// The height of the picture at clip w = 1, metres.
    picture_height: f32,
    view_count: u32,
    views: array<UmbrageLook>,
}

/// The texels of a chosen rectangle along one axis. Texel `index` is right of its middle; texel 0 begins `phase` texels from the
/// frame's origin.
struct UmbrageAxis {
    /// The side is 2^(rung / UMBRAGE_RUNGS_AN_OCTAVE) metres long.
    rung: i32,
    index: i32,
    /// What is added to an index so that a texel keeps its number while the origin moves.
    base: i32,
    phase: f32,
    /// For so many frames the side was too long, and this is what it should have been at least.
    late: u32,
    late_rung: i32,
}

struct UmbrageChoice {
    /// One more than the number of the rotation; 0 where nothing is chosen.
    turn: u32,
    x: UmbrageAxis,
    y: UmbrageAxis,
}

struct UmbrageChoices {
    /// The least and the greatest view depth that was seen, metres; the least is greater where nothing was.
    nearest: f32,
    farthest: f32,
    views: array<UmbrageChoice>,
}

@group(0) @binding(1) var<storage, read> umbrage_looks: UmbrageLooks;
/// For each view UMBRAGE_SEEN numbers as `umbrage_key` orders them, of which the greatest counts; 0 where nothing was seen. They
/// are the greatest x along the three rotations, then the greatest −x, y, −y, and the greatest view depth and its negative.
@group(0) @binding(2) var<storage, read_write> umbrage_seen: array<atomic<u32>>;
@group(0) @binding(3) var<storage, read_write> umbrage_choices: UmbrageChoices;

const UMBRAGE_SEEN: u32 = 14u;
const UMBRAGE_RUNGS_AN_OCTAVE: i32 = 16;

/// Whole numbers above 0 that lie in order as their floats do.
fn umbrage_key(number: f32) -> u32 {
    let bits = bitcast<u32>(number);
    return select(bits | 0x80000000u, ~bits, bits >= 0x80000000u);
}

/// The float that a key was made of.
fn umbrage_of_key(key: u32) -> f32 {
    return bitcast<f32>(select(~key, key & 0x7fffffffu, key >= 0x80000000u));
}
