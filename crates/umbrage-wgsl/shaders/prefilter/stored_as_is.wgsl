/// Moments as they are stored: the texture's format rounds them.
fn umbrage_stored(moments: vec4f) -> vec4f {
    return moments;
}
