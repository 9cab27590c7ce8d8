// Surfaces as they are: nothing is drawn onto them.

fn painted(base: vec3f, receiver: Receiver, facing: vec3f) -> vec3f {
    return base;
}
