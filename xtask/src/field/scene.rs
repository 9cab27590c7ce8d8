//! One small court of casters under one light, at any scale and at any distance from the origin, as a binary glTF file.
//!
//! Lengths of the court are in units of its scale: at scale 1 it is 24 m wide.

use serde_json::{Value, json};

/// How a file says where the court is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Placement {
    /// One node moves everything: vertices are small numbers, and the distance is a number of JSON.
    Node,
    /// As [`Self::Node`], and another court stands near the origin, so that the world is as wide as the distance.
    Wide,
    /// Vertices are far from the origin themselves, and are as coarse as f32 is there.
    Baked,
}

/// The light of a court.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Light {
    Sun,
    Spot,
    Point,
}

/// One court.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Court {
    pub placement: Placement,
    pub light: Light,
    /// The length of a unit, metres.
    pub scale: f64,
    /// From the origin to the court, metres.
    pub distance: f64,
}

type Place = [f64; 3];

/// The unit direction in which courts lie: none of its parts is zero.
const AWAY: Place = [2.0 / 3.0, 1.0 / 3.0, 2.0 / 3.0];
/// Where the other court of a wide world stands, in units: behind the camera and below, so that it is never seen and casts
/// nothing that is.
const BESIDE_ORIGIN: Place = [20.0, -10.0, 20.0];
const EYE: Place = [6.0, 5.0, 9.0];
/// Where the spot stands, and the point light.
const SPOT: Place = [2.0, 6.0, 5.0];
const POINT: Place = [2.0, 4.0, 3.0];
/// Half the side of the ground, and squares along it.
const HALF: f64 = 12.0;
const SQUARES: i32 = 8;
/// Boxes: where the middle of their foot is, and their size. A wall, a pole as thick as a finger is long, and a sheet.
const BOXES: [(Place, Place); 5] = [
    ([0.0, 0.0, 0.0], [1.2, 2.2, 1.2]),
    ([3.0, 0.0, -2.0], [1.4, 1.0, 1.4]),
    ([-3.0, 0.0, 1.5], [1.0, 3.0, 0.4]),
    ([1.5, 0.0, 2.0], [0.08, 4.0, 0.08]),
    ([-1.2, 0.6, -3.0], [2.0, 0.05, 1.2]),
];

impl Court {
    /// The file.
    pub fn glb(&self) -> Vec<u8> {
        let offset = AWAY.map(|part| part * self.distance);
        let baked = self.placement == Placement::Baked;
        let root = if baked { [0.0; 3] } else { offset };
        let inside = if baked { offset } else { [0.0; 3] };
        let in_metres = |p: Place| [0, 1, 2].map(|i| p[i] * self.scale + inside[i]);
        let corners = corners();
        let far: Vec<Place> = corners.iter().map(|(p, _)| in_metres(*p)).collect();
        let mut binary: Vec<u8> = Vec::new();
        for value in far.iter().chain(corners.iter().map(|(_, n)| n)).flatten() {
            binary.extend((*value as f32).to_le_bytes());
        }
        let span = |fold: fn(f64, f64) -> f64, from: f64| {
            [0, 1, 2].map(|i| far.iter().map(|p| f64::from(p[i] as f32)).fold(from, fold))
        };
        let (low, high) = (span(f64::min, f64::INFINITY), span(f64::max, f64::NEG_INFINITY));
        let (count, half) = (far.len(), binary.len() / 2);
        let mut nodes = vec![
            json!({ "name": "court", "translation": root, "children": [1, 2, 3] }),
            json!({ "name": "casters", "mesh": 0 }),
            json!({ "name": "camera", "camera": 0, "matrix": looking(in_metres(EYE), in_metres([0.0, 0.8, 0.0])) }),
            json!({
                "name": "light",
                "matrix": self.light_matrix(in_metres),
                "extensions": { "KHR_lights_punctual": { "light": 0 } },
            }),
        ];
        let mut scene = vec![0];
        if self.placement == Placement::Wide {
            let beside = BESIDE_ORIGIN.map(|part| part * self.scale);
            nodes.push(json!({ "name": "at the origin", "mesh": 0, "translation": beside }));
            scene.push(nodes.len() - 1);
        }
        let view = |start: usize| json!({ "buffer": 0, "byteOffset": start, "byteLength": half });
        let root = json!({
            "asset": { "version": "2.0" },
            "scene": 0,
            "scenes": [{ "nodes": scene }],
            "nodes": nodes,
            "cameras": [{
                "type": "perspective",
                "perspective": { "yfov": 0.9, "znear": 0.1 * self.scale, "zfar": 60.0 * self.scale },
            }],
            "extensionsUsed": ["KHR_lights_punctual"],
            "extensions": { "KHR_lights_punctual": { "lights": [self.light_value()] } },
            "meshes": [{ "primitives": [{ "attributes": { "POSITION": 0, "NORMAL": 1 } }] }],
            "accessors": [
                { "bufferView": 0, "componentType": 5126, "count": count, "type": "VEC3", "min": low, "max": high },
                { "bufferView": 1, "componentType": 5126, "count": count, "type": "VEC3" },
            ],
            "bufferViews": [view(0), view(half)],
            "buffers": [{ "byteLength": binary.len() }],
        });
        pack(root.to_string().into_bytes(), &binary)
    }

    /// The light, as bright at any scale: candela grow with the square of lengths.
    fn light_value(&self) -> Value {
        let candela = |at_scale_1: f64| at_scale_1 * self.scale * self.scale;
        match self.light {
            Light::Sun => json!({ "type": "directional", "intensity": 3.0 }),
            Light::Spot => json!({
                "type": "spot",
                "intensity": candela(90.0),
                "range": 30.0 * self.scale,
                "spot": { "innerConeAngle": 0.5, "outerConeAngle": 0.65 },
            }),
            Light::Point => {
                json!({ "type": "point", "intensity": candela(40.0), "range": 25.0 * self.scale })
            }
        }
    }

    fn light_matrix(&self, in_metres: impl Fn(Place) -> Place) -> [f64; 16] {
        let (from, to) = match self.light {
            Light::Sun => ([5.0, 7.5, 3.0], [0.0; 3]),
            Light::Spot => (SPOT, [0.0; 3]),
            Light::Point => (POINT, [2.0, 4.0, 0.0]),
        };
        looking(in_metres(from), in_metres(to))
    }
}

/// Three corners a triangle, each with its normal: the ground and the boxes.
fn corners() -> Vec<(Place, Place)> {
    let mut corners = Vec::new();
    let step = 2.0 * HALF / f64::from(SQUARES);
    for (column, row) in (0..SQUARES).flat_map(|row| (0..SQUARES).map(move |column| (column, row))) {
        let at =
            |c: i32, r: i32| [f64::from(column + c) * step - HALF, 0.0, f64::from(row + r) * step - HALF];
        add_quad(&mut corners, [at(0, 0), at(0, 1), at(1, 1), at(1, 0)]);
    }
    for (foot, size) in BOXES {
        for axis in 0..3 {
            for side in [0.0, 1.0] {
                let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
                let corner = |along_u: f64, along_v: f64| {
                    let mut share = [0.0; 3];
                    (share[axis], share[u], share[v]) = (side, along_u, along_v);
                    let share = [share[0] - 0.5, share[1], share[2] - 0.5];
                    [0, 1, 2].map(|i| foot[i] + size[i] * share[i])
                };
                let [a, b, c, d] = [corner(0.0, 0.0), corner(1.0, 0.0), corner(1.0, 1.0), corner(0.0, 1.0)];
                add_quad(&mut corners, if side > 0.0 { [a, b, c, d] } else { [a, d, c, b] });
            }
        }
    }
    corners
}

fn add_quad(corners: &mut Vec<(Place, Place)>, [a, b, c, d]: [Place; 4]) {
    let normal = unit(cross(minus(b, a), minus(c, a)));
    corners.extend([a, b, c, a, c, d].map(|p| (p, normal)));
}

/// The matrix of an observer at `eye` who looks at `target` down its own −Z, column by column.
fn looking(eye: Place, target: Place) -> [f64; 16] {
    let back = unit(minus(eye, target));
    let right = unit(cross([0.0, 1.0, 0.0], back));
    let up = cross(back, right);
    let mut matrix = [0.0; 16];
    for (column, (axis, w)) in [(right, 0.0), (up, 0.0), (back, 0.0), (eye, 1.0)].into_iter().enumerate() {
        matrix[4 * column..4 * column + 3].copy_from_slice(&axis);
        matrix[4 * column + 3] = w;
    }
    matrix
}

fn minus(a: Place, b: Place) -> Place {
    [0, 1, 2].map(|i| a[i] - b[i])
}

fn cross(a: Place, b: Place) -> Place {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn unit(v: Place) -> Place {
    let length = v.iter().map(|part| part * part).sum::<f64>().sqrt();
    v.map(|part| part / length)
}

/// Both chunks with their headers; the binary one is a multiple of four bytes as it is.
fn pack(mut json: Vec<u8>, binary: &[u8]) -> Vec<u8> {
    json.resize(json.len().next_multiple_of(4), b' ');
    let mut glb = b"glTF\x02\0\0\0".to_vec();
    glb.extend((28 + json.len() as u32 + binary.len() as u32).to_le_bytes());
    for (kind, chunk) in [(b"JSON", json.as_slice()), (b"BIN\0", binary)] {
        glb.extend((chunk.len() as u32).to_le_bytes());
        glb.extend(kind);
        glb.extend(chunk);
    }
    glb
}

#[cfg(test)]
mod tests {
    use super::*;

    fn json(court: Court) -> Value {
        let glb = court.glb();
        let length = u32::from_le_bytes([glb[12], glb[13], glb[14], glb[15]]) as usize;
        assert_eq!(glb.len(), u32::from_le_bytes([glb[8], glb[9], glb[10], glb[11]]) as usize, "its length");
        serde_json::from_slice(&glb[20..20 + length]).expect("JSON")
    }

    #[test]
    fn a_far_node_says_the_whole_distance_and_its_vertices_stay_small() {
        let court = Court { placement: Placement::Node, light: Light::Spot, scale: 1.0, distance: 3e6 };
        let json = json(court);
        assert_eq!(json["nodes"][0]["translation"], json!([2e6, 1e6, 2e6]));
        assert_eq!(json["accessors"][0]["min"], json!([-12.0, 0.0, -12.0]));
    }

    #[test]
    fn baked_vertices_hold_the_distance_and_lengths_grow_with_the_scale() {
        let court = Court { placement: Placement::Baked, light: Light::Point, scale: 1000.0, distance: 3e6 };
        let json = json(court);
        assert_eq!(json["nodes"][0]["translation"], json!([0.0, 0.0, 0.0]));
        assert_eq!(json["accessors"][0]["max"], json!([2_012_000.0, 1_004_000.0, 2_012_000.0]));
        let light = &json["extensions"]["KHR_lights_punctual"]["lights"][0];
        assert_eq!((light["range"].as_f64(), light["intensity"].as_f64()), (Some(25e3), Some(40e6)));
    }

    #[test]
    fn a_wide_world_has_something_at_the_origin() {
        let court = Court { placement: Placement::Wide, light: Light::Sun, scale: 1.0, distance: 100.0 };
        assert_eq!(json(court)["scenes"][0]["nodes"], json!([0, 4]));
    }
}
