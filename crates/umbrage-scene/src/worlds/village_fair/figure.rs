//! The shapes of people: limbs that bend at their joints, a trunk, a head, and clothes. Vertices near a joint follow the
//! bones on both of its sides.

use glam::Vec3;

use super::skeleton::Joint;
use crate::paint::Paint;
use crate::shape::{Solid, bevelled, frustum, sphere, tube};
use crate::{Influences, Mesh, Primitive};

/// So far around a joint both bones count, metres.
const BEND: f32 = 0.06;

/// Who wears what.
#[derive(Clone, Copy, Debug)]
pub(super) struct Dress {
    pub name: &'static str,
    pub shirt: Paint,
    pub below: Paint,
    pub hair: Paint,
    pub skirt: bool,
    pub hat: bool,
}

/// Everybody wears one of these.
pub(super) const DRESSES: [Dress; 5] = [
    Dress {
        name: "farmer",
        shirt: Paint::Blue,
        below: Paint::Leather,
        hair: Paint::Beard,
        skirt: false,
        hat: true,
    },
    Dress {
        name: "dancer",
        shirt: Paint::White,
        below: Paint::Red,
        hair: Paint::Ebony,
        skirt: true,
        hat: false,
    },
    Dress {
        name: "miller",
        shirt: Paint::Ivory,
        below: Paint::Slate,
        hair: Paint::Ebony,
        skirt: false,
        hat: false,
    },
    Dress {
        name: "widow",
        shirt: Paint::Violet,
        below: Paint::Black,
        hair: Paint::White,
        skirt: true,
        hat: true,
    },
    Dress {
        name: "child",
        shirt: Paint::Yellow,
        below: Paint::Green,
        hair: Paint::Wood,
        skirt: false,
        hat: false,
    },
];

/// A figure as a mesh, as its bones were bound.
pub(super) fn mesh(dress: &Dress) -> Mesh {
    let mut parts = Vec::new();
    parts.push(trunk(dress.shirt));
    parts.extend(head(dress));
    for side in [1.0, -1.0] {
        parts.extend(limbs(dress, side));
    }
    if dress.skirt {
        parts.push(skirt(dress.below));
    }
    Mesh::new(dress.name, &parts)
}

/// Bones that follow each other: each begins where the one before ends; the last ends at a point.
struct Chain<'a> {
    bones: &'a [Joint],
    end: Vec3,
}

impl Chain<'_> {
    /// The bones that a place follows, and how much.
    fn at(&self, place: Vec3) -> [(Joint, f32); 2] {
        let ends = self.bones.iter().skip(1).map(|bone| bone.at()).chain([self.end]);
        let mut walked = 0.0;
        let mut nearest = (f32::INFINITY, 0.0);
        let mut starts = Vec::new();
        for (bone, end) in self.bones.iter().zip(ends) {
            let (start, along) = (bone.at(), end - bone.at());
            let share = ((place - start).dot(along) / along.length_squared()).clamp(0.0, 1.0);
            let away = place.distance(start + along * share);
            if away < nearest.0 {
                nearest = (away, walked + share * along.length());
            }
            starts.push(walked);
            walked += along.length();
        }
        let here = starts.partition_point(|start| *start <= nearest.1).max(1) - 1;
        let past = nearest.1 - starts[here];
        if here > 0 && past < BEND {
            let own = 0.5 + 0.5 * past / BEND;
            return [(self.bones[here], own), (self.bones[here - 1], 1.0 - own)];
        }
        match starts.get(here + 1).map(|next| next - nearest.1) {
            Some(left) if left < BEND => {
                let own = 0.5 + 0.5 * left / BEND;
                [(self.bones[here], own), (self.bones[here + 1], 1.0 - own)]
            }
            Some(_) | None => [(self.bones[here], 1.0), (self.bones[here], 0.0)],
        }
    }

    /// Paints a solid whose vertices follow the chain.
    fn bind(&self, solid: &Solid, paint: Paint) -> Primitive {
        let painted = solid.painted(paint as usize);
        let mut influences = Influences { per_vertex: 2, ..Influences::default() };
        for (joint, weight) in painted.positions.iter().flat_map(|place| self.at(*place)) {
            influences.joints.push(joint as u16);
            influences.weights.push(weight);
        }
        Primitive { influences, ..painted }
    }
}

/// Paints a solid that follows one joint.
fn rigid(solid: &Solid, joint: Joint, paint: Paint) -> Primitive {
    Chain { bones: &[joint], end: joint.at() + Vec3::Y }.bind(solid, paint)
}

fn trunk(shirt: Paint) -> Primitive {
    let rings = [
        (0.86, 0.10),
        (0.90, 0.155),
        (0.96, 0.165),
        (1.03, 0.15),
        (1.10, 0.14),
        (1.18, 0.15),
        (1.27, 0.17),
        (1.36, 0.18),
        (1.43, 0.15),
        (1.47, 0.08),
        (1.53, 0.06),
        (1.58, 0.055),
    ];
    // Deeper than wide is nobody.
    let solid = tube(&rings.map(|(y, r)| (Vec3::new(0.0, y, -0.01), r)), 18).scaled(1.12, 1.0, 0.72);
    let bones = [Joint::Hips, Joint::Spine, Joint::Chest, Joint::Neck];
    Chain { bones: &bones, end: Joint::Head.at() }.bind(&solid, shirt)
}

fn head(dress: &Dress) -> Vec<Primitive> {
    let skull = sphere(0.105, 14, 9).scaled(0.92, 1.15, 1.0).moved(0.0, 1.66, 0.02);
    let nose = sphere(0.02, 8, 6).moved(0.0, 1.655, 0.125);
    let hair = sphere(0.112, 14, 7).scaled(0.95, 0.95, 0.98).moved(0.0, 1.69, -0.012);
    let mut parts =
        vec![rigid(&skull.and(nose), Joint::Head, Paint::Skin), rigid(&hair, Joint::Head, dress.hair)];
    if dress.hat {
        let hat = frustum(0.19, 0.18, 0.015, 20).and(frustum(0.115, 0.1, 0.12, 20)).moved(0.0, 1.735, -0.01);
        parts.push(rigid(&hat, Joint::Head, Paint::Leather));
    }
    parts
}

/// An arm and a leg, on the left where `side` is 1.
fn limbs(dress: &Dress, side: f32) -> Vec<Primitive> {
    let is_left = side > 0.0;
    let pick = |left: Joint, right: Joint| if is_left { left } else { right };
    let arm = [
        pick(Joint::ArmLeft, Joint::ArmRight),
        pick(Joint::ForearmLeft, Joint::ForearmRight),
        pick(Joint::HandLeft, Joint::HandRight),
    ];
    let leg = [
        pick(Joint::ThighLeft, Joint::ThighRight),
        pick(Joint::ShinLeft, Joint::ShinRight),
        pick(Joint::FootLeft, Joint::FootRight),
    ];
    let fingers = arm[2].at() + Vec3::new(0.03 * side, -0.12, 0.02);
    let sole = leg[2].at() - Vec3::Y * 0.05;
    let sleeve = along(&[arm[0], arm[1], arm[2]], None, &[0.068, 0.052, 0.04], 10);
    let hand = sphere(0.042, 8, 6)
        .scaled(0.7, 1.6, 1.0)
        .at(glam::Affine3A::from_translation(arm[2].at().lerp(fingers, 0.5)));
    let trouser = along(&[leg[0], leg[1], leg[2]], Some(sole), &[0.1, 0.072, 0.052, 0.05], 11);
    let shoe = bevelled(0.095, 0.09, 0.26, 0.03)
        .at(glam::Affine3A::from_translation(leg[2].at() + Vec3::new(0.0, -0.04, 0.06)));
    let legs = if dress.skirt { Paint::Skin } else { dress.below };
    vec![
        Chain { bones: &arm, end: fingers }.bind(&sleeve, dress.shirt),
        rigid(&hand, arm[2], Paint::Skin),
        Chain { bones: &leg, end: sole }.bind(&trouser, legs),
        rigid(&shoe, leg[2], Paint::Leather),
    ]
}

/// A tube along joints, with rings closest where it bends.
fn along(joints: &[Joint], end: Option<Vec3>, radii: &[f32], sides: u32) -> Solid {
    let points: Vec<Vec3> = joints.iter().map(|joint| joint.at()).chain(end).collect();
    let mut rings = vec![(points[0], radii[0])];
    for i in 1..points.len() {
        for share in [0.15, 0.5, 0.85, 1.0] {
            let radius = radii[i - 1] + (radii[i] - radii[i - 1]) * share;
            rings.push((points[i - 1].lerp(points[i], share), radius));
        }
    }
    tube(&rings, sides)
}

/// A skirt to the shins, which follows hips and thighs.
fn skirt(paint: Paint) -> Primitive {
    let rings = [
        (0.42, 0.36),
        (0.44, 0.37),
        (0.55, 0.32),
        (0.66, 0.28),
        (0.78, 0.235),
        (0.9, 0.19),
        (1.02, 0.155),
        (1.04, 0.15),
    ];
    let painted = tube(&rings.map(|(y, r)| (Vec3::Y * y, r)), 24).painted(paint as usize);
    let mut influences = Influences { per_vertex: 3, ..Influences::default() };
    for place in &painted.positions {
        let swing = 0.55 * ((0.9 - place.y) / 0.45).clamp(0.0, 1.0);
        let left = 0.5 + 0.5 * (place.x / 0.2).clamp(-1.0, 1.0);
        influences
            .joints
            .extend([Joint::Hips, Joint::ThighLeft, Joint::ThighRight].map(|joint| joint as u16));
        influences.weights.extend([1.0 - swing, swing * left, swing * (1.0 - left)]);
    }
    Primitive { influences, ..painted }
}
