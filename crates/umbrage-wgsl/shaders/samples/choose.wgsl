// The rectangle that each view covers of what was seen, and its matrix in the frame (Lauritzen et al. 2011, §4, for what is
// seen; what holds it still is ours). A lane takes a view.
//
// Sides are rungs of a ladder. They grow at once, and shrink late: when they were more than a rung too long for
// UMBRAGE_LATE frames, or at once where they are twice as long as they must be, as after a cut. Between such changes the rectangle
// moves by whole texels, and only where it must, so that every texel stays the same piece of the world.

import package::frame::umbrage_frame;
import package::samples::axis::{UmbrageWanted, umbrage_axis, umbrage_side};
import package::samples::looks::{UMBRAGE_SEEN, UmbrageChoice, umbrage_choices, umbrage_looks, umbrage_of_key, umbrage_seen};

/// Another rotation is taken where it makes the longer side so many times shorter.
const UMBRAGE_WORTH_A_TURN: f32 = 1.1;

/// A number that was seen of a view.
fn umbrage_seen_number(view: u32, number: u32) -> f32 {
    return umbrage_of_key(atomicLoad(&umbrage_seen[view * UMBRAGE_SEEN + number]));
}

/// What a rectangle must hold along the axes of one rotation, and where it may lie.
fn umbrage_wanted(view: u32, turn: u32) -> array<UmbrageWanted, 2> {
    let bounds = umbrage_looks.views[view].bounds[turn];
    let low = vec2f(-umbrage_seen_number(view, 3u + turn), -umbrage_seen_number(view, 9u + turn));
    let high = vec2f(umbrage_seen_number(view, turn), umbrage_seen_number(view, 6u + turn));
    // What is seen outside of the plan's region casts and receives nothing that the plan knows of.
    let start = clamp(low, bounds.xy, bounds.zw);
    let end = clamp(high, bounds.xy, bounds.zw);
    let middle = 0.5 * (start + end);
    let sides = max(end - start, vec2f(umbrage_looks.views[view].min_side)) * umbrage_looks.views[view].padding;
    return array(
        UmbrageWanted(middle.x, sides.x, bounds.x, bounds.z),
        UmbrageWanted(middle.y, sides.y, bounds.y, bounds.w),
    );
}

fn umbrage_longer_side(view: u32, turn: u32) -> f32 {
    let wanted = umbrage_wanted(view, turn);
    return max(wanted[0].side, wanted[1].side);
}

/// The rotation to take: the one that was taken before, unless another is worth it.
fn umbrage_turn(view: u32, before: u32) -> u32 {
    let steps = umbrage_looks.views[view].steps;
    let lengths = vec3f(umbrage_longer_side(view, 0u), umbrage_longer_side(view, 1u), umbrage_longer_side(view, 2u));
    let least = min(lengths.x, min(lengths.y, lengths.z));
    for (var turn = 0u; turn < 3u; turn++) {
        if steps[turn] + 1u == before && lengths[turn] <= UMBRAGE_WORTH_A_TURN * least {
            return turn;
        }
    }
    let of_others = select(2u, 0u, lengths.x < lengths.z);
    return select(of_others, 1u, lengths.y <= least);
}

/// Writes what the frame says of a view that covers a chosen rectangle.
fn umbrage_write_view(view: u32, choice: UmbrageChoice, right: vec3f, up: vec3f) {
    let tile_size = umbrage_frame.views[view].tile.z;
    let scale = 2.0 / vec2f(umbrage_side(choice.x), umbrage_side(choice.y));
    let middle = vec2f(choice.x.phase + f32(choice.x.index), choice.y.phase + f32(choice.y.index));
    var m = umbrage_frame.views[view].clip_from_local;
    for (var i = 0u; i < 3u; i++) {
        m[i] = vec4f(vec2f(right[i], up[i]) * scale, m[i].zw);
    }
    m[3] = vec4f(middle * (-2.0 / tile_size), m[3].zw);
    umbrage_frame.views[view].clip_from_local = m;
    umbrage_frame.views[view].held_x = vec4f(right * scale.x, m[3].x);
    umbrage_frame.views[view].held_y = vec4f(up * scale.y, m[3].y);
    let texels = vec2i(choice.x.index + choice.x.base, -choice.y.index - choice.y.base);
    umbrage_frame.views[view].lattice = bitcast<vec2u>(texels - vec2i(i32(tile_size) / 2));
}

fn umbrage_choose(view: u32) {
    var choice = umbrage_choices.views[view];
    if umbrage_looks.views[view].is_fitted == 0u || atomicLoad(&umbrage_seen[view * UMBRAGE_SEEN]) == 0u {
        choice.turn = 0u;
        umbrage_choices.views[view] = choice;
        return;
    }
    let turn = umbrage_turn(view, choice.turn);
    let number = umbrage_looks.views[view].steps[turn] + 1u;
    let is_kept = choice.turn == number;
    let right = umbrage_looks.views[view].rights[turn];
    let up = umbrage_looks.views[view].ups[turn];
    let moved = vec2f(dot(right, umbrage_looks.moved), dot(up, umbrage_looks.moved));
    let tile_size = umbrage_frame.views[view].tile.z;
    let wanted = umbrage_wanted(view, turn);
    choice.turn = number;
    choice.x = umbrage_axis(choice.x, is_kept, wanted[0], moved.x, tile_size);
    choice.y = umbrage_axis(choice.y, is_kept, wanted[1], moved.y, tile_size);
    umbrage_choices.views[view] = choice;
    umbrage_write_view(view, choice, right, up);
}

@compute @workgroup_size(64)
fn choose(@builtin(global_invocation_id) lane: vec3u) {
    if lane.x < umbrage_looks.view_count {
        umbrage_choose(lane.x);
    }
    if lane.x == 0u {
        var nearest = 0u;
        var farthest = 0u;
        for (var view = 0u; view < umbrage_looks.view_count; view++) {
            farthest = max(farthest, atomicLoad(&umbrage_seen[view * UMBRAGE_SEEN + 12u]));
            nearest = max(nearest, atomicLoad(&umbrage_seen[view * UMBRAGE_SEEN + 13u]));
        }
        umbrage_choices.nearest = select(1.0, -umbrage_of_key(nearest), nearest > 0u);
        umbrage_choices.farthest = select(0.0, umbrage_of_key(farthest), farthest > 0u);
    }
}
