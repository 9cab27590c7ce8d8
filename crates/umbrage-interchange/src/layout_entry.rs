//! A binding as an entry of WebGPU's `createBindGroupLayout`.

use serde::Serialize;
use umbrage_wgsl::{Binding, BindingKind, Dimension, Stages};

use crate::binding::{sample_type, sampler_type, view_dimension};

/// A `GPUBindGroupLayoutEntry`, with the name of the variable in the text, which WebGPU ignores.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct LayoutEntry {
    binding: u32,
    name: &'static str,
    visibility: u32,
    #[serde(flatten)]
    resource: Resource,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
enum Resource {
    #[serde(rename_all = "camelCase")]
    Buffer {
        r#type: &'static str,
        has_dynamic_offset: bool,
    },
    #[serde(rename_all = "camelCase")]
    Texture {
        sample_type: &'static str,
        view_dimension: &'static str,
        multisampled: bool,
    },
    StorageTexture {
        access: &'static str,
        format: &'static str,
    },
    Sampler {
        r#type: &'static str,
    },
}

/// Bits of `GPUShaderStage`.
mod stage {
    pub const VERTEX: u32 = 1;
    pub const FRAGMENT: u32 = 2;
    pub const COMPUTE: u32 = 4;
}

impl LayoutEntry {
    /// Returns a binding of a text whose first binding has the number `first_binding`.
    pub fn new(of: &Binding, first_binding: u32) -> Self {
        let Binding { binding, name, kind, stages } = *of;
        Self {
            binding: first_binding + binding,
            name,
            visibility: visibility(stages),
            resource: resource(kind),
        }
    }
}

fn resource(kind: BindingKind) -> Resource {
    let buffer = |r#type, has_dynamic_offset| Resource::Buffer { r#type, has_dynamic_offset };
    match kind {
        BindingKind::Storage => buffer("read-only-storage", false),
        BindingKind::WrittenStorage => buffer("storage", false),
        BindingKind::Uniform { has_dynamic_offset } => buffer("uniform", has_dynamic_offset),
        BindingKind::Texture { sample, dimension } => Resource::Texture {
            sample_type: sample_type(sample),
            view_dimension: view_dimension(dimension),
            multisampled: dimension == Dimension::D2Multisampled,
        },
        BindingKind::StorageTexture { format } => {
            Resource::StorageTexture { access: "write-only", format: format.wgsl() }
        }
        BindingKind::Sampler(kind) => Resource::Sampler { r#type: sampler_type(kind) },
    }
}

fn visibility(stages: Stages) -> u32 {
    match stages {
        Stages::Vertex => stage::VERTEX,
        Stages::Fragment => stage::FRAGMENT,
        Stages::VertexAndFragment => stage::VERTEX | stage::FRAGMENT,
        Stages::Compute => stage::COMPUTE,
        Stages::FragmentAndCompute => stage::FRAGMENT | stage::COMPUTE,
    }
}

#[cfg(test)]
mod tests {
    use umbrage_core::Settings;

    use super::*;
    use crate::{Stage, Stages as Texts, Textures};

    #[test]
    fn an_entry_is_what_web_gpu_wants_of_a_layout() {
        let settings = Settings::default();
        let casters =
            Texts::new(&settings, Textures::Webgpu).bindings(Stage::Caster).expect("casters are drawn");
        let entries: Vec<_> = casters.iter().map(|binding| LayoutEntry::new(binding, 3)).collect();
        let wanted = serde_json::json!([
            { "binding": 3, "name": "umbrage_frame", "visibility": 3,
              "buffer": { "type": "read-only-storage", "hasDynamicOffset": false } },
            { "binding": 4, "name": "umbrage_current_view", "visibility": 3,
              "buffer": { "type": "uniform", "hasDynamicOffset": true } },
        ]);
        assert_eq!(serde_json::to_value(entries).expect("JSON"), wanted);
    }
}
