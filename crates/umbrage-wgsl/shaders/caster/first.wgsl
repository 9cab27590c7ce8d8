// The first surface that the light meets: nothing is left out.

/// A caster's fragment shader calls it with its position, so that the same shader draws either surface.
fn umbrage_caster_fragment(position: vec4f) {
}
