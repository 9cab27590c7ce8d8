//! What shaders know of a frame, as bytes: the camera, the biases, the lights and their views. Mirrors `shaders/frame.wgsl`.

use encase::{ShaderSize, ShaderType, StorageBuffer};
use glam::{DVec3, Mat4, UVec2, Vec2, Vec3, Vec4};
use umbrage_core::{
    DepthFormat, Light, LightKind, MAX_LIGHTS, Rays, Settings, Shade, ShadowPlan, ShadowView, Tile,
    TransparentCasters,
};

use crate::levels::{Levels, levels};
use crate::shared::shared_with_shaders;

shared_with_shaders! {
    struct View {
        clip_from_local: Mat4,
        tile: Vec4,
        depth_start: f32,
        depth_end: f32,
        clip_depth_end: f32,
        depth_metres: f32,
        near_metres: f32,
        light_kind: u32,
        depth_scale: Vec3,
        caster_error: f32,
        local_origin: Vec3,
        lattice: UVec2,
        depth_rounding: Vec2,
        held_x: Vec4,
        held_y: Vec4,
        held_w: Vec4,
    }
}

shared_with_shaders! {
    #[derive(Copy)]
    struct FrameLight {
        place: Vec3,
        kind: u32,
        first_view: u32,
        view_count: u32,
        size: f32,
        near: f32,
        axis: Vec3,
        range: f32,
        cos_rim: f32,
    }
}

shared_with_shaders! {
    struct Frame {
        depth_row: Vec4,
        clip_x_row: Vec4,
        clip_y_row: Vec4,
        clip_z_row: Vec4,
        clip_w_row: Vec4,
        shadow_end: f32,
        light_count: u32,
        map_size: Vec2,
        picture_size: Vec2,
        bias_constant: f32,
        bias_slope: f32,
        bias_slope_limit: f32,
        bias_bend: f32,
        bias_normal: f32,
        terminator: f32,
        depth_layer_limit: f32,
        blend: f32,
        transparent_casters: u32,
        shade: u32,
        darkness: f32,
        shadow_colour: Vec4,
        levels: Levels,
        lights: [FrameLight; MAX_LIGHTS],
        #[shader(size(runtime))]
        views: Vec<View>,
    }
}

/// The surroundings are what a frame stands in, beside its plan.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surroundings {
    /// The size of the maps' texture, texels.
    pub map_size: [u32; 2],
    /// The size of the camera's picture, pixels.
    pub picture_size: [u32; 2],
    /// The point of the world that shaders' positions are relative to: see
    /// [`Camera::local_origin`](umbrage_core::Camera::local_origin).
    pub origin: DVec3,
}

/// Writes frames into bytes that are kept from one frame to the next, so that none after the first allocates.
#[derive(Clone, Debug, Default)]
pub struct FrameBytes {
    frame: Frame,
    bytes: Vec<u8>,
}

impl FrameBytes {
    /// Bytes of the storage buffer that holds a frame with so many views.
    pub fn size(views: u32) -> u64 {
        Frame::min_size().get() + u64::from(views.max(1) - 1) * View::SHADER_SIZE.get()
    }

    /// Writes what a shader calls `umbrage_frame`, and returns its bytes.
    pub fn write(&mut self, plan: &ShadowPlan, settings: &Settings, surroundings: &Surroundings) -> &[u8] {
        let views = std::mem::take(&mut self.frame.views);
        self.frame = frame(plan, settings, surroundings, views);
        let written = self.frame.size().get() as usize;
        match StorageBuffer::new(&mut self.bytes).write(&self.frame) {
            Ok(()) => &self.bytes[..written],
            // A vector grows as it is written, so there is no error to report.
            Err(error) => unreachable!("a growing buffer refused a frame: {error}"),
        }
    }
}

/// A frame, in the room that `views` has.
fn frame(plan: &ShadowPlan, settings: &Settings, surroundings: &Surroundings, mut views: Vec<View>) -> Frame {
    let Surroundings { map_size, picture_size, origin } = *surroundings;
    let camera = plan.camera().relative_to(origin);
    let clip_from_world = camera.clip_from_world();
    let forward = camera.forward();
    let (shade, shadow_colour, darkness) = match settings.shade {
        Shade::Absence { darkness } => (ABSENCE, [0.0; 4], darkness),
        Shade::Colour { shadow_colour, darkness } => (COLOUR, shadow_colour, darkness),
    };
    let mut lights = [FrameLight::default(); MAX_LIGHTS];
    for (slot, (i, of)) in lights.iter_mut().zip(plan.lights().iter().enumerate()) {
        *slot = light(plan, settings, origin, i, of);
    }
    views.clear();
    let reach_texels = settings.filter.reach_texels();
    views.extend(plan.views().iter().map(|of| view(plan, origin, of, reach_texels)));
    Frame {
        depth_row: forward.extend(-forward.dot(camera.eye())),
        clip_x_row: clip_from_world.row(0),
        clip_y_row: clip_from_world.row(1),
        clip_z_row: clip_from_world.row(2),
        clip_w_row: clip_from_world.row(3),
        shadow_end: plan.splits().last().map_or(0.0, |end| *end as f32),
        light_count: plan.lights().len() as u32,
        map_size: sides(map_size),
        picture_size: sides(picture_size),
        bias_constant: settings.bias.constant,
        bias_slope: settings.bias.slope,
        bias_slope_limit: settings.bias.slope_limit,
        bias_bend: settings.bias.bend,
        bias_normal: settings.bias.normal,
        terminator: settings.bias.terminator,
        depth_layer_limit: settings.bias.depth_layer_limit,
        blend: settings.blend,
        transparent_casters: transparent_number(settings.transparent_casters),
        shade,
        darkness,
        shadow_colour: Vec4::from_array(shadow_colour),
        levels: levels(),
        lights,
        views,
    }
}

/// `UMBRAGE_SHADE_ABSENCE` and `UMBRAGE_SHADE_COLOUR` of `shaders/receiver/shade.wgsl`.
pub(crate) const ABSENCE: u32 = 0;
pub(crate) const COLOUR: u32 = 1;

/// `UMBRAGE_LIGHT_SUN` and so on, of `shaders/light.wgsl`.
pub(crate) fn kind_number(kind: LightKind) -> u32 {
    match kind {
        LightKind::Directional { .. } => 0,
        LightKind::Spot { .. } => 1,
        LightKind::Point { .. } => 2,
    }
}

/// `UMBRAGE_TRANSPARENT_DITHER` and so on, of `shaders/caster/covers.wgsl`.
pub(crate) fn transparent_number(casters: TransparentCasters) -> u32 {
    match casters {
        TransparentCasters::Dither => 0,
        TransparentCasters::Solid => 1,
        TransparentCasters::None => 2,
    }
}

fn sides([width, height]: [u32; 2]) -> Vec2 {
    Vec2::new(width as f32, height as f32)
}

fn light(plan: &ShadowPlan, settings: &Settings, origin: DVec3, index: usize, light: &Light) -> FrameLight {
    let mut views = plan.views().iter().filter(|view| view.light == index);
    let from_origin = |position: Vec3| (position.as_dvec3() - origin).as_vec3();
    let (place, axis, range, cos_rim) = match light.kind() {
        LightKind::Spot { position, direction, half_angle, range } => {
            (from_origin(position), direction.normalize_or(Vec3::NEG_Y), range, half_angle.cos())
        }
        LightKind::Point { position, range } => (from_origin(position), Vec3::ZERO, range, -2.0),
        LightKind::Directional { direction } => (-direction, Vec3::ZERO, f32::MAX, -2.0),
    };
    FrameLight {
        place,
        kind: kind_number(light.kind()),
        first_view: views.next().map_or(0, |view| view.index as u32),
        view_count: plan.views().iter().filter(|view| view.light == index).count() as u32,
        size: light.half_size(settings.filter.light_size().unwrap_or_default()),
        near: light.near(),
        axis,
        range: range.min(f32::MAX),
        cos_rim,
    }
}

fn view(plan: &ShadowPlan, origin: DVec3, view: &ShadowView, reach_texels: f32) -> View {
    let clip_from_local = view.clip_from_local(origin);
    let Tile { layer, x, y, size } = view.tile;
    View {
        clip_from_local,
        tile: Vec4::new(x as f32, y as f32, size as f32, layer as f32),
        depth_start: view.depths.start,
        depth_end: view.depths.end,
        clip_depth_end: plan.camera().clip_depth(view.depths.end),
        depth_metres: view.depth_metres,
        near_metres: view.near_metres,
        light_kind: plan.lights().get(view.light).map_or(0, |light| kind_number(light.kind())),
        depth_scale: view.depth_scale,
        caster_error: view.caster_error,
        local_origin: view.local_origin(origin),
        lattice: UVec2::from_array(view.lattice()),
        depth_rounding: depth_rounding(plan.settings().depth, view.rays, clip_from_local.w_axis.z),
        held_x: clip_from_local.row(0),
        held_y: clip_from_local.row(1),
        held_w: clip_from_local.row(3) * held_share(size, reach_texels),
    }
}

/// How much rounding may make of a depth that is stored in a view with these rays, and a translation along them, and of the one that
/// it is compared with: a number, and a share of the stored one. The depth of a parallel view is a sum whose terms are as large as
/// its translation, that of others is a quotient.
fn depth_rounding(format: DepthFormat, rays: Rays, translation: f32) -> Vec2 {
    match rays {
        Rays::Parallel => Vec2::new(format.step() + format.rounding() * (1.0 + translation.abs()), 0.0),
        Rays::FromApex { .. } => Vec2::new(format.step(), format.rounding()),
    }
}

/// What share of a map's half width, from its middle on, holds a filter's whole footprint; and a little more than what shaders may
/// round in finding out.
fn held_share(tile_size: u32, reach_texels: f32) -> f32 {
    /// 2⁷ of the steps in which f32 holds places at the border.
    const ROUNDED: f32 = 1e-5;
    1.0 + ROUNDED - 2.0 * reach_texels / tile_size as f32
}
