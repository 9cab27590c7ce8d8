//! Keys of shadow views: numbers of all that is drawn into them, so that a view is drawn again only where that is another.

use std::hash::{DefaultHasher, Hash, Hasher};

use glam::DVec3;
use umbrage::{ShadowPlan, ViewKey};

use crate::cover::Cover;
use crate::drawn::{moving, still};
use crate::draws::{Draw, DrawLists, PartTable};

/// Gives every view of a plan the key of its lists. `origin` is what positions on the device are relative to.
pub(crate) fn name(plan: &mut ShadowPlan, origin: DVec3, lists: &DrawLists, parts: &PartTable) {
    for i in 0..plan.views().len() {
        let mut state = DefaultHasher::new();
        plan.views()[i].hash_projection(&mut state);
        origin.to_array().map(f64::to_bits).hash(&mut state);
        let moving = moving(lists, i);
        // What a pass chooses for a view has no name.
        let key = plan.views()[i].samples.is_none().then(|| ViewKey {
            still: number(state.clone(), still(lists, i), lists, parts),
            moving: (!moving.is_empty()).then(|| number(state, moving, lists, parts)),
        });
        plan.set_key(i, key);
    }
}

/// A number of what is drawn by a list: its triangles, and where each instance stands and how it is bent.
fn number(mut state: DefaultHasher, draws: &[Draw], lists: &DrawLists, parts: &PartTable) -> u64 {
    for draw in draws {
        let Draw { geometry, closed, indices, base_vertex, material, cover, mirrored, depth: _, instances } =
            draw;
        // Only the depth of what is solid is drawn.
        let material = if *cover == Cover::Solid { 0 } else { *material };
        (geometry, closed).hash(&mut state);
        (indices.start, indices.end, *base_vertex, material, *cover as u8, *mirrored).hash(&mut state);
        let instances = &lists.instances()[instances.start as usize..instances.end as usize];
        state.write(bytemuck::cast_slice(instances));
        for instance in instances {
            let epoch = parts.epoch(*instance);
            // Most have never moved.
            if epoch > 0 {
                (*instance, epoch).hash(&mut state);
            }
        }
    }
    state.finish()
}
