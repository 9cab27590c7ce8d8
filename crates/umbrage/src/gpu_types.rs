//! The one place that knows how the GPU's buffers are laid out. Mirrors `shaders/frame.wgsl`.

use encase::{ShaderSize, ShaderType, StorageBuffer};
use glam::{Mat4, Vec2, Vec3, Vec4};
use umbrage_core::{Light, LightKind, MAX_LIGHTS, Rays, Settings, Shade, ShadowPlan};

#[derive(Clone, Copy, Debug, ShaderType)]
struct GpuView {
    clip_from_world: Mat4,
    tile_origin: Vec2,
    tile_size: f32,
    layer: i32,
    depth_start: f32,
    depth_end: f32,
    clip_depth_end: f32,
    depth_metres: f32,
    near_metres: f32,
    spreads: u32,
    inverse_weight: Vec3,
}

#[derive(Clone, Copy, Debug, Default, ShaderType)]
struct GpuLight {
    place: Vec4,
    first_view: u32,
    view_count: u32,
    is_cube: u32,
    size: f32,
}

#[derive(Clone, Debug, ShaderType)]
struct GpuFrame {
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
    bias_normal: f32,
    terminator: f32,
    shadow_colour: Vec4,
    darkness: f32,
    depth_step: f32,
    lights: [GpuLight; MAX_LIGHTS],
    #[shader(size(runtime))]
    views: Vec<GpuView>,
}

/// Bytes of a frame buffer that holds `views` views.
pub(crate) fn frame_bytes(views: u32) -> u64 {
    GpuFrame::min_size().get() + u64::from(views.max(1) - 1) * GpuView::SHADER_SIZE.get()
}

/// What `shaders/frame.wgsl` calls `UmbrageFrame`, as bytes. `map_size` is the maps' texture, in texels, `picture_size` what
/// the camera fills, in pixels.
pub(crate) fn frame(
    plan: &ShadowPlan,
    settings: &Settings,
    map_size: [u32; 2],
    picture_size: [u32; 2],
) -> Vec<u8> {
    let camera = plan.camera();
    let clip_from_world = camera.clip_from_world();
    let forward = camera.forward();
    let (shadow_colour, darkness) = match settings.shade {
        Shade::Absence { darkness } => ([0.0; 4], darkness),
        Shade::Colour { shadow_colour, darkness } => (shadow_colour, darkness),
    };
    let mut lights = [GpuLight::default(); MAX_LIGHTS];
    for (slot, (i, of)) in lights.iter_mut().zip(plan.lights().iter().enumerate()) {
        *slot = light(plan, settings, i, of);
    }
    let frame = GpuFrame {
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
        bias_normal: settings.bias.normal,
        terminator: settings.bias.terminator,
        shadow_colour: Vec4::from_array(shadow_colour),
        darkness,
        depth_step: settings.depth.step(),
        lights,
        views: plan.views().iter().map(|of| view(plan, of)).collect(),
    };
    let mut buffer = StorageBuffer::new(Vec::new());
    match buffer.write(&frame) {
        Ok(()) => buffer.into_inner(),
        // A vector grows as it is written, so there is no error to report.
        Err(error) => unreachable!("a growing buffer refused a frame: {error}"),
    }
}

fn sides([width, height]: [u32; 2]) -> Vec2 {
    Vec2::new(width as f32, height as f32)
}

fn light(plan: &ShadowPlan, settings: &Settings, index: usize, light: &Light) -> GpuLight {
    let mut views = plan.views().iter().filter(|view| view.light == index);
    let place = match light.kind() {
        LightKind::Spot { position, .. } | LightKind::Point { position, .. } => position.extend(1.0),
        LightKind::Directional { direction } => (-direction).extend(0.0),
    };
    GpuLight {
        place,
        first_view: views.next().map_or(0, |view| view.index as u32),
        view_count: plan.views().iter().filter(|view| view.light == index).count() as u32,
        is_cube: u32::from(matches!(light.kind(), LightKind::Point { .. })),
        size: light.half_size(settings.filter.light_size().unwrap_or_default()),
    }
}

fn view(plan: &ShadowPlan, view: &umbrage_core::ShadowView) -> GpuView {
    GpuView {
        clip_from_world: view.clip_from_world,
        tile_origin: Vec2::new(view.tile.x as f32, view.tile.y as f32),
        tile_size: view.tile.size as f32,
        layer: view.tile.layer as i32,
        depth_start: view.depths.start,
        depth_end: view.depths.end,
        clip_depth_end: plan.camera().clip_depth(view.depths.end),
        depth_metres: view.depth_metres,
        near_metres: view.near_metres,
        spreads: match view.rays {
            Rays::Parallel => 0,
            Rays::FromApex => 1,
        },
        inverse_weight: view.inverse_weight,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Where naga puts the members of a struct of the shader.
    fn offsets(name: &str) -> Vec<(String, u64)> {
        let module = naga::front::wgsl::parse_str(include_str!("../shaders/frame.wgsl")).unwrap();
        let (_, found) = module.types.iter().find(|(_, t)| t.name.as_deref() == Some(name)).unwrap();
        let naga::TypeInner::Struct { members, .. } = &found.inner else { panic!("{name} is a struct") };
        members.iter().map(|m| (m.name.clone().unwrap(), u64::from(m.offset))).collect()
    }

    fn same(name: &str, fields: &[&str], offset: impl Fn(usize) -> u64) {
        let expected: Vec<_> = fields.iter().enumerate().map(|(i, f)| ((*f).to_owned(), offset(i))).collect();
        assert_eq!(offsets(name), expected);
    }

    #[test]
    fn shader_and_rust_agree_where_every_field_lies() {
        let of_view = |i| GpuView::METADATA.offset(i);
        let view = [
            "clip_from_world",
            "tile_origin",
            "tile_size",
            "layer",
            "depth_start",
            "depth_end",
            "clip_depth_end",
            "depth_metres",
            "near_metres",
            "spreads",
            "inverse_weight",
        ];
        same("UmbrageView", &view, of_view);
        same("UmbrageLight", &["place", "first_view", "view_count", "is_cube", "size"], |i| {
            GpuLight::METADATA.offset(i)
        });
        let frame = [
            "depth_row",
            "clip_x_row",
            "clip_y_row",
            "clip_z_row",
            "clip_w_row",
            "shadow_end",
            "light_count",
            "map_size",
            "picture_size",
            "bias_constant",
            "bias_slope",
            "bias_slope_limit",
            "bias_normal",
            "terminator",
            "shadow_colour",
            "darkness",
            "depth_step",
            "lights",
            "views",
        ];
        same("UmbrageFrame", &frame, |i| GpuFrame::METADATA.offset(i));
    }
}
