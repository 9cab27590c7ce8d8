//! What stands in a list where an object cannot be read, so that the indices of the others stay what they are. It is
//! empty, and nobody can draw it.

use gltf::json::extensions::scene::khr_lights_punctual::Light;
use gltf::json::texture::Sampler;
use gltf::json::validation::{Checked, USize64};
use gltf::json::{
    Accessor, Buffer, Camera, Image, Index, Material, Mesh, Node, Scene, Skin, Texture, buffer::View,
};

/// An index that leads nowhere.
pub(super) const NOWHERE: u32 = u32::MAX;

pub(super) trait StandIn {
    fn stand_in() -> Self;
}

impl StandIn for Accessor {
    fn stand_in() -> Self {
        Self {
            buffer_view: None,
            byte_offset: None,
            count: USize64(0),
            component_type: Checked::Invalid,
            extensions: None,
            extras: None,
            type_: Checked::Invalid,
            min: None,
            max: None,
            name: None,
            normalized: false,
            sparse: None,
        }
    }
}

impl StandIn for Buffer {
    fn stand_in() -> Self {
        Self { byte_length: USize64(0), name: None, uri: None, extensions: None, extras: None }
    }
}

impl StandIn for View {
    fn stand_in() -> Self {
        Self {
            buffer: Index::new(NOWHERE),
            byte_length: USize64(0),
            byte_offset: None,
            byte_stride: None,
            name: None,
            target: None,
            extensions: None,
            extras: None,
        }
    }
}

impl StandIn for Camera {
    fn stand_in() -> Self {
        Self {
            name: None,
            orthographic: None,
            perspective: None,
            type_: Checked::Invalid,
            extensions: None,
            extras: None,
        }
    }
}

impl StandIn for Image {
    fn stand_in() -> Self {
        Self { buffer_view: None, mime_type: None, name: None, uri: None, extensions: None, extras: None }
    }
}

impl StandIn for Light {
    fn stand_in() -> Self {
        Self {
            color: [1.0; 3],
            extensions: None,
            extras: None,
            intensity: 1.0,
            name: None,
            range: None,
            spot: None,
            type_: Checked::Invalid,
        }
    }
}

impl StandIn for Mesh {
    fn stand_in() -> Self {
        Self { extensions: None, extras: None, name: None, primitives: Vec::new(), weights: None }
    }
}

impl StandIn for Scene {
    fn stand_in() -> Self {
        Self { extensions: None, extras: None, name: None, nodes: Vec::new() }
    }
}

impl StandIn for Skin {
    fn stand_in() -> Self {
        Self {
            name: None,
            joints: Vec::new(),
            skeleton: None,
            inverse_bind_matrices: None,
            extensions: None,
            extras: None,
        }
    }
}

impl StandIn for Texture {
    fn stand_in() -> Self {
        Self { name: None, sampler: None, source: Index::new(NOWHERE), extensions: None, extras: None }
    }
}

impl StandIn for Material {
    fn stand_in() -> Self {
        Self::default()
    }
}

impl StandIn for Node {
    fn stand_in() -> Self {
        Self::default()
    }
}

impl StandIn for Sampler {
    fn stand_in() -> Self {
        Self::default()
    }
}
