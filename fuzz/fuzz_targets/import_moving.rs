//! Files with masks, skins, morph targets, animations, instances and hidden nodes, made of choices that the fuzzer makes:
//! most are sound, and each may be wrong.

#![no_main]

mod container;

use libfuzzer_sys::arbitrary::{Result, Unstructured};
use libfuzzer_sys::fuzz_target;

/// Rows of the binary chunk that accessors show; floats, so that most of them are usable numbers.
const FLOATS: usize = 256;
const COMPONENTS: [u32; 6] = [5126, 5121, 5123, 5125, 5120, 5122];
const TYPES: [&str; 5] = ["SCALAR", "VEC2", "VEC3", "VEC4", "MAT4"];

/// Numbers of an accessor for each use, which `accessors` lists in this order.
const POSITION: usize = 0;
const NORMAL: usize = 1;
const UV: usize = 2;
const COLOUR: usize = 3;
const JOINTS: usize = 4;
const WEIGHTS: usize = 5;
const INDICES: usize = 6;
const MATRICES: usize = 7;
const TIMES: usize = 8;
const VECTORS: usize = 9;
const ROTATIONS: usize = 10;
const SCALARS: usize = 11;
const FLAGS: usize = 12;

struct Choices<'a>(Unstructured<'a>);

impl Choices<'_> {
    /// The number that is right, or once in a while any.
    fn mostly(&mut self, right: usize) -> Result<usize> {
        if self.0.ratio(1, 16)? { self.0.int_in_range(0..=20) } else { Ok(right) }
    }

    fn float(&mut self) -> Result<String> {
        let wild = ["1e30", "-1e30", "1e-30", "0", "-1", "1e400"];
        if self.0.ratio(1, 12)? {
            return Ok((*self.0.choose(&wild)?).to_owned());
        }
        Ok(format!("{}", f32::from(self.0.arbitrary::<i16>()?) / 4096.0))
    }

    fn floats(&mut self, count: usize) -> Result<String> {
        (0..count)
            .map(|_| self.float())
            .collect::<Result<Vec<_>>>()
            .map(|floats| format!("[{}]", floats.join(",")))
    }

    fn maybe(&mut self, text: impl FnOnce(&mut Self) -> Result<String>) -> Result<String> {
        if self.0.ratio(1, 2)? { text(self) } else { Ok(String::new()) }
    }

    fn accessor(&mut self, component: u32, kind: &str, count: usize) -> Result<String> {
        let count = if self.0.ratio(1, 16)? { usize::from(self.0.arbitrary::<u16>()?) } else { count };
        let component = if self.0.ratio(1, 16)? { *self.0.choose(&COMPONENTS)? } else { component };
        let kind = if self.0.ratio(1, 24)? { *self.0.choose(&TYPES)? } else { kind };
        let offset = 4 * self.0.int_in_range(0..=FLOATS / 4)?;
        let normalized = self.0.ratio(1, 3)?;
        let view = if self.0.ratio(1, 24)? { "" } else { r#""bufferView":0,"# };
        Ok(format!(
            r#"{{{view}"byteOffset":{offset},"componentType":{component},"type":"{kind}","count":{count},"normalized":{normalized}}}"#
        ))
    }

    fn accessors(&mut self) -> Result<String> {
        let uses = [
            (5126, "VEC3", 6),
            (5126, "VEC3", 6),
            (5126, "VEC2", 6),
            (5121, "VEC4", 6),
            (5121, "VEC4", 6),
            (5126, "VEC4", 6),
            (5121, "SCALAR", 9),
            (5126, "MAT4", 2),
            (5126, "SCALAR", 3),
            (5126, "VEC3", 3),
            (5126, "VEC4", 3),
            (5126, "SCALAR", 6),
            (5121, "SCALAR", 3),
        ];
        let list = uses.map(|(component, kind, count)| self.accessor(component, kind, count));
        Ok(list.into_iter().collect::<Result<Vec<_>>>()?.join(","))
    }

    fn primitive(&mut self) -> Result<String> {
        let mut attributes = vec![format!(r#""POSITION":{}"#, self.mostly(POSITION)?)];
        for (name, right) in [
            ("NORMAL", NORMAL),
            ("TEXCOORD_0", UV),
            ("COLOR_0", COLOUR),
            ("JOINTS_0", JOINTS),
            ("WEIGHTS_0", WEIGHTS),
        ] {
            if self.0.ratio(3, 4)? {
                attributes.push(format!(r#""{name}":{}"#, self.mostly(right)?));
            }
        }
        let targets = self.maybe(|c| {
            let (a, b) = (c.mostly(POSITION)?, c.mostly(NORMAL)?);
            Ok(format!(r#","targets":[{{"POSITION":{a}}},{{"NORMAL":{b},"POSITION":{b}}}]"#))
        })?;
        let indices = self.maybe(|c| Ok(format!(r#","indices":{}"#, c.mostly(INDICES)?)))?;
        Ok(format!(r#"{{"attributes":{{{}}},"material":0{indices}{targets}}}"#, attributes.join(",")))
    }

    fn node(&mut self, number: usize) -> Result<String> {
        let mut members = vec![format!(r#""name":"{number}""#)];
        if number < 3 {
            members.push(format!(r#""mesh":{}"#, number % 2));
        }
        if self.0.ratio(1, 2)? {
            members.push(format!(r#""skin":{}"#, self.mostly(0)?));
        }
        if self.0.ratio(1, 2)? {
            members.push(format!(r#""children":[{}]"#, self.mostly(number + 1)?));
        }
        if self.0.ratio(1, 2)? {
            members.push(format!(r#""translation":{},"scale":{}"#, self.floats(3)?, self.floats(3)?));
        }
        if self.0.ratio(1, 2)? {
            members.push(format!(r#""rotation":{}"#, self.floats(4)?));
        }
        if self.0.ratio(1, 4)? {
            members.push(format!(r#""weights":{}"#, self.floats(2)?));
        }
        let visible = self
            .maybe(|c| Ok(format!(r#""KHR_node_visibility":{{"visible":{}}}"#, c.0.arbitrary::<bool>()?)))?;
        let instancing = self.maybe(|c| {
            let (a, b, d) = (c.mostly(VECTORS)?, c.mostly(ROTATIONS)?, c.mostly(VECTORS)?);
            Ok(format!(r#""EXT_mesh_gpu_instancing":{{"attributes":{{"TRANSLATION":{a},"ROTATION":{b},"SCALE":{d}}}}}"#))
        })?;
        let extensions =
            [visible, instancing].into_iter().filter(|text| !text.is_empty()).collect::<Vec<_>>();
        members.push(format!(r#""extensions":{{{}}}"#, extensions.join(",")));
        Ok(format!("{{{}}}", members.join(",")))
    }

    fn animation(&mut self) -> Result<String> {
        let paths = ["translation", "rotation", "scale", "weights", "pointer"];
        let ways = ["LINEAR", "STEP", "CUBICSPLINE"];
        let (mut channels, mut samplers) = (Vec::new(), Vec::new());
        for number in 0..self.0.int_in_range(1..=4)? {
            let path = *self.0.choose(&paths)?;
            let right = match path {
                "rotation" => ROTATIONS,
                "weights" => SCALARS,
                "pointer" => FLAGS,
                _ => VECTORS,
            };
            let (input, output, way) = (self.mostly(TIMES)?, self.mostly(right)?, *self.0.choose(&ways)?);
            samplers.push(format!(r#"{{"input":{input},"output":{output},"interpolation":"{way}"}}"#));
            let node = self.0.int_in_range(0..=6)?;
            let pointer = if path == "pointer" {
                format!(
                    r#","extensions":{{"KHR_animation_pointer":{{"pointer":"/nodes/{node}/extensions/KHR_node_visibility/visible"}}}}"#
                )
            } else {
                format!(r#","node":{node}"#)
            };
            channels.push(format!(r#"{{"sampler":{number},"target":{{"path":"{path}"{pointer}}}}}"#));
        }
        Ok(format!(r#"{{"channels":[{}],"samplers":[{}]}}"#, channels.join(","), samplers.join(",")))
    }

    /// A whole file.
    fn file(&mut self) -> Result<Vec<u8>> {
        let modes = ["OPAQUE", "MASK", "BLEND", "HAZE"];
        let mode = *self.0.choose(&modes)?;
        let (cutoff, colour, transmission) = (self.float()?, self.floats(4)?, self.float()?);
        let accessors = self.accessors()?;
        let meshes = format!(
            r#"{{"primitives":[{}]}},{{"primitives":[{}],"weights":{}}}"#,
            self.primitive()?,
            self.primitive()?,
            self.floats(2)?
        );
        let nodes = (0..6).map(|number| self.node(number)).collect::<Result<Vec<_>>>()?.join(",");
        let joints = [self.mostly(3)?, self.mostly(4)?, self.mostly(5)?];
        let skin = format!(r#"{{"joints":{joints:?},"inverseBindMatrices":{}}}"#, self.mostly(MATRICES)?);
        let animations = [self.animation()?, self.animation()?].join(",");
        let length = 4 * FLOATS;
        let json = format!(
            r#"{{"asset":{{"version":"2.0"}},"buffers":[{{"byteLength":{length}}}],"bufferViews":[{{"buffer":0,"byteLength":{length}}}],
            "accessors":[{accessors}],"materials":[{{"alphaMode":"{mode}","alphaCutoff":{cutoff},
            "pbrMetallicRoughness":{{"baseColorFactor":{colour}}},
            "extensions":{{"KHR_materials_transmission":{{"transmissionFactor":{transmission}}}}}}}],
            "meshes":[{meshes}],"nodes":[{nodes}],"skins":[{skin}],"animations":[{animations}]}}"#
        );
        // What is left fills the buffer: small numbers, which grow where they are times.
        let rest = self.0.bytes(self.0.len().min(FLOATS))?;
        let number =
            |i: usize| i as f32 / 16.0 + rest.get(i).map_or(0.0, |byte| f32::from(*byte as i8) / 64.0);
        let binary: Vec<u8> = (0..FLOATS).flat_map(|i| number(i).to_le_bytes()).collect();
        Ok(container::glb(&json, &binary))
    }
}

/// The bytes, and then as many more as a file can need, which they determine: where choices end, all would be the first.
fn endless(bytes: &[u8]) -> Vec<u8> {
    let mut state = bytes
        .iter()
        .fold(0x9e37_79b9_7f4a_7c15_u64, |sum, byte| (sum ^ u64::from(*byte)).wrapping_mul(0x100_0000_01b3));
    let more = std::iter::repeat_with(|| {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 32) as u8
    });
    bytes.iter().copied().chain(more.take(4096)).collect()
}

fuzz_target!(|bytes: &[u8]| {
    let file = Choices(Unstructured::new(&endless(bytes))).file();
    container::import(&file.expect("there are choices enough"));
});
