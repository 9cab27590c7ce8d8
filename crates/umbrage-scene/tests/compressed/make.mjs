// Writes the files of this folder. See README.md.

import { Accessor, Document, NodeIO } from "@gltf-transform/core";
import { EXTMeshoptCompression, KHRDracoMeshCompression, KHRMeshQuantization } from "@gltf-transform/extensions";
import { dedup, draco, meshopt, quantize } from "@gltf-transform/functions";
import draco3d from "draco3dgltf";
import { MeshoptDecoder, MeshoptEncoder } from "meshoptimizer";
import { writeFileSync } from "node:fs";

await Promise.all([MeshoptEncoder.ready, MeshoptDecoder.ready]);
const io = new NodeIO()
  .registerExtensions([EXTMeshoptCompression, KHRDracoMeshCompression, KHRMeshQuantization])
  .registerDependencies({
    "draco3d.encoder": await draco3d.createEncoderModule(),
    "meshopt.encoder": MeshoptEncoder,
    "meshopt.decoder": MeshoptDecoder,
  });

/** Vertices and triangles of a sheet of columns × rows squares, from a function of (u, v) to position and normal. */
function sheet(columns, rows, place) {
  const data = { POSITION: [], NORMAL: [], TEXCOORD_0: [], COLOR_0: [], indices: [] };
  for (let row = 0; row <= rows; row++) {
    for (let column = 0; column <= columns; column++) {
      const [u, v] = [column / columns, row / rows];
      const { position, normal } = place(u, v);
      data.POSITION.push(...position);
      data.NORMAL.push(...normal);
      data.TEXCOORD_0.push(u, v);
      data.COLOR_0.push(...[u, v, 1 - u, 1].map((c) => Math.round(255 * c)));
      if (row === rows || column === columns) continue;
      const [a, b] = [row * (columns + 1) + column, (row + 1) * (columns + 1) + column];
      if (place(u, v).hole) continue;
      data.indices.push(a, b, a + 1, a + 1, b, b + 1);
    }
  }
  return data;
}

/** A ring above the ground: closed, with a hole, and with a seam where its texture coordinates begin again. */
const round = (u, v) => {
  const [a, b] = [u * 2 * Math.PI, -v * 2 * Math.PI];
  const normal = [Math.cos(a) * Math.cos(b), Math.sin(b), Math.sin(a) * Math.cos(b)];
  const position = [Math.cos(a) * 1.5 + 0.5 * normal[0], 2 + 0.5 * normal[1], Math.sin(a) * 1.5 + 0.5 * normal[2]];
  return { position, normal };
};
const ring = sheet(14, 8, round);
/** Ground with waves, and with holes. */
const ground = sheet(10, 10, (u, v) => {
  const [x, z] = [8 * u - 4, 8 * v - 4];
  const slope = 0.2 * Math.cos(x);
  const length = Math.hypot(slope, 1);
  const hole = Math.round(u * 10) === 3 && Math.round(v * 10) % 4 === 2;
  return { position: [x, 0.2 * Math.sin(x), z], normal: [-slope / length, 1 / length, 0], hole };
});
/** A flag on two joints. */
const flag = sheet(6, 4, (u, v) => ({ position: [-3.5 + 1.5 * u, 3.5 - v, -2], normal: [0, 0, 1] }));

/** The scene without compression; with another ring, that ring alone. */
function scene(fine) {
  const document = new Document();
  const buffer = document.createBuffer();
  const scene = document.createScene();
  const accessor = (type, array) => document.createAccessor().setType(type).setArray(array).setBuffer(buffer);
  const add = (name, data) => {
    const primitive = document.createPrimitive()
      .setAttribute("POSITION", accessor("VEC3", new Float32Array(data.POSITION)))
      .setAttribute("NORMAL", accessor("VEC3", new Float32Array(data.NORMAL)))
      .setAttribute("TEXCOORD_0", accessor("VEC2", new Float32Array(data.TEXCOORD_0)))
      .setAttribute("COLOR_0", accessor("VEC4", new Uint8Array(data.COLOR_0)).setNormalized(true))
      .setIndices(accessor("SCALAR", new Uint16Array(data.indices)))
      .setMaterial(document.createMaterial(name).setDoubleSided(true).setMetallicFactor(0));
    const node = document.createNode(name).setMesh(document.createMesh(name).addPrimitive(primitive));
    scene.addChild(node);
    return { node, primitive };
  };
  add("ring", fine ?? ring);
  if (fine) return document;
  add("ground", ground);
  const { node, primitive } = add("flag", flag);
  const share = flag.TEXCOORD_0.filter((_, i) => i % 2 === 0);
  primitive
    .setAttribute("JOINTS_0", accessor("VEC4", new Uint8Array(share.flatMap(() => [0, 1, 0, 0]))))
    .setAttribute("WEIGHTS_0", accessor("VEC4", new Float32Array(share.flatMap((u) => [1 - u, u, 0, 0]))));
  const joints = [document.createNode("pole"), document.createNode("tip").setTranslation([1, 0, 0])];
  joints[0].addChild(joints[1]);
  scene.addChild(joints[0]);
  const bind = new Float32Array([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -1, 0, 0, 1]);
  const skin = document.createSkin("flag").setSkeleton(joints[0]).setInverseBindMatrices(accessor("MAT4", bind));
  joints.forEach((joint) => skin.addJoint(joint));
  node.setSkin(skin);
  return document;
}

async function write(name, ...transforms) {
  await writeOf(name, scene(), ...transforms);
}

async function writeOf(name, document, ...transforms) {
  await document.transform(dedup(), ...transforms);
  await io.write(name, document);
}

await write("plain.glb");
await write("quantised.glb", quantize({ pattern: /.*/ }));
await write("meshopt.glb", meshopt({ encoder: MeshoptEncoder, level: "medium" }));
await write("meshopt_high.glb", meshopt({ encoder: MeshoptEncoder, level: "high" }));
await write("draco_edgebreaker.glb", draco({ method: "edgebreaker" }));
// The encoder goes by valences where there are more than 1,000 triangles, and it has all the time there is.
await writeOf("draco_valence.glb", scene(sheet(32, 17, round)), draco({ encodeSpeed: 0, decodeSpeed: 0, quantizePosition: 11, quantizeNormal: 8, quantizeTexcoord: 8 }));
await write("draco_sequential.glb", draco({ method: "sequential" }));
streams("meshopt_streams.glb");

/** The ring, by the modes and filters that the library above does not choose, and with streams of version 1. */
function streams(name) {
  const [chunks, views, accessors] = [[], [], []];
  let length = 0;
  const count = ring.POSITION.length / 3;
  const add = (rows, bytes, stride, mode, filter, version, accessor) => {
    const stream = MeshoptEncoder.encodeGltfBuffer(bytes, rows, stride, mode, version);
    const view = { buffer: 0, byteOffset: length, byteLength: stream.length, byteStride: stride, count: rows, mode, filter };
    const byteStride = mode === "ATTRIBUTES" ? { byteStride: stride } : {};
    views.push({ buffer: 1, byteLength: rows * stride, ...byteStride, extensions: { KHR_meshopt_compression: view } });
    accessors.push({ bufferView: views.length - 1, count: rows, ...accessor });
    chunks.push(stream, new Uint8Array((4 - (stream.length % 4)) % 4));
    length += stream.length + chunks.at(-1).length;
  };
  const four = (data, last) => new Float32Array(data.flatMap((x, i) => (i % 3 === 2 ? [x, last] : [x])));
  const positions = MeshoptEncoder.encodeFilterExp(new Float32Array(ring.POSITION), count, 12, 15);
  add(count, positions, 12, "ATTRIBUTES", "EXPONENTIAL", 1, { componentType: 5126, type: "VEC3", min: [-2, 1.5, -2], max: [2, 2.5, 2] });
  const normals = MeshoptEncoder.encodeFilterOct(four(ring.NORMAL, 0), count, 4, 8);
  add(count, normals, 4, "ATTRIBUTES", "OCTAHEDRAL", 1, { componentType: 5120, normalized: true, type: "VEC3" });
  const uvs = new Uint8Array(new Float32Array(ring.TEXCOORD_0).buffer);
  add(count, uvs, 8, "ATTRIBUTES", "NONE", 0, { componentType: 5126, type: "VEC2" });
  const colours = MeshoptEncoder.encodeFilterColor(new Float32Array(ring.COLOR_0.map((c) => c / 255)), count, 4, 8);
  add(count, colours, 4, "ATTRIBUTES", "COLOR", 1, { componentType: 5121, normalized: true, type: "VEC4" });
  const indices = new Uint8Array(new Uint16Array(ring.indices).buffer);
  add(ring.indices.length, indices, 2, "INDICES", "NONE", 1, { componentType: 5123, type: "SCALAR" });
  const fallback = { byteLength: views.reduce((sum, view) => sum + view.byteLength, 0), extensions: { KHR_meshopt_compression: { fallback: true } } };
  const json = {
    asset: { version: "2.0" },
    extensionsUsed: ["KHR_meshopt_compression", "KHR_mesh_quantization"],
    extensionsRequired: ["KHR_meshopt_compression", "KHR_mesh_quantization"],
    buffers: [{ byteLength: length }, fallback],
    bufferViews: views,
    accessors,
    materials: [{ name: "ring", doubleSided: true, pbrMetallicRoughness: { metallicFactor: 0 } }],
    meshes: [{ name: "ring", primitives: [{ attributes: { POSITION: 0, NORMAL: 1, TEXCOORD_0: 2, COLOR_0: 3 }, indices: 4, material: 0 }] }],
    nodes: [{ name: "ring", mesh: 0 }],
    scenes: [{ nodes: [0] }],
    scene: 0,
  };
  let text = JSON.stringify(json);
  text += " ".repeat((4 - (text.length % 4)) % 4);
  const header = (n, word) => { const bytes = Buffer.alloc(8); bytes.writeUInt32LE(n, 0); bytes.write(word, 4, "latin1"); return bytes; };
  const start = Buffer.from("glTF\x02\0\0\0\0\0\0\0", "latin1");
  start.writeUInt32LE(12 + 8 + text.length + 8 + length, 8);
  writeFileSync(name, Buffer.concat([start, header(text.length, "JSON"), Buffer.from(text), header(length, "BIN\0"), ...chunks]));
}
