//! The one place that knows how the GPU's buffers are laid out. Mirrors `shaders/frame.wgsl`.

use encase::{ShaderSize, ShaderType, StorageBuffer};
use glam::{Mat4, Vec2, Vec3, Vec4};
use umbrage_core::{MAX_LIGHTS, MAX_SPLITS, Settings, Shade, ShadowPlan, normal_offset_texels};

#[derive(Clone, Copy, Debug, ShaderType)]
struct GpuView {
    clip_from_world: Mat4,
    tile_origin: Vec2,
    tile_size: f32,
    layer: i32,
    texel_metres: f32,
    depth_metres: f32,
}

#[derive(Clone, Copy, Debug, Default, ShaderType)]
struct GpuLight {
    direction_to_light: Vec3,
    first_view: u32,
}

#[derive(Clone, Debug, ShaderType)]
struct GpuFrame {
    depth_row: Vec4,
    clip_z_row: Vec4,
    clip_w_row: Vec4,
    split_ends: [f32; MAX_SPLITS],
    split_clip_ends: [f32; MAX_SPLITS],
    split_count: u32,
    light_count: u32,
    map_size: Vec2,
    bias_constant: f32,
    bias_slope: f32,
    bias_slope_limit: f32,
    bias_normal: f32,
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

/// What `shaders/frame.wgsl` calls `UmbrageFrame`, as bytes. `map_size` is the texture's, in texels.
pub(crate) fn frame(plan: &ShadowPlan, settings: &Settings, map_size: [u32; 2]) -> Vec<u8> {
    let camera = plan.camera();
    let clip_from_world = camera.clip_from_world();
    let forward = camera.forward();
    let ends = plan.splits().get(1..).unwrap_or_default();
    let per_split = |value: &dyn Fn(f32) -> f32| {
        std::array::from_fn(|i| ends.get(i).map_or(0.0, |end| value(*end as f32)))
    };
    let (shadow_colour, darkness) = match settings.shade {
        Shade::Absence { darkness } => ([0.0; 4], darkness),
        Shade::Colour { shadow_colour, darkness } => (shadow_colour, darkness),
    };
    let mut lights = [GpuLight::default(); MAX_LIGHTS];
    for (slot, (i, light)) in lights.iter_mut().zip(plan.lights().iter().enumerate()) {
        let first_view = plan.views().iter().position(|view| view.light == i).unwrap_or(0) as u32;
        *slot = GpuLight { direction_to_light: light.direction_to_light(), first_view };
    }
    let frame = GpuFrame {
        depth_row: forward.extend(-forward.dot(camera.eye())),
        clip_z_row: clip_from_world.row(2),
        clip_w_row: clip_from_world.row(3),
        split_ends: per_split(&|end| end),
        split_clip_ends: per_split(&|end| camera.clip_depth(end)),
        split_count: ends.len() as u32,
        light_count: plan.lights().len() as u32,
        map_size: Vec2::new(map_size[0] as f32, map_size[1] as f32),
        bias_constant: settings.bias.constant,
        bias_slope: settings.bias.slope,
        bias_slope_limit: settings.bias.slope_limit,
        bias_normal: normal_offset_texels(&settings.bias, settings.filter),
        shadow_colour: Vec4::from_array(shadow_colour),
        darkness,
        depth_step: settings.depth.step(),
        lights,
        views: plan.views().iter().map(view).collect(),
    };
    let mut buffer = StorageBuffer::new(Vec::new());
    match buffer.write(&frame) {
        Ok(()) => buffer.into_inner(),
        // A vector grows as it is written, so there is no error to report.
        Err(error) => unreachable!("a growing buffer refused a frame: {error}"),
    }
}

fn view(view: &umbrage_core::ShadowView) -> GpuView {
    GpuView {
        clip_from_world: view.clip_from_world,
        tile_origin: Vec2::new(view.tile.x as f32, view.tile.y as f32),
        tile_size: view.tile.size as f32,
        layer: view.tile.layer as i32,
        texel_metres: view.texel_metres,
        depth_metres: view.depth_metres,
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
        let view = ["clip_from_world", "tile_origin", "tile_size", "layer", "texel_metres", "depth_metres"];
        same("UmbrageView", &view, of_view);
        same("UmbrageLight", &["direction_to_light", "first_view"], |i| GpuLight::METADATA.offset(i));
        let frame = [
            "depth_row",
            "clip_z_row",
            "clip_w_row",
            "split_ends",
            "split_clip_ends",
            "split_count",
            "light_count",
            "map_size",
            "bias_constant",
            "bias_slope",
            "bias_slope_limit",
            "bias_normal",
            "shadow_colour",
            "darkness",
            "depth_step",
            "lights",
            "views",
        ];
        same("UmbrageFrame", &frame, |i| GpuFrame::METADATA.offset(i));
    }
}
