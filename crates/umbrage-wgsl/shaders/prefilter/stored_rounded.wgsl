/// Moments as they are stored: rounded as 16-bit numbers are, where the device has no textures of these.
fn umbrage_stored(moments: vec4f) -> vec4f {
    return round(clamp(moments, vec4f(0.0), vec4f(1.0)) * 65535.0) / 65535.0;
}
