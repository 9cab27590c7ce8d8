//! From Bevy's camera and light to Umbrage's, and from Umbrage's views to Bevy's cascades.

use bevy::light::cascade::Cascade;
use bevy::math::{DMat4, DVec3, DVec4};
use bevy::prelude::*;
use umbrage_core::{Camera as Eye, CameraError, Light, LightError, ShadowView};

/// Why a camera's cascades stay Bevy's own.
#[derive(Clone, Debug)]
pub(crate) enum Unfit {
    /// The camera's rays neither meet in a point nor are parallel, as far as anyone knows.
    Custom,
    /// The box that the camera sees is not even about its axis.
    Aside,
    /// Umbrage refuses the camera.
    Refused(CameraError),
}

impl std::fmt::Display for Unfit {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Custom => f.write_str("its projection is a custom one; give it a perspective one"),
            Self::Aside => f.write_str(
                "its orthographic area is not even about its axis; move the camera instead, and set `viewport_origin` to the middle",
            ),
            Self::Refused(why) => write!(f, "{why}"),
        }
    }
}

/// A camera as Umbrage plans for it, and how much its view depths are larger than Bevy's, metres.
pub(crate) struct Seen {
    /// The camera.
    pub eye: Eye,
    /// What is added to a view depth of Bevy's.
    pub behind: f32,
}

impl Seen {
    /// The camera, which sees at most `distance` metres far.
    pub fn of(
        transform: &GlobalTransform,
        projection: &Projection,
        minimum: f32,
        distance: f32,
    ) -> Result<Self, Unfit> {
        let (_, rotation, translation) = transform.to_scale_rotation_translation();
        let at = |behind: f32| {
            Mat4::from_rotation_translation(rotation, translation + rotation * Vec3::Z * behind)
        };
        let made = |behind: f32, rays, near: f32, far: f32| {
            let eye = Eye::new(at(behind), rays, near + behind, far.min(distance) + behind)
                .map_err(Unfit::Refused)?;
            Ok(Self { eye, behind })
        };
        match projection {
            Projection::Perspective(lens) => {
                let rays =
                    umbrage_core::Projection::Perspective { fov_y: lens.fov, aspect: lens.aspect_ratio };
                made(0.0, rays, lens.near.max(minimum), lens.far)
            }
            Projection::Orthographic(lens) => {
                let (half, middle) = (lens.area.half_size(), lens.area.center());
                if middle.abs().max_element() > 1e-3 * half.min_element() {
                    return Err(Unfit::Aside);
                }
                let rays =
                    umbrage_core::Projection::Orthographic { half_height: half.y, aspect: half.x / half.y };
                // Umbrage's cameras stand before what they see; where rays are parallel, any distance will do.
                made((1.0 - lens.near).max(0.0), rays, lens.near, lens.far)
            }
            Projection::Custom(_) => Err(Unfit::Custom),
        }
    }
}

/// A light's sun.
pub(crate) fn sun(transform: &GlobalTransform) -> Result<Light, LightError> {
    Light::directional(transform.forward().into())
}

/// A view as Bevy draws it: an eye in the middle of the near plane, which looks along the light.
pub(crate) fn cascade(view: &ShadowView) -> Cascade {
    let clip_from_world = view.clip_from_local(DVec3::ZERO);
    let exact = clip_from_world.as_dmat4();
    let rows = [0, 1, 2].map(|row| exact.row(row).truncate());
    let [right, up, back] = rows.map(DVec3::normalize_or_zero);
    let near = exact.inverse().project_point3(DVec3::Z);
    let world_from_cascade =
        DMat4::from_cols(right.extend(0.0), up.extend(0.0), back.extend(0.0), near.extend(1.0));
    let [x, y, z] = rows.map(DVec3::length);
    let clip_from_cascade =
        DMat4::from_cols(DVec4::X * x, DVec4::Y * y, DVec4::Z * z, DVec4::new(0.0, 0.0, 1.0, 1.0));
    Cascade {
        world_from_cascade: world_from_cascade.as_mat4(),
        clip_from_cascade: clip_from_cascade.as_mat4(),
        clip_from_world,
        texel_size: view.texel_metres,
    }
}

#[cfg(test)]
mod tests {
    use umbrage_core::{Bounds, DepthFormat, Settings, plan};

    use super::*;

    fn perspective() -> Projection {
        Projection::Perspective(PerspectiveProjection { far: 200.0, ..default() })
    }

    #[test]
    fn a_cascade_is_one_matrix_and_its_two_parts() {
        let eye =
            GlobalTransform::from(Transform::from_xyz(40.0, 12.0, -7.0).looking_at(Vec3::ZERO, Vec3::Y));
        let seen = Seen::of(&eye, &perspective(), 0.1, 150.0).expect("a camera");
        let sun = Light::directional(Vec3::new(-0.3, -0.8, 0.2)).expect("a sun");
        let bounds = Bounds::of_world(Vec3::splat(-100.0), Vec3::splat(100.0));
        let settings = Settings { depth: DepthFormat::F32, ..Settings::default() };
        let plan = plan(&seen.eye, &[sun], &bounds, &settings).expect("a plan");
        assert_eq!(plan.views().len(), 4);
        for view in plan.views() {
            let cascade = cascade(view);
            let joined = cascade.clip_from_cascade * cascade.world_from_cascade.inverse();
            let differ = (joined - cascade.clip_from_world).to_cols_array();
            assert!(differ.iter().all(|entry| entry.abs() < 1e-4), "{joined} {}", cascade.clip_from_world);
            // Culling of back faces goes by the hand of this.
            assert!((cascade.world_from_cascade.determinant() - 1.0).abs() < 1e-4);
            let toward_light = cascade.world_from_cascade.z_axis.truncate();
            assert!(toward_light.dot(Vec3::new(0.3, 0.8, -0.2).normalize_or_zero()) > 0.9999);
        }
    }

    #[test]
    fn cameras_see_as_far_as_there_are_shadows_even_without_an_end() {
        let endless = Projection::Perspective(PerspectiveProjection { far: f32::INFINITY, ..default() });
        let seen = Seen::of(&GlobalTransform::IDENTITY, &endless, 0.0, 150.0).expect("a camera");
        assert_eq!((seen.eye.near(), seen.eye.far(), seen.behind), (0.1, 150.0, 0.0));
    }

    #[test]
    fn orthographic_cameras_may_see_what_is_behind_them() {
        let lens = OrthographicProjection {
            near: -50.0,
            far: 80.0,
            area: Rect::new(-4.0, -3.0, 4.0, 3.0),
            ..OrthographicProjection::default_3d()
        };
        let seen = Seen::of(&GlobalTransform::IDENTITY, &Projection::Orthographic(lens.clone()), 0.0, 60.0);
        let seen = seen.expect("a camera");
        assert_eq!((seen.eye.near(), seen.eye.far(), seen.behind), (1.0, 111.0, 51.0));
        assert_eq!(seen.eye.eye(), Vec3::Z * 51.0);
        let aside = OrthographicProjection { area: Rect::new(0.0, -3.0, 8.0, 3.0), ..lens };
        let refused = Seen::of(&GlobalTransform::IDENTITY, &Projection::Orthographic(aside), 0.0, 60.0);
        assert!(matches!(refused, Err(Unfit::Aside)));
    }

    #[test]
    fn a_camera_that_cannot_see_is_refused_with_a_reason() {
        let eye = GlobalTransform::IDENTITY;
        let refused = Seen::of(&eye, &perspective(), 0.1, 0.05).err().expect("shadows end before they begin");
        assert!(refused.to_string().contains("0.05"), "{refused}");
    }
}
