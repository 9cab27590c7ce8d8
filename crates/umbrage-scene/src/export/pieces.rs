//! Each kind of thing in a scene as glTF writes it.

use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::io::Cursor;

use glam::{Vec2, Vec3, Vec4};
use gltf::json::accessor::{ComponentType, Type};
use gltf::json::buffer::Target;
use gltf::json::camera::{Orthographic, Perspective, Type as CameraType};
use gltf::json::extensions::scene::{Node as NodeExtensions, khr_lights_punctual as punctual};
use gltf::json::mesh::{Mode, Primitive, Semantic};
use gltf::json::validation::Checked::Valid;
use gltf::json::{Camera as JsonCamera, Image, Index, Mesh as JsonMesh};
use image::codecs::png::{CompressionType, FilterType, PngEncoder};
use image::{ExtendedColorType, ImageEncoder as _};

use super::Vertices;
use super::bending;
use super::bytes::Document;
use crate::error::Fault;
use crate::import::MAX_SIDE_PX;
use crate::{Aabb, Camera, Influences, Lens, Light, LightKind, Mesh, Part, Texture};

const LIGHTS: &str = "KHR_lights_punctual";

/// Adds a picture as PNG, which loses nothing.
pub(super) fn add_texture(
    document: &mut Document,
    texture: &Texture,
) -> Result<Index<gltf::json::Texture>, Fault> {
    let Texture { name, width, height, rgba } = texture;
    let sides = 1..=MAX_SIDE_PX;
    let fits = sides.contains(width) && sides.contains(height);
    if !fits || rgba.len() as u64 != 4 * u64::from(*width) * u64::from(*height) {
        let got = format!("texture {name:?} has {width} by {height} pixels in {} bytes", rgba.len());
        return Err(Fault(format!("{got}, need 4 bytes a pixel and 1 to {MAX_SIDE_PX} pixels a side")));
    }
    let mut png = Cursor::new(Vec::new());
    PngEncoder::new_with_quality(&mut png, CompressionType::Fast, FilterType::Adaptive)
        .write_image(rgba, *width, *height, ExtendedColorType::Rgba8)
        .map_err(|why| Fault(format!("texture {name:?} does not pack, {why}")))?;
    let view = document.view(png.into_inner(), None);
    let source = document.root.push(Image {
        buffer_view: Some(view),
        mime_type: Some(gltf::json::image::MimeType("image/png".to_owned())),
        name: Some(name.clone()),
        uri: None,
        extensions: None,
        extras: None,
    });
    Ok(document.root.push(gltf::json::Texture {
        name: None,
        sampler: None,
        source,
        extensions: None,
        extras: None,
    }))
}

/// Adds a mesh: one primitive for each part. They share an accessor for each attribute, or have vertices of their own where
/// those are wanted apart and nothing bends them.
pub(super) fn add_mesh(
    document: &mut Document,
    mesh: &Mesh,
    vertices: Vertices,
) -> Result<Index<JsonMesh>, Fault> {
    let Mesh { name, positions, normals, uvs, colours, influences, targets, indices, parts, bounds: _ } =
        mesh;
    let fault = |why: String| Fault(format!("{why}, in mesh {name:?}"));
    let count = positions.len();
    if normals.len() != count || uvs.len() != count {
        let (normals, uvs) = (normals.len(), uvs.len());
        return Err(fault(format!("{count} positions, {normals} normals and {uvs} texture coordinates")));
    }
    if !colours.is_empty() && colours.len() != count {
        return Err(fault(format!("{count} positions and {} colours", colours.len())));
    }
    let finite = positions.iter().chain(normals).all(|v| v.is_finite())
        && uvs.iter().all(|uv| uv.is_finite())
        && colours.iter().all(|colour| colour.is_finite());
    if !finite {
        return Err(fault("vertices that are not finite".to_owned()));
    }
    if let Some(index) = indices.iter().find(|&&i| i as usize >= count) {
        return Err(fault(format!("index {index} of {count} vertices")));
    }
    for Part { indices: range, material, bounds: _ } in parts {
        let within = range.start < range.end && range.end as usize <= indices.len();
        if !within || *material >= document.root.materials.len() {
            let (materials, count) = (document.root.materials.len(), indices.len());
            let got =
                format!("a part of indices {range:?} of {count} with material {material} of {materials}");
            return Err(fault(got));
        }
    }
    let bent = |Fault(why): Fault| Fault(format!("{why}, in mesh {name:?}"));
    let primitives = match vertices {
        Vertices::Apart if influences.is_empty() && targets.is_empty() => {
            let mut primitives = Vec::with_capacity(parts.len());
            for part in parts {
                primitives.extend(add_parts(document, &apart(mesh, part)).map_err(bent)?);
            }
            primitives
        }
        Vertices::Apart | Vertices::Shared => add_parts(document, mesh).map_err(bent)?,
    };
    Ok(document.root.push(JsonMesh {
        name: Some(name.clone()),
        primitives,
        weights: None,
        extensions: None,
        extras: None,
    }))
}

/// A mesh of one part alone, with the vertices that it uses, in their order.
fn apart(mesh: &Mesh, part: &Part) -> Mesh {
    let indices = &mesh.indices[part.indices.start as usize..part.indices.end as usize];
    let used: Vec<u32> = indices.iter().copied().collect::<BTreeSet<_>>().into_iter().collect();
    let place: HashMap<u32, u32> = used.iter().copied().zip(0..).collect();
    let [positions, normals] = [&mesh.positions, &mesh.normals].map(|all| of(all, &used));
    Mesh {
        positions,
        normals,
        uvs: of(&mesh.uvs, &used),
        colours: if mesh.colours.is_empty() { Vec::new() } else { of(&mesh.colours, &used) },
        indices: indices.iter().map(|index| place[index]).collect(),
        parts: vec![Part { indices: 0..part.indices.end - part.indices.start, ..part.clone() }],
        name: mesh.name.clone(),
        influences: Influences::default(),
        targets: Vec::new(),
        bounds: part.bounds,
    }
}

fn of<T: Copy>(all: &[T], used: &[u32]) -> Vec<T> {
    used.iter().map(|index| all[*index as usize]).collect()
}

/// Adds the parts of a mesh, which share its vertices.
fn add_parts(document: &mut Document, mesh: &Mesh) -> Result<Vec<Primitive>, Fault> {
    let Mesh { positions, normals, uvs, colours, indices, parts, .. } = mesh;
    let extent = Aabb::of_points(positions.iter().copied());
    let position = document.floats(Type::Vec3, positions.iter().map(Vec3::to_array));
    document.set_extent(position, extent.min.to_array(), extent.max.to_array());
    let normal = document.floats(Type::Vec3, normals.iter().map(Vec3::to_array));
    let uv = document.floats(Type::Vec2, uvs.iter().map(Vec2::to_array));
    let mut attributes = BTreeMap::from([
        (Valid(Semantic::Positions), position),
        (Valid(Semantic::Normals), normal),
        (Valid(Semantic::TexCoords(0)), uv),
    ]);
    if !colours.is_empty() {
        let colours = document.floats(Type::Vec4, colours.iter().map(Vec4::to_array));
        attributes.insert(Valid(Semantic::Colors(0)), colours);
    }
    attributes.extend(bending::influences(document, mesh)?);
    let targets = bending::targets(document, mesh)?;
    let view = document.view(indices.iter().flat_map(|i| i.to_le_bytes()), Some(Target::ElementArrayBuffer));
    let mut add = |Part { indices: range, material, bounds: _ }: &Part| {
        let (start, count) = (4 * range.start as usize, range.len());
        Primitive {
            attributes: attributes.clone(),
            indices: Some(document.accessor(view, start, count, ComponentType::U32, Type::Scalar)),
            material: Some(Index::new(*material as u32)),
            mode: Valid(Mode::Triangles),
            targets: targets.clone(),
            extensions: None,
            extras: None,
        }
    };
    Ok(parts.iter().map(&mut add).collect())
}

/// Adds a camera; its node gives it a place.
pub(super) fn add_camera(document: &mut Document, camera: &Camera) -> Result<Index<JsonCamera>, Fault> {
    let Camera { name, world_from_camera: _, lens, near, far } = camera;
    let size = match lens {
        Lens::Perspective { fov_y } => fov_y,
        Lens::Orthographic { half_height } => half_height,
    };
    if ![size, near, far].iter().all(|number| number.is_finite()) {
        return Err(Fault(format!(
            "camera {name:?} sees {size} from {near} m to {far} m, need finite numbers"
        )));
    }
    let perspective = |yfov| Perspective {
        aspect_ratio: None,
        yfov,
        zfar: Some(*far),
        znear: *near,
        extensions: None,
        extras: None,
    };
    let orthographic = |ymag| Orthographic {
        // The picture's shape is not the camera's to say.
        xmag: ymag,
        ymag,
        zfar: *far,
        znear: *near,
        extensions: None,
        extras: None,
    };
    let (perspective, orthographic, kind) = match *lens {
        Lens::Perspective { fov_y } => (Some(perspective(fov_y)), None, CameraType::Perspective),
        Lens::Orthographic { half_height } => {
            (None, Some(orthographic(half_height)), CameraType::Orthographic)
        }
    };
    Ok(document.root.push(JsonCamera {
        name: Some(name.clone()),
        orthographic,
        perspective,
        type_: Valid(kind),
        extensions: None,
        extras: None,
    }))
}

/// Adds a light; the returned extension makes it hang on a node.
pub(super) fn add_light(document: &mut Document, light: &Light) -> Result<NodeExtensions, Fault> {
    let Light { name, world_from_light: _, colour, intensity, kind, near: _, motion: _ } = light;
    let (type_, range, spot) = match *kind {
        LightKind::Directional => (punctual::Type::Directional, f32::INFINITY, None),
        LightKind::Point { range } => (punctual::Type::Point, range, None),
        LightKind::Spot { inner, outer, range } => (
            punctual::Type::Spot,
            range,
            Some(punctual::Spot { inner_cone_angle: inner, outer_cone_angle: outer }),
        ),
    };
    let angles =
        spot.as_ref().is_none_or(|s| s.inner_cone_angle.is_finite() && s.outer_cone_angle.is_finite());
    if !(colour.is_finite() && intensity.is_finite() && angles && !range.is_nan()) {
        return Err(Fault(format!("light {name:?} has numbers that are not finite, {kind:?}")));
    }
    document.declare(LIGHTS);
    let index = document.root.push(punctual::Light {
        color: colour.to_array(),
        intensity: *intensity,
        name: Some(name.clone()),
        range: range.is_finite().then_some(range),
        spot,
        type_: Valid(type_),
        extensions: None,
        extras: None,
    });
    Ok(NodeExtensions {
        khr_lights_punctual: Some(punctual::KhrLightsPunctual { light: index }),
        ..NodeExtensions::default()
    })
}
