// Visibility is asked for at the centres of pixels.

/// What a fragment knows of its samples: nothing that matters.
struct Samples {
    @builtin(front_facing) is_front: bool,
}

/// Where visibility is asked for, from the eye.
fn place_of(from_eye: vec3f, samples: Samples) -> vec3f {
    return from_eye;
}
