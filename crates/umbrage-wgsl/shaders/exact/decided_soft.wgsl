// Whether a light of some size is seen whole, or not at all: where the texels around the receiver agree, and so do those of
// the disc that all possible blockers lie in.

import constants::UMBRAGE_BLOCKERS;
import package::exact::decided::umbrage_decided;
import package::exact::not_known::UMBRAGE_UNDECIDED;
import package::filter::pcss::umbrage_blockers;
import package::linear_depth::umbrage_linear_depth;
import package::receiver::lookup::{UmbrageLookup, UmbrageReceiver};
import package::sampling::noise::umbrage_noise;
import package::sampling::penumbra::umbrage_penumbra_texels;

/// 1 where the map is sure that a receiver sees all of a light, 0 where it is sure that it sees none of it, and otherwise
/// UMBRAGE_UNDECIDED.
fn umbrage_sure(lookup: UmbrageLookup, receiver: UmbrageReceiver) -> f32 {
    let sure = umbrage_decided(lookup);
    if sure == UMBRAGE_UNDECIDED {
        return sure;
    }
    let depth = umbrage_linear_depth(lookup.view_index, lookup.texel, lookup.compare_depth);
    let radius = umbrage_penumbra_texels(lookup, depth, 0.0);
    let blockers = umbrage_blockers(lookup, radius, umbrage_noise(receiver)).y;
    let agreed = select(0.0, f32(UMBRAGE_BLOCKERS), sure == 0.0);
    return select(UMBRAGE_UNDECIDED, sure, blockers == agreed);
}
