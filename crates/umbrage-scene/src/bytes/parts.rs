//! The parts of a scene as bytes. Each is taken apart with every field named, so that a new field breaks the build.

use super::Bytes;
use crate::rig::{Animation, Channel, Node, Place, Skin, Track};
use crate::{
    Aabb, Alpha, Between, Camera, CameraPath, Curve, Environment, Influences, Instance, Keys, Lens, Light,
    LightKind, Map, Maps, Material, Mesh, MorphTarget, Motion, Part, PathKey, Rig, Scene, Texture,
};

macro_rules! structs {
    ($($name:ident { $($field:ident),* $(,)? })*) => {$(
        impl Bytes for $name {
            fn write(&self, out: &mut Vec<u8>) {
                let Self { $($field),* } = self;
                $($field.write(out);)*
            }

            fn read(from: &mut &[u8]) -> Option<Self> {
                Some(Self { $($field: Bytes::read(from)?),* })
            }
        }
    )*};
}

/// Kinds with their numbers. Fields without names are called by their numbers.
macro_rules! enums {
    ($($name:ident$(<$T:ident>)? { $($number:literal = $kind:ident { $($field:tt: $value:ident),* })* })*) => {$(
        impl$(<$T: Bytes>)? Bytes for $name$(<$T>)? {
            fn write(&self, out: &mut Vec<u8>) {
                match self {
                    $(Self::$kind { $($field: $value),* } => {
                        out.push($number);
                        $($value.write(out);)*
                    })*
                }
            }

            fn read(from: &mut &[u8]) -> Option<Self> {
                match u8::read(from)? {
                    $($number => Some(Self::$kind { $($field: Bytes::read(from)?),* }),)*
                    _ => None,
                }
            }
        }
    )*};
}

structs! {
    Scene {
        name, meshes, instances, materials, textures, cameras, lights, path, rig, exposed_for, environment, origin,
    }
    Mesh { name, positions, normals, uvs, colours, influences, targets, indices, parts, bounds }
    Part { indices, material, bounds }
    Influences { per_vertex, joints, weights }
    MorphTarget { positions, normals }
    Aabb { min, max }
    Instance { name, mesh, world_from_mesh, motion, casts, node, skin }
    Material {
        name, base_colour, texture, metallic, roughness, specular, emission, alpha, transmission, unlit, casts, maps,
    }
    Maps { metallic_roughness, normal, occlusion, emission }
    Map { texture, picture_from_uv }
    Texture { name, width, height, rgba }
    Camera { name, world_from_camera, lens, near, far }
    CameraPath { keys }
    PathKey { eye, target }
    Light { name, world_from_light, colour, intensity, kind, near, motion }
    Environment { name, width, height, light }
    Rig { nodes, skins, animations, playing }
    Node { name, parent, rest, visible, weights }
    Skin { joints }
    Animation { name, seconds, channels }
    Channel { node, track }
}

enums! {
    Alpha { 0 = Opaque {} 1 = Mask { cutoff: a } 2 = Blend {} }
    Lens { 0 = Perspective { fov_y: a } 1 = Orthographic { half_height: a } }
    LightKind {
        0 = Directional {}
        1 = Spot { inner: a, outer: b, range: c }
        2 = Point { range: a }
    }
    Motion {
        0 = Still {}
        1 = Rotation { centre: a, axis: b, radians_per_second: c }
        2 = Node { node: a, node_from_thing: b }
        3 = Skin { node: a }
    }
    Place {
        0 = Parts { translation: a, rotation: b, scale: c }
        1 = Matrix { 0: a }
    }
    Track {
        0 = Translation { 0: a }
        1 = Rotation { 0: a }
        2 = Scale { 0: a }
        3 = Weights { 0: a }
        4 = Visible { 0: a }
    }
    Keys<T> { 0 = Step { 0: a } 1 = Linear { 0: a } 2 = Cubic { 0: a } }
}

impl<T: Bytes + Between> Bytes for Curve<T> {
    fn write(&self, out: &mut Vec<u8>) {
        self.times().to_vec().write(out);
        self.keys().write(out);
    }

    fn read(from: &mut &[u8]) -> Option<Self> {
        let (times, keys) = <(_, _)>::read(from)?;
        Self::new(times, keys)
    }
}

#[cfg(test)]
mod tests {
    use glam::{DMat4, Mat4, Quat, Vec3};

    use super::*;

    #[test]
    fn rigs_come_back_as_they_were() {
        let times = || vec![0.0, 0.5];
        let curve = |keys| Curve::new(times(), keys).expect("two keys");
        let tracks = [
            Track::Translation(curve(Keys::Step(vec![Vec3::X, Vec3::Y]))),
            Track::Scale(curve(Keys::Cubic(vec![[Vec3::X; 3], [Vec3::Y; 3]]))),
            Track::Rotation(Curve::new(times(), Keys::Linear(vec![Quat::IDENTITY; 2])).expect("two keys")),
            Track::Weights(
                Curve::new(times(), Keys::Linear(vec![vec![0.0, 1.0], vec![]])).expect("two keys"),
            ),
            Track::Visible(Curve::new(times(), Keys::Step(vec![true, false])).expect("two keys")),
        ];
        let node =
            |parent, rest| Node { name: "node".to_owned(), parent, rest, visible: true, weights: vec![0.25] };
        let rig = Rig {
            nodes: vec![
                node(None, Place::HERE),
                node(Some(0), Place::Matrix(DMat4::from_scale(glam::DVec3::splat(2.0)))),
            ],
            skins: vec![Skin { joints: vec![(1, Mat4::IDENTITY)] }],
            animations: vec![Animation {
                name: "walk".to_owned(),
                seconds: 0.5,
                channels: tracks.into_iter().map(|track| Channel { node: 1, track }).collect(),
            }],
            playing: Some(0),
        };
        let mut bytes = Vec::new();
        rig.write(&mut bytes);
        assert_eq!(Rig::read(&mut &bytes[..]), Some(rig));
    }
}
