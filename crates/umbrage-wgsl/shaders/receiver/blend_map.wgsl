// The rim of a map fades into the next view that holds the receiver; the end of all shadows into light.

import package::frame::umbrage_frame;
import package::light::umbrage_has_faces;
import package::receiver::no_view::UMBRAGE_NO_VIEW;
import package::receiver::fade::umbrage_faded;
import package::receiver::lookup::{UmbrageLookup, UmbrageReceiver};
import package::receiver::read::umbrage_read;
import package::receiver::select_map::umbrage_finest;
import package::storage::map::umbrage_tile_size;

fn umbrage_blend(lookup: UmbrageLookup, own: f32, receiver: UmbrageReceiver) -> f32 {
    let light = lookup.light;
    let tile_size = umbrage_tile_size(lookup.view_index);
    let from_middle = abs(lookup.texel / tile_size * 2.0 - 1.0);
    let share = (1.0 - max(from_middle.x, from_middle.y)) / umbrage_frame.blend;
    if umbrage_has_faces(light) || share >= 1.0 {
        return umbrage_faded(own, light, receiver.depth);
    }
    let next = umbrage_finest(light, lookup.view_index + 1u, receiver.position, receiver.normal);
    if next.view_index == UMBRAGE_NO_VIEW {
        return umbrage_faded(own, light, receiver.depth);
    }
    let other = umbrage_read(next, receiver);
    return umbrage_faded(mix(other, own, smoothstep(0.0, 1.0, share)), light, receiver.depth);
}
