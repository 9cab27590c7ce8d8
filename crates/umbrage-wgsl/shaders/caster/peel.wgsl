// The fragment shader of the second surface, for casters that have none of their own.

import package::caster::second::umbrage_caster_fragment;

@fragment
fn peel(@builtin(position) position: vec4f) {
    umbrage_caster_fragment(position);
}
