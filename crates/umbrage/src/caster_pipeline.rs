//! Pipelines that draw casters: depth only, with the settings' raster bias and faces, and with the host's vertices, fragments and
//! groups.

use umbrage_core::CasterFaces;
use umbrage_wgsl::peel;

use crate::caster_state::{CasterState, cull_mode};

/// One shader of a caster pipeline.
#[derive(Clone, Copy, Debug)]
pub struct CasterStage<'a> {
    /// The module is [`crate::caster_wgsl`], or [`crate::second_caster_wgsl`] for the second surface, followed by the host's own
    /// text. A fragment stage may stand in another module than the vertex stage.
    pub module: &'a wgpu::ShaderModule,
    /// The entry point is the shader's name in the module.
    pub entry_point: &'a str,
    /// These are values of the module's pipeline-overridable constants, by their names or numbers; none by default.
    pub constants: &'a [(&'a str, f64)],
}

impl<'a> CasterStage<'a> {
    /// Takes a shader of a module, without values of constants.
    pub fn new(module: &'a wgpu::ShaderModule, entry_point: &'a str) -> Self {
        Self { module, entry_point, constants: &[] }
    }

    fn options(&self) -> wgpu::PipelineCompilationOptions<'a> {
        wgpu::PipelineCompilationOptions { constants: self.constants, ..Default::default() }
    }
}

/// The host's half of a caster pipeline: how vertices reach world space, and which fragments there are.
///
/// Casters with holes need a fragment stage, which discards. It calls `umbrage_caster_fragment(position)`, which does nothing in
/// [`crate::caster_wgsl`], and in [`crate::second_caster_wgsl`] leaves out the first surface that the light meets: so one text
/// serves both, compiled once behind each.
///
/// ```no_run
/// # fn pipelines(device: &wgpu::Device, shadows: &umbrage::Shadows, leaves: &wgpu::BindGroupLayout) {
/// use umbrage::{CasterPipeline, CasterStage, caster_wgsl, second_caster_wgsl};
/// const LEAVES: &str = "
///     @group(1) @binding(0) var leaf: texture_2d<f32>;
///     @group(1) @binding(1) var smooth_leaf: sampler;
///     struct V { @builtin(position) clip: vec4f, @location(0) uv: vec2f }
///     @vertex fn vertex(@location(0) world: vec3f, @location(1) uv: vec2f) -> V {
///         return V(umbrage_caster_position(world), uv);
///     }
///     @fragment fn fragment(v: V) {
///         umbrage_caster_fragment(v.clip);
///         if textureSample(leaf, smooth_leaf, v.uv).a < 0.5 { discard; }
///     }";
/// let attributes = wgpu::vertex_attr_array![0 => Float32x3, 1 => Float32x2];
/// let vertices = wgpu::VertexBufferLayout {
///     array_stride: 20,
///     step_mode: wgpu::VertexStepMode::Vertex,
///     attributes: &attributes,
/// };
/// let pipeline = |text: String, make: &dyn Fn(&CasterPipeline<'_>) -> Option<wgpu::RenderPipeline>| {
///     let source = wgpu::ShaderSource::Wgsl((text + LEAVES).into());
///     let module = &device.create_shader_module(wgpu::ShaderModuleDescriptor { label: None, source });
///     make(&CasterPipeline {
///         buffers: &[Some(vertices.clone())],
///         fragment: Some(CasterStage::new(module, "fragment")),
///         bind_group_layouts: &[leaves],
///         ..CasterPipeline::new(module, "vertex")
///     })
/// };
/// let first = pipeline(caster_wgsl(0), &|leaves| Some(shadows.caster_pipeline(device, leaves)));
/// let second = pipeline(second_caster_wgsl(0), &|leaves| shadows.second_caster_pipeline(device, leaves));
/// # }
/// ```
#[derive(Clone, Debug)]
pub struct CasterPipeline<'a> {
    /// The vertex shader returns `umbrage_caster_position(…)` as its position.
    pub vertex: CasterStage<'a>,
    /// The buffers are what it reads a vertex and an instance from; none by default.
    pub buffers: &'a [Option<wgpu::VertexBufferLayout<'a>>],
    /// The fragment shader discards what casts no shadow; `None`, the default, is for casters without holes, which draw faster.
    pub fragment: Option<CasterStage<'a>>,
    /// The layouts are those of the host's bind groups, from group 1 on; none by default.
    pub bind_group_layouts: &'a [&'a wgpu::BindGroupLayout],
    /// The topology says what vertices make up; a list of triangles by default.
    pub topology: wgpu::PrimitiveTopology,
    /// The index format of a strip that is drawn with indices; `None` by default.
    pub strip_index_format: Option<wgpu::IndexFormat>,
    /// The front face is counter-clockwise by default; clockwise is for meshes that are mirrored.
    pub front_face: wgpu::FrontFace,
    /// The faces that are drawn; `None`, the default, is those of the settings (`bias.casters`). Sheets without thickness want
    /// both.
    pub faces: Option<CasterFaces>,
    /// The bytes of immediates that the shaders read; 0 by default.
    pub immediate_size: u32,
    /// A cache of compiled pipelines, where the device has one; `None`, the default, is that of
    /// [`Shadows::with_pipeline_cache`](crate::Shadows::with_pipeline_cache).
    pub cache: Option<&'a wgpu::PipelineCache>,
}

impl<'a> CasterPipeline<'a> {
    /// Describes a pipeline with a vertex shader of a module, and defaults for all else.
    pub fn new(module: &'a wgpu::ShaderModule, entry_point: &'a str) -> Self {
        Self {
            vertex: CasterStage::new(module, entry_point),
            buffers: &[],
            fragment: None,
            bind_group_layouts: &[],
            topology: wgpu::PrimitiveTopology::TriangleList,
            strip_index_format: None,
            front_face: wgpu::FrontFace::Ccw,
            faces: None,
            immediate_size: 0,
            cache: None,
        }
    }

    /// The pipeline that draws in this state.
    pub(crate) fn make(&self, device: &wgpu::Device, state: CasterState<'_>) -> wgpu::RenderPipeline {
        let label = Some("Shadows::caster_pipeline");
        let own = std::iter::once(state.bind_group_layout);
        let groups: Vec<_> = own.chain(self.bind_group_layouts.iter().copied()).map(Some).collect();
        let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label,
            bind_group_layouts: &groups,
            immediate_size: self.immediate_size,
        });
        device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label,
            layout: Some(&layout),
            vertex: wgpu::VertexState {
                module: self.vertex.module,
                entry_point: Some(self.vertex.entry_point),
                compilation_options: self.vertex.options(),
                buffers: self.buffers,
            },
            primitive: wgpu::PrimitiveState {
                topology: self.topology,
                strip_index_format: self.strip_index_format,
                front_face: self.front_face,
                cull_mode: self.faces.map_or(state.primitive.cull_mode, cull_mode),
                ..state.primitive
            },
            depth_stencil: Some(state.depth_stencil),
            multisample: wgpu::MultisampleState::default(),
            fragment: self.fragment.map(|stage| wgpu::FragmentState {
                module: stage.module,
                entry_point: Some(stage.entry_point),
                compilation_options: stage.options(),
                targets: &[],
            }),
            multiview_mask: None,
            cache: self.cache,
        })
    }

    /// The pipeline that draws the second surface: where the host has no fragment stage, with one that leaves out the first.
    pub(crate) fn make_second(&self, device: &wgpu::Device, state: CasterState<'_>) -> wgpu::RenderPipeline {
        if self.fragment.is_some() {
            return self.make(device, state);
        }
        let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: Some("Shadows::peel"),
            source: wgpu::ShaderSource::Wgsl(peel().into()),
        });
        let fragment = Some(CasterStage::new(&module, "peel"));
        CasterPipeline { fragment, ..self.clone() }.make(device, state)
    }
}
