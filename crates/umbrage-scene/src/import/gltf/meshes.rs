//! Primitives to meshes. Primitives that share their vertices in the file share them in the mesh.
//!
//! Source: glTF 2.0, section 3.7.2, *Meshes*. Where a primitive has no normals they are flat, so it gets three vertices
//! a triangle of its own.

use std::collections::{HashMap, HashSet};
use std::rc::Rc;

use glam::{Vec2, Vec3, Vec4};
use gltf::json::accessor::Type;
use gltf::json::mesh::{Mode, Primitive, Semantic};
use gltf::json::validation::Checked;
use gltf::json::{Accessor, Index};

use super::accessors::Data;
use super::bending::{Bender, Bending};
use super::bent::Bent;
use super::influences;
use super::materials::{Mapping, Surfaces};
use super::morphs;
use crate::Mesh;
use crate::error::Fault;
use crate::import::budget::Budget;
use crate::import::normals;
use crate::import::settle::FARTHEST;
use crate::import::warnings::Warnings;

/// Reads all meshes of a file, in its order. What of a mesh cannot be read is left out with a warning: a mesh of points
/// and lines alone has no triangles. Only more than the budget allows stops here.
pub(super) fn read(
    data: &Data<'_>,
    bent: &[Bent],
    surfaces: &mut Surfaces,
    budget: &mut Budget,
    warnings: &mut Warnings,
) -> Result<Vec<Mesh>, Fault> {
    let mut meshes = Vec::with_capacity(data.root.meshes.len());
    for (i, json) in data.root.meshes.iter().enumerate() {
        data.progress.step("meshes", i, data.root.meshes.len());
        let name = json.name.clone().unwrap_or_else(|| format!("mesh {i}"));
        let bender = Bender::new(json, bent.get(i).copied().unwrap_or_default());
        let (mesh, known) = (Mesh::empty(&name), HashMap::new());
        let mut builder = Builder { mesh, bender, known, data, budget, warnings };
        for primitive in &json.primitives {
            if let Err(Fault(fault)) = builder.add(primitive, surfaces) {
                let lost = format!("{fault}, in mesh {name:?}");
                if builder.budget.is_overdrawn() {
                    return Err(Fault(lost));
                }
                builder.warnings.note("primitives that cannot be read are left out", &lost);
            }
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
    bender: Bender,
    /// What is in the mesh of these accessors already.
    known: HashMap<Sources, Known>,
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
    bending: Vec<Option<usize>>,
}

/// Vertices in a mesh: where they begin, how many they are, and which of them have no place.
#[derive(Clone)]
struct Known {
    base: usize,
    extent: Rc<Extent>,
}

/// How many vertices a primitive has, and which of them are at infinity, or not a number.
struct Extent {
    count: usize,
    lost: HashSet<u32>,
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
        let (material, mapping) = surfaces.of(primitive.material);
        let looks =
            Looks { uvs: get(Semantic::TexCoords(mapping.set)), mapping, colours: get(Semantic::Colors(0)) };
        let known =
            get(Semantic::Normals).map_or(Ok(None), |n| self.shared(primitive, positions, n, looks))?;
        let (base, triangles) = match known {
            Some(Known { base, extent }) => (base, self.triangles(primitive, mode, &extent)?),
            None => self.flat(primitive, mode, positions, looks)?,
        };
        let base = base as u32;
        self.mesh.add_triangles(triangles.iter().map(|t| t.map(|i| base + i)), material);
        Ok(())
    }

    /// The vertices made of these accessors; reads them where they are new. `None` where the normals cannot be read.
    fn shared(
        &mut self,
        primitive: &Primitive,
        positions: Index<Accessor>,
        normals: Index<Accessor>,
        Looks { uvs, mapping, colours }: Looks,
    ) -> Result<Option<Known>, Fault> {
        let bits = |transform: glam::Affine2| transform.to_cols_array().map(f32::to_bits);
        let sources = Sources {
            positions: positions.value(),
            normals: normals.value(),
            uvs: uvs.map(|uvs| uvs.value()),
            colours: colours.map(|colours| colours.value()),
            picture_from_uv: mapping.picture_from_uv.map(bits),
            bending: self.bender.sources(primitive),
        };
        if let Some(known) = self.known.get(&sources) {
            return Ok(Some(known.clone()));
        }
        let count = self.data.count(positions)?;
        let Some(normals) = self.normals(normals, count) else {
            return Ok(None);
        };
        let (positions, extent) = self.positions(positions)?;
        let uvs = self.uvs(uvs, mapping, count);
        let colours = self.colours(colours, count);
        let Bending { influences, targets } = self.bending(primitive, (count, count));
        let known = Known { base: self.mesh.positions.len(), extent: Rc::new(extent) };
        self.mesh.positions.extend(positions);
        self.mesh.normals.extend(normals);
        self.mesh.uvs.extend(uvs);
        self.mesh.add_colours(&colours);
        self.mesh.add_influences(&influences, count);
        self.mesh.add_targets(&morphs::shared(targets), count);
        self.known.insert(sources, known.clone());
        Ok(Some(known))
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
        let (positions, extent) = self.positions(positions)?;
        let triangles = self.triangles(primitive, mode, &extent)?;
        let corners = triangles.as_flattened();
        self.budget.vertices(corners.len())?;
        let uvs = self.uvs(uvs, mapping, positions.len());
        let colours = self.colours(colours, positions.len());
        let Bending { influences, targets } = self.bending(primitive, (positions.len(), corners.len()));
        self.mesh.positions.extend(corners.iter().map(|&i| positions[i as usize]));
        self.mesh.uvs.extend(corners.iter().map(|&i| uvs[i as usize]));
        self.mesh.normals.resize(self.mesh.positions.len(), Vec3::ZERO);
        let colour = |&i: &u32| colours.get(i as usize).copied();
        self.mesh.add_colours(&corners.iter().filter_map(colour).collect::<Vec<_>>());
        self.mesh.add_influences(&influences::at_corners(&influences, corners), corners.len());
        self.mesh.add_targets(&morphs::flat(&targets, &positions, corners), corners.len());
        Ok((base, (0..triangles.len() as u32).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect()))
    }

    fn bending(&mut self, primitive: &Primitive, counts: (usize, usize)) -> Bending {
        let Self { mesh, bender, data, budget, warnings, .. } = self;
        bender.read(mesh, data, primitive, counts, budget, warnings)
    }

    /// The corners of a primitive's triangles, each a position that is finite. The others are left out, and counted.
    fn triangles(
        &mut self,
        primitive: &Primitive,
        mode: Mode,
        extent: &Extent,
    ) -> Result<Vec<[u32; 3]>, Fault> {
        let count = extent.count;
        let length = primitive.indices.map_or(Ok(count), |indices| self.data.count(indices))?;
        self.budget.corners(if mode == Mode::Triangles { length } else { length.saturating_mul(3) })?;
        let corners = match primitive.indices {
            Some(indices) => self.data.indices(indices)?,
            None => (0..count as u32).collect(),
        };
        let mut triangles = self.assemble(&corners, mode);
        let name = &self.mesh.name;
        let all = triangles.len();
        let mut note = |what: &'static str, lost: usize, why: String| {
            if lost > 0 {
                self.warnings.note(what, &format!("{lost} of {all} of mesh {name:?}, {why}"));
            }
        };
        let outside = triangles.iter().flatten().copied().find(|&i| i as usize >= count);
        triangles.retain(|t| t.iter().all(|&i| (i as usize) < count));
        let why = || format!("index {} of a primitive with {count} vertices", outside.unwrap_or_default());
        note("triangles whose indices lead to no vertex are left out", all - triangles.len(), why());
        let inside = triangles.len();
        triangles.retain(|t| t.iter().all(|&i| !extent.lost.contains(&i)));
        let why = format!("corners need finite coordinates, at most {FARTHEST:e} m");
        note("triangles that reach too far are left out", inside - triangles.len(), why);
        Ok(triangles)
    }

    /// Triangles of a list, a strip or a fan. What is left of a list makes no triangle.
    fn assemble(&mut self, corners: &[u32], mode: Mode) -> Vec<[u32; 3]> {
        match mode {
            Mode::TriangleStrip => {
                let turn = |(i, w): (usize, &[u32])| {
                    if i % 2 == 0 { [w[0], w[1], w[2]] } else { [w[0], w[2], w[1]] }
                };
                corners.windows(3).enumerate().map(turn).collect()
            }
            Mode::TriangleFan => {
                let hub = corners.first().copied().unwrap_or_default();
                corners.windows(2).skip(1).map(|w| [w[0], w[1], hub]).collect()
            }
            Mode::Points | Mode::Lines | Mode::LineLoop | Mode::LineStrip | Mode::Triangles => {
                let (triangles, rest) = corners.as_chunks();
                if !rest.is_empty() {
                    let subject = format!("{} of {} of mesh {:?}", rest.len(), corners.len(), self.mesh.name);
                    self.warnings.note("corners that make no whole triangle are left out", &subject);
                }
                triangles.to_vec()
            }
        }
    }

    /// The positions, zeros where they are not finite or too far, and which those are.
    fn positions(&mut self, index: Index<Accessor>) -> Result<(Vec<Vec3>, Extent), Fault> {
        self.budget.vertices(self.data.count(index)?)?;
        let mut positions: Vec<Vec3> = self.data.vectors::<3>(index)?.into_iter().map(Vec3::from).collect();
        let mut lost = HashSet::new();
        let is_far = |p: &Vec3| !p.is_finite() || p.abs().max_element() > FARTHEST as f32;
        for (p, i) in positions.iter_mut().zip(0..).filter(|(p, _)| is_far(p)) {
            *p = Vec3::ZERO;
            lost.insert(i);
        }
        let count = positions.len();
        Ok((positions, Extent { count, lost }))
    }

    /// Normals for `count` vertices; `None` where they cannot be read.
    fn normals(&mut self, index: Index<Accessor>, count: usize) -> Option<Vec<Vec3>> {
        let read = self.data.vectors::<3>(index).and_then(|normals| {
            if normals.len() == count {
                Ok(normals.into_iter().map(Vec3::from).collect())
            } else {
                Err(Fault(format!("{count} positions and {} normals", normals.len())))
            }
        });
        match read {
            Ok(normals) => Some(normals),
            Err(Fault(why)) => {
                let subject = format!("{why}, in mesh {:?}", self.mesh.name);
                self.warnings.note("normals that cannot be read are computed, flat", &subject);
                None
            }
        }
    }

    /// Texture coordinates for `count` vertices; zeros where there are none.
    fn uvs(&mut self, index: Option<Index<Accessor>>, mapping: Mapping, count: usize) -> Vec<Vec2> {
        let Some(index) = index else {
            return vec![Vec2::ZERO; count];
        };
        let read = self.data.vectors::<2>(index).and_then(|uvs| {
            if uvs.len() == count {
                Ok(uvs)
            } else {
                Err(Fault(format!("{count} positions and {} texture coordinates", uvs.len())))
            }
        });
        let mut uvs: Vec<Vec2> = match read {
            Ok(uvs) => uvs.into_iter().map(Vec2::from).collect(),
            Err(Fault(why)) => {
                let subject = format!("{why}, in mesh {:?}", self.mesh.name);
                self.warnings.note("texture coordinates that cannot be read become 0", &subject);
                return vec![Vec2::ZERO; count];
            }
        };
        if let Some(picture_from_uv) = mapping.picture_from_uv {
            for uv in &mut uvs {
                *uv = picture_from_uv.transform_point2(*uv);
            }
        }
        for uv in uvs.iter_mut().filter(|uv| !uv.is_finite()) {
            self.warnings.note("texture coordinates that are not finite become 0", &self.mesh.name);
            *uv = Vec2::ZERO;
        }
        uvs
    }

    /// Colours for `count` vertices, RGB or RGBA; none where the file has none, or none that can be read.
    fn colours(&mut self, index: Option<Index<Accessor>>, count: usize) -> Vec<Vec4> {
        let Some(index) = index else {
            return Vec::new();
        };
        let kind = self.data.root.accessors.get(index.value()).map(|accessor| accessor.type_);
        let read = if matches!(kind, Some(Checked::Valid(Type::Vec3))) {
            self.data
                .vectors::<3>(index)
                .map(|rows| rows.into_iter().map(|rgb| Vec3::from(rgb).extend(1.0)).collect())
        } else {
            self.data.vectors::<4>(index).map(|rows| rows.into_iter().map(Vec4::from).collect())
        };
        let read = read.and_then(|colours: Vec<Vec4>| {
            if colours.len() == count {
                Ok(colours)
            } else {
                Err(Fault(format!("{count} positions and {} colours", colours.len())))
            }
        });
        let mut colours = read.unwrap_or_else(|Fault(why)| {
            let subject = format!("{why}, in mesh {:?}", self.mesh.name);
            self.warnings.note("vertex colours that cannot be read are left out", &subject);
            Vec::new()
        });
        for colour in &mut colours {
            if !colour.is_finite() {
                self.warnings.note("vertex colours that are not finite become white", &self.mesh.name);
                *colour = Vec4::ONE;
            }
            *colour = colour.clamp(Vec4::ZERO, Vec4::ONE);
        }
        colours
    }
}
