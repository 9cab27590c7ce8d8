//! Primitives to meshes. Primitives that share their vertices in the file share them in the mesh.
//!
//! Source: glTF 2.0, section 3.7.2, *Meshes*. Where a primitive has no normals they are flat, so it gets three vertices
//! a triangle of its own.

use std::collections::HashMap;
use std::collections::hash_map::Entry;

use glam::{Vec2, Vec3, Vec4};
use gltf::json::accessor::Type;
use gltf::json::mesh::{Mode, Primitive, Semantic};
use gltf::json::validation::Checked;
use gltf::json::{Accessor, Index};

use super::accessors::Data;
use super::materials::{Mapping, Surfaces};
use crate::Mesh;
use crate::error::Fault;
use crate::import::budget::Budget;
use crate::import::normals;
use crate::import::warnings::Warnings;

/// Reads all meshes of a file, in its order. A mesh of points and lines alone has no triangles.
pub(super) fn read(
    data: &Data<'_>,
    surfaces: &mut Surfaces,
    budget: &mut Budget,
    warnings: &mut Warnings,
) -> Result<Vec<Mesh>, Fault> {
    let mut meshes = Vec::with_capacity(data.root.meshes.len());
    for (i, json) in data.root.meshes.iter().enumerate() {
        let name = json.name.clone().unwrap_or_else(|| format!("mesh {i}"));
        let mut builder = Builder { mesh: Mesh::empty(&name), known: HashMap::new(), data, budget, warnings };
        for primitive in &json.primitives {
            builder
                .add(primitive, surfaces)
                .map_err(|Fault(fault)| Fault(format!("{fault}, in mesh {name:?}")))?;
        }
        let mut mesh = builder.mesh;
        normals::repair(&mesh.positions, &mesh.indices, &mut mesh.normals);
        meshes.push(mesh);
    }
    Ok(meshes)
}

/// A mesh that grows by primitives.
struct Builder<'a> {
    mesh: Mesh,
    /// Where in the mesh the vertices of these accessors begin, and how many they are.
    known: HashMap<Sources, (usize, usize)>,
    data: &'a Data<'a>,
    budget: &'a mut Budget,
    warnings: &'a mut Warnings,
}

/// Where the looks of vertices come from.
#[derive(Clone, Copy, Debug)]
struct Looks {
    uvs: Option<Index<Accessor>>,
    mapping: Mapping,
    colours: Option<Index<Accessor>>,
}

/// What vertices are made from; equal sources make equal vertices.
#[derive(Clone, PartialEq, Eq, Hash)]
struct Sources {
    positions: usize,
    normals: usize,
    uvs: Option<usize>,
    colours: Option<usize>,
    picture_from_uv: Option<[u32; 6]>,
}

impl Builder<'_> {
    fn add(&mut self, primitive: &Primitive, surfaces: &mut Surfaces) -> Result<(), Fault> {
        let get = |semantic| primitive.attributes.get(&Checked::Valid(semantic)).copied();
        let Checked::Valid(mode) = primitive.mode else {
            return Err(Fault("a primitive of no mode".to_owned()));
        };
        if matches!(mode, Mode::Points | Mode::Lines | Mode::LineLoop | Mode::LineStrip) {
            self.warnings.note("points and lines are left out", &self.mesh.name);
            return Ok(());
        }
        let Some(positions) = get(Semantic::Positions) else {
            self.warnings.note("primitives without positions are left out", &self.mesh.name);
            return Ok(());
        };
        if primitive.targets.is_some() {
            self.warnings.note("morph targets are ignored", &self.mesh.name);
        }
        let (material, mapping) = surfaces.of(primitive.material);
        let looks =
            Looks { uvs: get(Semantic::TexCoords(mapping.set)), mapping, colours: get(Semantic::Colors(0)) };
        let (base, triangles) = match get(Semantic::Normals) {
            Some(normals) => {
                let (base, count) = self.shared(positions, normals, looks)?;
                (base, self.triangles(primitive, mode, count)?)
            }
            None => self.flat(primitive, mode, positions, looks)?,
        };
        let base = base as u32;
        self.mesh.add_triangles(triangles.iter().map(|t| t.map(|i| base + i)), material);
        Ok(())
    }

    /// The place of the vertices made of these accessors, and their count; reads them where they are new.
    fn shared(
        &mut self,
        positions: Index<Accessor>,
        normals: Index<Accessor>,
        Looks { uvs, mapping, colours }: Looks,
    ) -> Result<(usize, usize), Fault> {
        let bits = |transform: glam::Affine2| transform.to_cols_array().map(f32::to_bits);
        let sources = Sources {
            positions: positions.value(),
            normals: normals.value(),
            uvs: uvs.map(|uvs| uvs.value()),
            colours: colours.map(|colours| colours.value()),
            picture_from_uv: mapping.picture_from_uv.map(bits),
        };
        if let Entry::Occupied(known) = self.known.entry(sources.clone()) {
            return Ok(*known.get());
        }
        let base = self.mesh.positions.len();
        let positions = self.positions(positions)?;
        let count = positions.len();
        let normals = self.data.vectors::<3>(normals)?;
        if normals.len() != count {
            return Err(Fault(format!("{count} positions and {} normals", normals.len())));
        }
        self.mesh.positions.extend(positions);
        self.mesh.normals.extend(normals.into_iter().map(Vec3::from));
        let uvs = self.uvs(uvs, mapping, count)?;
        self.mesh.uvs.extend(uvs);
        let colours = self.colours(colours, count)?;
        self.mesh.add_colours(&colours);
        self.known.insert(sources, (base, count));
        Ok((base, count))
    }

    /// Three vertices for each triangle, without normals yet; the place of the first, and the triangles.
    fn flat(
        &mut self,
        primitive: &Primitive,
        mode: Mode,
        positions: Index<Accessor>,
        Looks { uvs, mapping, colours }: Looks,
    ) -> Result<(usize, Vec<[u32; 3]>), Fault> {
        let base = self.mesh.positions.len();
        let positions = self.positions(positions)?;
        let uvs = self.uvs(uvs, mapping, positions.len())?;
        let colours = self.colours(colours, positions.len())?;
        let triangles = self.triangles(primitive, mode, positions.len())?;
        let corners = triangles.as_flattened();
        self.budget.vertices(corners.len())?;
        self.mesh.positions.extend(corners.iter().map(|&i| positions[i as usize]));
        self.mesh.uvs.extend(corners.iter().map(|&i| uvs[i as usize]));
        self.mesh.normals.resize(self.mesh.positions.len(), Vec3::ZERO);
        let colour = |&i: &u32| colours.get(i as usize).copied();
        self.mesh.add_colours(&corners.iter().filter_map(colour).collect::<Vec<_>>());
        Ok((base, (0..triangles.len() as u32).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect()))
    }

    /// The corners of a primitive's triangles, each below `count`.
    fn triangles(&mut self, primitive: &Primitive, mode: Mode, count: usize) -> Result<Vec<[u32; 3]>, Fault> {
        let length = primitive.indices.map_or(count, |indices| self.data.count(indices));
        self.budget.corners(if mode == Mode::Triangles { length } else { length.saturating_mul(3) })?;
        let corners = match primitive.indices {
            Some(indices) => self.data.indices(indices)?,
            None => (0..count as u32).collect(),
        };
        if let Some(index) = corners.iter().find(|&&i| i as usize >= count) {
            return Err(Fault(format!("index {index} of a primitive with {count} vertices")));
        }
        match mode {
            Mode::TriangleStrip => {
                let turn = |(i, w): (usize, &[u32])| {
                    if i % 2 == 0 { [w[0], w[1], w[2]] } else { [w[0], w[2], w[1]] }
                };
                Ok(corners.windows(3).enumerate().map(turn).collect())
            }
            Mode::TriangleFan => {
                let hub = corners.first().copied().unwrap_or_default();
                Ok(corners.windows(2).skip(1).map(|w| [w[0], w[1], hub]).collect())
            }
            Mode::Points | Mode::Lines | Mode::LineLoop | Mode::LineStrip | Mode::Triangles => {
                match corners.as_chunks() {
                    (triangles, []) => Ok(triangles.to_vec()),
                    _ => Err(Fault(format!("{} corners of triangles, need a multiple of 3", corners.len()))),
                }
            }
        }
    }

    fn positions(&mut self, index: Index<Accessor>) -> Result<Vec<Vec3>, Fault> {
        self.budget.vertices(self.data.count(index))?;
        let positions: Vec<Vec3> = self.data.vectors::<3>(index)?.into_iter().map(Vec3::from).collect();
        match positions.iter().find(|p| !p.is_finite()) {
            Some(p) => Err(Fault(format!("a vertex at {p}, need finite coordinates"))),
            None => Ok(positions),
        }
    }

    /// Texture coordinates for `count` vertices; zeros where there are none.
    fn uvs(
        &mut self,
        index: Option<Index<Accessor>>,
        mapping: Mapping,
        count: usize,
    ) -> Result<Vec<Vec2>, Fault> {
        let Some(index) = index else {
            return Ok(vec![Vec2::ZERO; count]);
        };
        let mut uvs: Vec<Vec2> = self.data.vectors::<2>(index)?.into_iter().map(Vec2::from).collect();
        if uvs.len() != count {
            return Err(Fault(format!("{count} positions and {} texture coordinates", uvs.len())));
        }
        if let Some(picture_from_uv) = mapping.picture_from_uv {
            for uv in &mut uvs {
                *uv = picture_from_uv.transform_point2(*uv);
            }
        }
        for uv in uvs.iter_mut().filter(|uv| !uv.is_finite()) {
            self.warnings.note("texture coordinates that are not finite become 0", &self.mesh.name);
            *uv = Vec2::ZERO;
        }
        Ok(uvs)
    }

    /// Colours for `count` vertices, RGB or RGBA; none where the file has none.
    fn colours(&mut self, index: Option<Index<Accessor>>, count: usize) -> Result<Vec<Vec4>, Fault> {
        let Some(index) = index else { return Ok(Vec::new()) };
        let is_rgb = matches!(self.data.root.accessors[index.value()].type_, Checked::Valid(Type::Vec3));
        let mut colours: Vec<Vec4> = if is_rgb {
            self.data.vectors::<3>(index)?.into_iter().map(|rgb| Vec3::from(rgb).extend(1.0)).collect()
        } else {
            self.data.vectors::<4>(index)?.into_iter().map(Vec4::from).collect()
        };
        if colours.len() != count {
            return Err(Fault(format!("{count} positions and {} colours", colours.len())));
        }
        for colour in &mut colours {
            if !colour.is_finite() {
                self.warnings.note("vertex colours that are not finite become white", &self.mesh.name);
                *colour = Vec4::ONE;
            }
            *colour = colour.clamp(Vec4::ZERO, Vec4::ONE);
        }
        Ok(colours)
    }
}
