//! The pass that draws a scene's casters into a shadow view.

use umbrage::{CasterPipeline, ShadowView, Shadows, caster_wgsl};

use crate::draws::Draw;
use crate::gpu::Gpu;
use crate::placement::Placement;
use crate::scene_buffers::{CASTER_BUFFERS, SceneBuffers};
use crate::shaders;

/// How a scene's casters are drawn into any view.
#[derive(Debug)]
pub(crate) struct Casters {
    /// For instances as they are, and for instances that mirror their mesh: these turn its winding over.
    by_mirroring: [wgpu::RenderPipeline; 2],
    /// The same for views that clip casters at their near plane, where the others flatten them onto it.
    clipping_by_mirroring: Option<[wgpu::RenderPipeline; 2]>,
    /// The same for the second surface that the light meets, where there is one.
    second_by_mirroring: Option<[wgpu::RenderPipeline; 2]>,
    /// Group 1 of all.
    instances: wgpu::BindGroup,
}

/// Which surface a pass draws, of those that the light meets.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Surface {
    First,
    Second,
}

impl Casters {
    pub fn new(gpu: &Gpu, scene: &SceneBuffers, shadows: &Shadows) -> Self {
        let types = [(wgpu::ShaderStages::VERTEX, Placement::binding())];
        let layout = gpu.layout("Casters::layout", types);
        let instances = [scene.placement.buffer.as_entire_binding()];
        let instances = gpu.bind_group("Casters::instances", &layout, instances);
        let module = gpu.module("Casters::module", shaders::casters(&caster_wgsl(0)));
        let groups = [&layout];
        let vertices = [wgpu::FrontFace::Ccw, wgpu::FrontFace::Cw].map(|front_face| CasterPipeline {
            buffers: &CASTER_BUFFERS,
            bind_group_layouts: &groups,
            front_face,
            ..CasterPipeline::new(&module, "caster")
        });
        let [plain, mirrored] = &vertices;
        let first = |vertex| gpu.counted(shadows.caster_pipeline(&gpu.device, vertex));
        let clipping =
            |vertex| shadows.clipping_caster_pipeline(&gpu.device, vertex).map(|made| gpu.counted(made));
        let second =
            |vertex| shadows.second_caster_pipeline(&gpu.device, vertex).map(|made| gpu.counted(made));
        Self {
            by_mirroring: [plain, mirrored].map(first),
            clipping_by_mirroring: clipping(plain).zip(clipping(mirrored)).map(<[_; 2]>::from),
            second_by_mirroring: second(plain).zip(second(mirrored)).map(<[_; 2]>::from),
            instances,
        }
    }

    /// Whether each view is drawn once more, for the second surface that the light meets.
    pub fn has_second(&self) -> bool {
        self.second_by_mirroring.is_some()
    }

    /// Draws casters into a pass that [`Shadows`] began.
    pub fn record(
        &self,
        pass: &mut wgpu::RenderPass<'_>,
        view: &ShadowView,
        surface: Surface,
        scene: &SceneBuffers,
        instance_numbers: &wgpu::Buffer,
        draws: &[Draw],
    ) {
        let pipelines = match surface {
            Surface::First if view.unclipped_depth => Some(&self.by_mirroring),
            Surface::First => self.clipping_by_mirroring.as_ref().or(Some(&self.by_mirroring)),
            Surface::Second => self.second_by_mirroring.as_ref(),
        };
        let Some(pipelines) = pipelines else { return };
        pass.set_bind_group(1, &self.instances, &[]);
        scene.bind_casters(pass, instance_numbers);
        let mut set = None;
        for draw in draws {
            if set != Some(draw.mirrored) {
                pass.set_pipeline(&pipelines[usize::from(draw.mirrored)]);
                set = Some(draw.mirrored);
            }
            pass.draw_indexed(draw.indices.clone(), draw.base_vertex, draw.instances.clone());
        }
    }
}
