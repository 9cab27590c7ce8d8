// The fragment shader of solid surfaces whose materials are not looked at. It needs `shown`.

@fragment
fn shade(receiver: Receiver, samples: Samples) -> @location(0) vec4f {
    asked_from_eye = place_of(receiver.from_eye, samples);
    return shown(vec3f(1.0), receiver, geometric_normal(receiver.from_eye));
}
