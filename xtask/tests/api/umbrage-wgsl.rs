// binding.rs
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Binding {
    pub binding: u32,
    pub name: &'static str,
    pub kind: BindingKind,
    pub stages: Stages,
}
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum BindingKind {
    Storage,
    WrittenStorage,
    Uniform { has_dynamic_offset: bool },
    Texture { sample: SampleType, dimension: Dimension },
    StorageTexture { format: TexelFormat },
    Sampler(SamplerKind),
}
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum SampleType {
    Depth,
    FilterableFloat,
    Float,
    Uint,
}
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Dimension {
    D2,
    D2Multisampled,
    D2Array,
}
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum SamplerKind {
    Comparison,
    Filtering,
    NonFiltering,
}
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Stages {
    Vertex,
    Fragment,
    VertexAndFragment,
    Compute,
    FragmentAndCompute,
}

// contact_camera.rs
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct ContactDepth {
    pub forward: bool,
    pub multisampled: bool,
}
pub const CONTACT_CAMERA_BYTES: usize = 160;
pub fn contact_camera(camera: &Camera) -> [u8; CONTACT_CAMERA_BYTES] {}

// error.rs
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum ImportError {
    Module { module: String, by: String },
    Name { name: String, from: String, by: String },
    Circle { module: String, by: String },
    Malformed { line: String, by: String },
    Binding { line: String },
}

// format.rs
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum TexelFormat {
    R32Float,
    Rg32Float,
    Rgba32Float,
    Rg16Float,
    Rgba16Float,
    Rgba16Unorm,
    Rg32Uint,
    Rgba32Uint,
}
impl TexelFormat {
    pub fn wgsl(self) -> &'static str {}
    pub fn bytes(self) -> u64 {}
}
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct TextureSupport {
    pub loads_depth: bool,
    pub filters_float32: bool,
    pub has_unorm16: bool,
    pub writes_two_float16: bool,
}
impl TextureSupport {
    pub const ALL: Self = Self {
        loads_depth: true,
        filters_float32: true,
        has_unorm16: true,
        writes_two_float16: true,
    };
    pub const WEBGPU: Self = Self {
        loads_depth: true,
        filters_float32: false,
        has_unorm16: false,
        writes_two_float16: false,
    };
}
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct MomentFormat {
    pub format: TexelFormat,
    pub is_filterable: bool,
    pub rounds: bool,
}
impl MomentFormat {
    pub fn new(
        precision: TexelPrecision,
        channels: u32,
        support: TextureSupport,
    ) -> Self {}
}

// frame.rs
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surroundings {
    pub map_size: [u32; 2],
    pub picture_size: [u32; 2],
    pub origin: DVec3,
}
#[derive(Clone, Debug, Default)]
pub struct FrameBytes {}
impl FrameBytes {
    pub fn size(views: u32) -> u64 {}
    pub fn write(
        &mut self,
        plan: &ShadowPlan,
        settings: &Settings,
        surroundings: &Surroundings,
    ) -> &[u8] {}
}

// key.rs
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct ShaderKey {}
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct OccluderTraits {
    pub covers: bool,
    pub left_to_maps: bool,
}
impl ShaderKey {
    pub fn new(settings: &Settings, support: TextureSupport) -> Self {}
    pub fn with_occluders(
        settings: &Settings,
        support: TextureSupport,
        occluders: Option<OccluderTraits>,
    ) -> Self {}
    pub fn traces(&self) -> bool {}
}

// levels.rs
pub fn lattice_level(texel: [u32; 2], id: u32) -> u32 {}

// lib.rs
pub use binding::{Binding, BindingKind, Dimension, SampleType, SamplerKind, Stages};
pub use contact_camera::{CONTACT_CAMERA_BYTES, ContactDepth, contact_camera};
pub use error::ImportError;
pub use format::{MomentFormat, TexelFormat, TextureSupport};
pub use frame::{FrameBytes, Surroundings};
pub use key::{OccluderTraits, ShaderKey};
pub use levels::lattice_level;
pub use looks::{LookBytes, ReadChoices, seen_size};
pub use slot::Slot;
pub use steps::{MomentSteps, Step, SumSteps, moments, msm_blocker};
pub use texts::{
    FIRST_OCCLUDER_BINDING, caster, caster_bindings, clear, contact, contact_bindings,
    contact_bindings_in, contact_in, join, join_bindings, left, left_bindings, map, peel,
    peel_bindings, receiver, receiver_bindings, receiver_with, refit, refit_bindings,
    resolve, resolve_bindings, restore, restore_bindings, samples, samples_bindings,
    second_caster,
};

// looks.rs
pub fn seen_size(views: u32) -> u64 {}
#[derive(Clone, Debug, Default)]
pub struct LookBytes {}
impl LookBytes {
    pub fn size(views: u32) -> u64 {}
    pub fn write(
        &mut self,
        plan: &ShadowPlan,
        camera: &Camera,
        origin: DVec3,
        before: DVec3,
    ) -> &[u8] {}
}
#[derive(Clone, Debug)]
pub struct ReadChoices();
impl ReadChoices {
    pub fn size(views: u32) -> u64 {}
    pub fn of(bytes: &[u8]) -> Option<Self> {}
    pub fn depths(&self) -> Option<[f32; 2]> {}
    pub fn rectangle(
        &self,
        view: &ShadowView,
        origin: DVec3,
    ) -> Option<ChosenRectangle> {}
}

// slot.rs
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Slot {
    pub group: u32,
    pub first_binding: u32,
}
impl From<u32> for Slot {}

// steps.rs
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Step {
    pub text: String,
    pub entry_point: &'static str,
    pub bindings: [Binding; 4],
}
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct MomentSteps {
    pub format: MomentFormat,
    pub levels: u32,
    pub convert: Step,
    pub across: Step,
    pub down: Step,
    pub halve: Step,
}
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct SumSteps {
    pub format: TexelFormat,
    pub rows: Step,
    pub columns: Step,
}
impl ShaderKey {
    pub fn moment_steps(&self) -> Option<MomentSteps> {}
    pub fn sum_steps(&self) -> Option<SumSteps> {}
}
pub fn moments(moments: &Moments) -> String {}
pub fn msm_blocker(msm: &Msm) -> String {}

// texts.rs
pub fn receiver(key: &ShaderKey, slot: impl Into<Slot>) -> String {}
pub fn receiver_with(
    key: &ShaderKey,
    slot: impl Into<Slot>,
    replaced: &[(&str, &str)],
) -> Result<String, ImportError> {}
pub fn receiver_bindings(key: &ShaderKey) -> Vec<Binding> {}
pub const FIRST_OCCLUDER_BINDING: u32 = 6;
pub fn refit() -> String {}
pub fn refit_bindings() -> Vec<Binding> {}
pub fn caster(slot: impl Into<Slot>) -> String {}
pub fn second_caster(slot: impl Into<Slot>) -> String {}
pub fn caster_bindings() -> Vec<Binding> {}
pub fn clear() -> String {}
pub fn peel() -> String {}
pub fn peel_bindings() -> Vec<Binding> {}
pub fn join(layer: DepthLayer) -> Option<String> {}
pub fn join_bindings() -> Vec<Binding> {}
pub fn restore() -> String {}
pub fn restore_bindings() -> Vec<Binding> {}
pub fn samples() -> String {}
pub fn samples_bindings() -> Vec<Binding> {}
pub fn map() -> String {}
pub fn contact(contact: &Contact, slot: impl Into<Slot>) -> String {}
pub fn contact_in(
    contact: &Contact,
    depth: ContactDepth,
    slot: impl Into<Slot>,
) -> String {}
pub fn contact_bindings() -> Vec<Binding> {}
pub fn contact_bindings_in(depth: ContactDepth) -> Vec<Binding> {}
pub fn resolve(key: &ShaderKey) -> Option<String> {}
pub fn resolve_bindings() -> Vec<Binding> {}
pub fn left() -> String {}
pub fn left_bindings() -> Vec<Binding> {}

