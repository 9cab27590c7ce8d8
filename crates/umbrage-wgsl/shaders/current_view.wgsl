// Which view a caster pass or a compute step is about. It is bound at a dynamic offset.

/// The view's index, in x.
@group(0) @binding(1) var<uniform> umbrage_current_view: vec4u;
