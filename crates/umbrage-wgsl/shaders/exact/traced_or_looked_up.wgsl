// The ray from a receiver to a light, where the shape of some casters is not known to rays: they know the box around each, and what
// has passed one is the maps' to say.

import chosen::umbrage_rays;
import package::receiver::by_maps::umbrage_by_maps;
import package::receiver::lookup::UmbrageReceiver;

/// How much of a light reaches a receiver.
fn umbrage_traced(light: u32, receiver: UmbrageReceiver) -> f32 {
    let traced = umbrage_rays(light, receiver);
    var share = traced.share;
    if traced.passed_bent && share > 0.0 {
        share = min(share, umbrage_by_maps(light, receiver));
    }
    return share;
}
