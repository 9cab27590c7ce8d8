//! The pass that draws a scene's casters into a shadow view: pipelines for each cover that surfaces have, and for instances
//! that mirror their mesh.

use umbrage::{
    CasterFaces, CasterPipeline, CasterStage, ShadowView, Shadows, caster_wgsl, second_caster_wgsl,
};

use crate::caster_geometry::CasterGeometry;
use crate::cover::Cover;
use crate::draws::{Draw, Geometry};
use crate::gpu::Gpu;
use crate::placement::Placement;
use crate::scene_buffers::{CASTER_BUFFERS, RECEIVER_BUFFERS, SceneBuffers};
use crate::shaders;

/// How a scene's casters are drawn into any view.
#[derive(Debug)]
pub(crate) struct Casters {
    first: Pipelines,
    /// The same for views that clip casters at their near plane, where the others flatten them onto it.
    clipping: Option<Pipelines>,
    /// The same for the second surface that the light meets, where there is one: flattening, and clipping.
    second: Option<Pipelines>,
    clipping_second: Option<Pipelines>,
    /// Group 1 of all.
    instances: wgpu::BindGroup,
}

/// Pipelines by what they draw.
type Pipelines = Vec<(Kind, ByMirroring)>;

/// One for instances as they are, and one for those that mirror their mesh, which turns its winding over.
type ByMirroring = [wgpu::RenderPipeline; 2];

/// What a pipeline draws: a cover, all faces of it or those that face the light, where the others need not be drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Kind {
    cover: Cover,
    front_only: bool,
}

/// Which surface a pass draws, of those that the light meets.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Surface {
    First,
    Second,
}

/// The buffers that casters are drawn from.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Vertices<'a> {
    pub scene: &'a SceneBuffers,
    /// What draws of [`Geometry::Levels`] read; there are none of these where it is `None`.
    pub levels: Option<&'a CasterGeometry>,
    pub instance_numbers: &'a wgpu::Buffer,
}

impl Vertices<'_> {
    /// Gives a pass what draws of a geometry read, and says whether there is such a geometry.
    fn bind(&self, pass: &mut wgpu::RenderPass<'_>, geometry: Geometry, is_solid: bool) -> bool {
        let Self { scene, levels, instance_numbers } = self;
        match (geometry, levels) {
            (Geometry::Levels, Some(levels)) => levels.bind(pass, instance_numbers),
            (Geometry::Levels, None) => return false,
            (Geometry::Meshes, _) if is_solid => scene.bind_casters(pass, instance_numbers),
            (Geometry::Meshes, _) => scene.bind_surfaces(pass, instance_numbers),
        }
        true
    }
}

impl Casters {
    pub fn new(gpu: &Gpu, scene: &SceneBuffers, shadows: &Shadows) -> Self {
        let types = [(wgpu::ShaderStages::VERTEX, Placement::binding())];
        let layout = gpu.layout("Casters::layout", types);
        let instances = [scene.placement.buffer.as_entire_binding()];
        let instances = gpu.bind_group("Casters::instances", &layout, instances);
        // Where all faces cast, those of what is closed that face the light are met first.
        let fronts = shadows.settings().bias.casters == CasterFaces::Both;
        let (first, second) = ((caster_wgsl(0), fronts), (second_caster_wgsl(0), false));
        let pipelines = |(library, fronts): &(String, bool), make: &Make<'_>| {
            pipelines(gpu, scene, &layout, (library, *fronts), make)
        };
        let device = &gpu.device;
        Self {
            first: pipelines(&first, &|caster| Some(shadows.caster_pipeline(device, caster)))
                .unwrap_or_default(),
            clipping: pipelines(&first, &|caster| shadows.clipping_caster_pipeline(device, caster)),
            second: pipelines(&second, &|caster| shadows.second_caster_pipeline(device, caster)),
            clipping_second: pipelines(&second, &|caster| {
                shadows.clipping_second_caster_pipeline(device, caster)
            }),
            instances,
        }
    }

    /// Whether each view is drawn once more, for the second surface that the light meets.
    pub fn has_second(&self) -> bool {
        self.second.is_some()
    }

    /// Draws casters into a pass that [`Shadows`] began.
    pub fn record(
        &self,
        pass: &mut wgpu::RenderPass<'_>,
        view: &ShadowView,
        surface: Surface,
        vertices: &Vertices<'_>,
        draws: [&[Draw]; 2],
    ) {
        let pipelines = match surface {
            Surface::First if view.unclipped_depth => Some(&self.first),
            Surface::First => self.clipping.as_ref().or(Some(&self.first)),
            Surface::Second if view.unclipped_depth => self.second.as_ref(),
            Surface::Second => self.clipping_second.as_ref().or(self.second.as_ref()),
        };
        let Some(pipelines) = pipelines else { return };
        pass.set_bind_group(1, &self.instances, &[]);
        let (mut set, mut buffers, mut material) = (None, None, None);
        let is_outside = is_outside(view);
        for draw in draws.into_iter().flatten() {
            let is_solid = draw.cover == Cover::Solid;
            let kind = Kind { cover: draw.cover, front_only: draw.closed && is_outside };
            if set != Some((kind, draw.mirrored)) {
                let Some(by_mirroring) = found(pipelines, kind) else { continue };
                pass.set_pipeline(&by_mirroring[usize::from(draw.mirrored)]);
                set = Some((kind, draw.mirrored));
            }
            if buffers != Some((draw.geometry, is_solid)) {
                if !vertices.bind(pass, draw.geometry, is_solid) {
                    continue;
                }
                buffers = Some((draw.geometry, is_solid));
            }
            if !is_solid && material != Some(draw.material) {
                pass.set_bind_group(2, &vertices.scene.materials.groups[draw.material as usize], &[]);
                material = Some(draw.material);
            }
            pass.draw_indexed(draw.indices.clone(), draw.base_vertex, draw.instances.clone());
        }
    }
}

/// Whether light comes into a view from outside all that is closed, and no warp turns triangles over: where it is even, and a
/// sun's.
fn is_outside(view: &ShadowView) -> bool {
    view.clip_from_world.row(3) == glam::DVec4::W
}

/// The pipelines of a kind; those that draw all faces where no others are made.
fn found(pipelines: &Pipelines, wanted: Kind) -> Option<&ByMirroring> {
    let of = |wanted: Kind| pipelines.iter().find(|(kind, _)| *kind == wanted).map(|(_, found)| found);
    of(wanted).or_else(|| of(Kind { front_only: false, ..wanted }))
}

/// Makes a pipeline of one kind, where there is that kind.
type Make<'a> = dyn Fn(&CasterPipeline<'_>) -> Option<wgpu::RenderPipeline> + 'a;

/// Pipelines of one kind for all covers of a scene, behind the library's text; also for those faces alone that face the light,
/// where that is asked for.
fn pipelines(
    gpu: &Gpu,
    scene: &SceneBuffers,
    instances: &wgpu::BindGroupLayout,
    (library, fronts): (&str, bool),
    make: &Make<'_>,
) -> Option<Pipelines> {
    let [positions, numbers, attributes] = RECEIVER_BUFFERS;
    let surfaces = [positions, numbers, attributes, Some(scene.colours.stream.clone())];
    let groups = [instances, &scene.materials.layout];
    let one = |kind: Kind| {
        let cover = &kind.cover;
        let module = gpu.module("Casters::module", shaders::casters(library, *cover));
        let solid = CasterPipeline {
            buffers: &CASTER_BUFFERS,
            bind_group_layouts: &groups[..1],
            ..CasterPipeline::new(&module, "caster")
        };
        let cut = |fragment| CasterPipeline {
            buffers: &surfaces,
            bind_group_layouts: &groups,
            fragment: Some(CasterStage::new(&module, fragment)),
            ..CasterPipeline::new(&module, "cut_caster")
        };
        let caster = match cover {
            Cover::Solid if kind.front_only => CasterPipeline { faces: Some(CasterFaces::Front), ..solid },
            Cover::Solid => solid,
            Cover::Cut => cut("cut_out"),
            Cover::Veil => cut("dither"),
        };
        let [plain, mirrored] = [wgpu::FrontFace::Ccw, wgpu::FrontFace::Cw].map(|front_face| {
            make(&CasterPipeline { front_face, ..caster.clone() }).map(|made| gpu.counted(made))
        });
        Some((kind, [plain?, mirrored?]))
    };
    let kinds = scene.covers.iter().flat_map(|cover| {
        let fronts = (fronts && *cover == Cover::Solid).then_some(true);
        std::iter::once(false).chain(fronts).map(|front_only| Kind { cover: *cover, front_only })
    });
    kinds.map(one).collect()
}
