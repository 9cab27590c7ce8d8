//! Shadows in a deferred renderer: one pass writes normals and depth, and a lighting pass makes positions of depth again and asks for
//! visibility, once a pixel. Its bindings and the library's share a group. Drawn to `deferred.ppm`.
//! `cargo run --release -p umbrage --example deferred`

#[expect(dead_code, reason = "what other programs need")]
mod off_screen;
#[expect(dead_code, reason = "what other programs need")]
mod world;

use off_screen::{COLOUR, DEPTH, Result, camera_text, module, pass, pipeline, read, save, target};
use umbrage::glam::Vec3;
use umbrage::{Camera, Light, Projection, Settings, Shadows, Slot};
use world::{SEEN, VERTICES, World, caster_pipeline, draw_maps};

const NORMALS: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;
/// Bindings 0 and 1 of group 0 are mine.
const SLOT: Slot = Slot { group: 0, first_binding: 2 };

const MY_SURFACES: &str = "
    @fragment fn fragment(v: V) -> @location(0) vec4f { return vec4f(v.normal * .5 + .5, 1.); }";
const MY_LIGHTING: &str = "
    @group(0) @binding(0) var normals: texture_2d<f32>;
    @group(0) @binding(1) var depths: texture_depth_2d;
    @vertex fn everywhere(@builtin(vertex_index) v: u32) -> @builtin(position) vec4f {
        return vec4f(f32(v & 1u) * 4. - 1., f32(v >> 1u) * 4. - 1., 0., 1.);
    }
    @fragment fn lighting(@builtin(position) position: vec4f) -> @location(0) vec4f {
        let pixel = vec2u(position.xy);
        let depth = textureLoad(depths, pixel, 0);
        if depth == 0. { return vec4f(.6, .7, .9, 1.); }
        let ndc = position.xy / vec2f(textureDimensions(depths)) * vec2f(2., -2.) + vec2f(-1., 1.);
        let world = WORLD_FROM_CLIP * vec4f(ndc, depth, 1.);
        // The geometric normal: a normal map's is for the light, and not for the shadow.
        let normal = normalize(textureLoad(normals, pixel, 0).xyz * 2. - 1.);
        let sun = max(dot(normal, normalize(vec3f(.6, .7, .2))), 0.);
        let visible = umbrage_visibility(world.xyz / world.w, normal, position.xy);                       // umbrage
        return vec4f(umbrage_shade(vec3f(.12, .14, .2), vec3f(.8, .75, .65) * sun, visible), 1.);         // umbrage
    }";

fn main() -> Result<()> {
    save("deferred.ppm", &draw(Settings::default())?)
}

pub(crate) fn draw(settings: Settings) -> Result<Vec<u8>> {
    let (device, queue) = off_screen::device()?;
    let world = World::columns(&device, &queue);
    let projection = Projection::Perspective { fov_y: 0.6, aspect: 1.0 };
    let camera = Camera::looking(Vec3::new(22.0, 14.0, 30.0), Vec3::ZERO, Vec3::Y, projection, 1.0, 100.0)?;
    let lights = [Light::directional(Vec3::new(-0.6, -0.7, -0.2))?];
    let mut shadows = Shadows::new(&device, settings)?;
    let plan = shadows.plan(&camera, &lights, &world.bounds)?;
    let casters = caster_pipeline(&device, &shadows);
    let mut encoder = device.create_command_encoder(&Default::default());
    draw_maps((&queue, &mut encoder), (&mut shadows, &plan), (&casters, &world))?;

    let surfaces = module(&device, &[&camera_text(&camera), SEEN, MY_SURFACES]);
    let surfaces = pipeline(&device, &surfaces, &[], &[Some(VERTICES)], &[NORMALS]);
    let (normals, depths) = (target(&device, NORMALS), target(&device, DEPTH));
    let mut first = pass(&mut encoder, &[&normals], Some(&depths));
    first.set_pipeline(&surfaces);
    world.draw(&mut first);
    drop(first);

    let (layout, group) = my_group(&device, &shadows, &normals, &depths);
    let lighting = module(&device, &[&shadows.wgsl(SLOT), &camera_text(&camera), MY_LIGHTING]);
    let lighting = pipeline(&device, &lighting, &[&layout], &[], &[COLOUR]);
    let (colour, unused) = (target(&device, COLOUR), target(&device, DEPTH));
    let mut second = pass(&mut encoder, &[&colour], Some(&unused));
    second.set_pipeline(&lighting);
    second.set_bind_group(0, &group, &[]);
    second.draw(0..3, 0..1);
    drop(second);
    read((&device, &queue), encoder, &colour)
}

/// A group with my textures, and then what the library binds.
fn my_group(
    device: &wgpu::Device,
    shadows: &Shadows,
    normals: &wgpu::Texture,
    depths: &wgpu::Texture,
) -> (wgpu::BindGroupLayout, wgpu::BindGroup) {
    let texture = |binding, sample_type| wgpu::BindGroupLayoutEntry {
        binding,
        visibility: wgpu::ShaderStages::FRAGMENT,
        ty: wgpu::BindingType::Texture {
            sample_type,
            view_dimension: wgpu::TextureViewDimension::D2,
            multisampled: false,
        },
        count: None,
    };
    let mine = [
        texture(0, wgpu::TextureSampleType::Float { filterable: false }),
        texture(1, wgpu::TextureSampleType::Depth),
    ];
    let entries = [&mine[..], &shadows.bind_group_layout_entries(SLOT.first_binding)].concat();
    let layout =
        device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor { label: None, entries: &entries });
    let views = [normals, depths].map(|texture| texture.create_view(&Default::default()));
    let mine = (0..).zip(&views).map(|(binding, view)| wgpu::BindGroupEntry {
        binding,
        resource: wgpu::BindingResource::TextureView(view),
    });
    let entries: Vec<_> = mine.chain(shadows.bind_group_entries(SLOT.first_binding)).collect();
    let group = device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: None,
        layout: &layout,
        entries: &entries,
    });
    (layout, group)
}
