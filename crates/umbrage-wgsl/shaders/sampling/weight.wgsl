// What a texel weighs in a kernel of bilinear lookups, one texel apart. `umbrage_kernel` comes from a file of `kernel_*`.

import chosen::umbrage_kernel;

/// What texel `i` of a row weighs, for a place that lies `share` of a texel beyond texel 0.
fn umbrage_weight(i: i32, share: f32) -> f32 {
    return mix(umbrage_kernel(i), umbrage_kernel(i - 1), share);
}
