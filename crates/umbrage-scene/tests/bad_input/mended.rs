//! Documents of which a scene is left: each change to a good one, and what its one warning must say.

use super::*;

/// What is done to the document, what the only warning must say, and how it is done. The triangle is drawn.
pub const MENDED: &[(&str, &str, Spoil)] = &[
    (
        "fewer normals than positions",
        "normals that cannot be read are computed, flat: 3 positions and 2 normals",
        |d| {
            d.accessor(&floats(&[0.0; 6]), "", r#""count": 2, "componentType": 5126, "type": "VEC3""#);
            d.primitives = d.primitives.replace("}}", r#", "NORMAL": 1}}"#);
        },
    ),
    (
        "fewer texture coordinates than positions",
        "texture coordinates that cannot be read become 0: 3 positions and 2 texture coordinates",
        |d| {
            d.accessor(&shorts(&[0; 4]), "", r#""count": 2, "componentType": 5123, "type": "VEC2""#);
            d.primitives = d.primitives.replace("}}", r#", "TEXCOORD_0": 1}}"#);
        },
    ),
    ("a child that is not there", "node 4 of 1 in node 0", |d| {
        d.nodes = r#"{"mesh": 0, "children": [4]}"#.to_owned();
    }),
    ("a node that is its own child", "own ancestors", |d| {
        d.nodes = r#"{"mesh": 0, "children": [0]}"#.to_owned();
    }),
    ("nodes in a circle", "own ancestors", |d| {
        d.nodes = r#"{"mesh": 0}, {"children": [2]}, {"children": [1]}"#.to_owned();
    }),
    ("a node with two parents", "several nodes", |d| {
        d.nodes = r#"{"children": [2]}, {"children": [2]}, {"mesh": 0}"#.to_owned();
    }),
    ("a node with the same child twice", "several nodes", |d| {
        d.nodes = r#"{"children": [1, 1]}, {"mesh": 0}"#.to_owned();
    }),
    ("a scene with an inner node", "without their parent", |d| {
        d.nodes = r#"{"children": [1]}, {"mesh": 0}"#.to_owned();
        d.rest = r#", "scenes": [{"nodes": [1]}]"#.to_owned();
    }),
    ("a scene with a node twice", "twice", |d| d.rest = r#", "scenes": [{"nodes": [0, 0]}]"#.to_owned()),
    ("a matrix with perspective", "need 0 0 0 1", |d| {
        d.nodes = r#"{"mesh": 0, "matrix": [1,0,0,1, 0,1,0,0, 0,0,1,0, 0,0,0,1]}"#.to_owned();
    }),
    ("a rotation of length 0", "unit quaternion", |d| {
        d.nodes = r#"{"mesh": 0, "rotation": [0, 0, 0, 0]}"#.to_owned();
    }),
    ("a camera that sees backwards", "need 0 < near < far", |d| {
        d.nodes = r#"{"mesh": 0, "camera": 0}"#.to_owned();
        d.rest =
            r#", "cameras": [{"type": "perspective", "perspective": {"yfov": 1, "znear": 5, "zfar": 2}}]"#
                .to_owned();
    }),
    ("a camera with no field of view", "need 0 to π", |d| {
        d.nodes = r#"{"mesh": 0, "camera": 0}"#.to_owned();
        d.rest =
            r#", "cameras": [{"type": "perspective", "perspective": {"yfov": 0, "znear": 1}}]"#.to_owned();
    }),
    ("a light inside out", "half angles are not", |d| {
        d.nodes = r#"{"mesh": 0, "extensions": {"KHR_lights_punctual": {"light": 0}}}"#.to_owned();
        d.rest = r#", "extensions": {"KHR_lights_punctual": {"lights": [{"type": "spot", "spot": {"innerConeAngle": 1, "outerConeAngle": 0.5}}]}}"#.to_owned();
    }),
    ("a light that is not there", "light 3 of 0 in node 0", |d| {
        d.nodes = r#"{"mesh": 0, "extensions": {"KHR_lights_punctual": {"light": 3}}}"#.to_owned();
    }),
    ("a picture that is none", "is not a readable PNG", |d| picture(d, b"not a picture at all")),
    ("a picture that ends early", "is not a readable PNG", |d| picture(d, &png(9, 9, [7; 4])[..50])),
    ("a picture of 4 gigapixels", "texture", |d| {
        let mut bomb = png(1, 1, [7; 4]);
        bomb[16..24].copy_from_slice(&[0, 1, 0, 0, 0, 1, 0, 0]);
        picture(d, &bomb);
    }),
    ("a picture on the net", "need a relative path", |d| {
        picture(d, &[]);
        d.rest = d.rest.replace(r#""bufferView": 1"#, r#""uri": "https://example.com/a.png""#);
    }),
    ("a picture in a file, where there are only bytes", "no folder", |d| {
        picture(d, &[]);
        d.rest = d.rest.replace(r#""bufferView": 1"#, r#""uri": "a.png""#);
    }),
    ("a picture from nowhere", "neither a URI nor a buffer view", |d| {
        picture(d, &[]);
        d.rest = d.rest.replace(r#""bufferView": 1"#, "");
    }),
    ("an extension that is required and not needed", "missing: ACME_nothing", |d| {
        d.rest = r#", "extensionsRequired": ["ACME_nothing", "KHR_draco_mesh_compression"]"#.to_owned();
    }),
    ("lists that are none", "\"materials\" is not a list", |d| d.rest = r#", "materials": 7"#.to_owned()),
    ("a node that is none", "node 1", |d| d.nodes = r#"{"mesh": 0}, 7"#.to_owned()),
    ("a camera that is none", "left out: node 0, missing field", |d| {
        d.nodes = r#"{"mesh": 0, "camera": 0}"#.to_owned();
        d.rest = r#", "cameras": [{}]"#.to_owned();
    }),
    ("an intensity beyond all numbers", "\"intensity\" of \"lights\" 0", |d| {
        lamp(d, r#""intensity": 1e400"#);
    }),
    ("a colour of two numbers", "\"color\" of \"lights\" 0", |d| lamp(d, r#""color": [1, 1]"#)),
    ("a light of no kind", "is of no kind", |d| {
        lamp(d, "");
        d.rest = d.rest.replace("point", "area");
    }),
    ("a light at 1e30", "lights that stand too far", |d| {
        lamp(d, "");
        d.nodes = d.nodes.replace(r#""extensions""#, r#""translation": [0, 1e30, 0], "extensions""#);
        d.nodes = format!(r#"{{"mesh": 0}}, {}"#, d.nodes.replace(r#""mesh": 0, "#, ""));
    }),
    ("a camera at 1e30", "cameras that stand too far", |d| {
        d.nodes = r#"{"mesh": 0}, {"camera": 0, "translation": [1e30, 0, 0]}"#.to_owned();
        d.rest =
            r#", "cameras": [{"type": "perspective", "perspective": {"yfov": 1, "znear": 1}}]"#.to_owned();
    }),
    ("a neighbour at 1e30", "1 of 2 of mesh \"mesh 0\", corners need", |d| {
        let far = [&CORNERS[..], &CORNERS[..8], &[1e30]].concat();
        d.accessors.clear();
        d.accessor(&floats(&far), "", r#""count": 6, "componentType": 5126, "type": "VEC3""#);
    }),
    ("a neighbour that is not a number", "1 of 2 of mesh", |d| {
        let far = [&CORNERS[..], &CORNERS[..8], &[f32::NAN]].concat();
        d.accessors.clear();
        d.accessor(&floats(&far), "", r#""count": 6, "componentType": 5126, "type": "VEC3""#);
    }),
    ("an index too many", "1 of 4 of mesh", |d| {
        d.accessor(&[0, 1, 2, 0], "", r#""count": 4, "componentType": 5121, "type": "SCALAR""#);
        d.primitives = d.primitives.replace("}}", r#"}, "indices": 1}"#);
    }),
    ("an index out of range beside good ones", "1 of 2 of mesh \"mesh 0\", index 7", |d| {
        d.accessor(&[0, 1, 2, 0, 1, 7], "", r#""count": 6, "componentType": 5121, "type": "SCALAR""#);
        d.primitives = d.primitives.replace("}}", r#"}, "indices": 1}"#);
    }),
    ("a broken primitive beside a good one", "accessor 9 of 1 is not there, in mesh \"mesh 0\"", |d| {
        d.primitives = format!(r#"{{"attributes": {{"POSITION": 9}}}}, {}"#, d.primitives);
    }),
    ("a primitive that is none", "primitive 1 of mesh 0", |d| d.primitives += ", 7"),
    ("an accessor that is none", "accessor 1 cannot be read, missing field", |d| {
        d.accessors.push("{}".to_owned());
        d.primitives = format!(r#"{{"attributes": {{"POSITION": 1}}}}, {}"#, d.primitives);
    }),
    ("a material with an odd member", "\"alphaCutoff\" of \"materials\" 0", |d| {
        d.primitives = d.primitives.replace("}}", r#"}, "material": 0}"#);
        d.rest = r#", "materials": [{"alphaCutoff": "half"}]"#.to_owned();
    }),
    ("a material that is not there", "material 4 of 0 in mesh 0", |d| {
        d.primitives = d.primitives.replace("}}", r#"}, "material": 4}"#);
    }),
    ("a texture that is not there", "\"baseColorTexture\" of material 0", |d| {
        d.primitives = d.primitives.replace("}}", r#"}, "material": 0}"#);
        d.rest =
            r#", "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 3}}}]"#.to_owned();
    }),
    ("a colour beyond f32", "baseColorFactor", |d| {
        d.primitives = d.primitives.replace("}}", r#"}, "material": 0}"#);
        d.rest =
            r#", "materials": [{"pbrMetallicRoughness": {"baseColorFactor": [1e39, 0, 0, 1]}}]"#.to_owned();
    }),
    ("a scene that is not there", "the default scene, of 0", |d| d.rest = r#", "scene": 4"#.to_owned()),
    ("a scene without nodes", "lists no node", |d| d.rest = r#", "scenes": [{}]"#.to_owned()),
    ("an animation without a target", "channel 0 of animation 0, its target has no pointer", |d| {
        d.rest = r#", "animations": [{"channels": [{"target": {"path": "pointer"}}]}]"#.to_owned();
    }),
    ("an origin of the wrong type", "malformed extras", |d| {
        d.rest = r#", "scenes": [{"nodes": [0], "extras": {"umbrage": {"origin": "here"}}}]"#.to_owned();
    }),
];
