// The last part of a slice fades into the next view, whose map is fitted to hold it; the end of all shadows into light.

import package::frame::umbrage_frame;
import package::light::umbrage_has_faces;
import package::receiver::fade::umbrage_faded;
import package::receiver::lookup::{UmbrageLookup, UmbrageReceiver};
import package::receiver::read::umbrage_visibility_in;

fn umbrage_blend(lookup: UmbrageLookup, own: f32, receiver: UmbrageReceiver) -> f32 {
    let light = lookup.light;
    let view_end = umbrage_frame.lights[light].first_view + umbrage_frame.lights[light].view_count;
    let start = umbrage_frame.views[lookup.view_index].depth_start;
    let end = umbrage_frame.views[lookup.view_index].depth_end;
    let share = (end - receiver.depth) / ((end - start) * umbrage_frame.blend);
    let next = lookup.view_index + 1u;
    if umbrage_has_faces(light) || next >= view_end || share >= 1.0 {
        return umbrage_faded(own, light, receiver.depth);
    }
    let other = umbrage_visibility_in(next, light, receiver);
    return umbrage_faded(mix(other, own, smoothstep(0.0, 1.0, share)), light, receiver.depth);
}
