// Shadows in WebGPU, from what `umbrage wgsl` and `umbrage plan --json` have written: see README.md beside this file.

const position = { shaderLocation: 0, offset: 0, format: "float32x3" };
const normal = { shaderLocation: 1, offset: 12, format: "float32x3" };
const SKY = [0.55, 0.7, 0.85, 1];
const VERTICES = [{ arrayStride: 24, attributes: [position, normal] }];

const text = async (file) => (await fetch(file)).text();

/** Triangles of a Wavefront file, flat: position and normal of every corner. */
function triangles(obj) {
  const points = [], corners = [];
  for (const [word, ...rest] of obj.split("\n").map((line) => line.trim().split(/\s+/))) {
    if (word === "v") points.push(rest.map(Number));
    if (word !== "f") continue;
    const face = rest.map((corner) => points[parseInt(corner) - 1]);
    for (let i = 2; i < face.length; i++) {
      const [a, b, c] = [face[0], face[i - 1], face[i]];
      const [u, v] = [b, c].map((p) => p.map((x, k) => x - a[k]));
      const normal = [0, 1, 2].map((k) => u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3]);
      for (const p of [a, b, c]) corners.push(...p, ...normal);
    }
  }
  return new Float32Array(corners);
}

/** A layout entry of one of the plan's bindings. */
function entry({ binding, kind, stages, ...of }) {
  const visibility = stages.reduce((sum, stage) => sum | GPUShaderStage[stage.toUpperCase()], 0);
  switch (kind) {
    case "storage": return { binding, visibility, buffer: { type: "read-only-storage" } };
    case "uniform": return { binding, visibility, buffer: { hasDynamicOffset: !!of.has_dynamic_offset } };
    case "texture":
      return { binding, visibility, texture: { sampleType: of.sample_type, viewDimension: of.view_dimension } };
    case "sampler": return { binding, visibility, sampler: { type: of.sampler_type } };
  }
}

async function main() {
  const files = ["plan.json", "receiver.wgsl", "shade.wgsl", "caster.wgsl", "cast.wgsl", "scene.obj"];
  const [plan, receiver, shade, caster, cast, obj] = await Promise.all(files.map(text));
  const { picture, camera, maps, casters, views, bindings, frame } = JSON.parse(plan);
  const adapter = await navigator.gpu?.requestAdapter();
  if (!adapter) throw new Error("this browser has no WebGPU");
  const features = casters.unclipped_depth ? ["depth-clip-control"] : [];
  const device = await adapter.requestDevice({ requiredFeatures: features });
  device.onuncapturederror = ({ error }) => fail(error);

  const buffer = (data, usage) => {
    const made = device.createBuffer({ size: data.byteLength, usage: usage | GPUBufferUsage.COPY_DST });
    device.queue.writeBuffer(made, 0, data);
    return made;
  };
  const world = triangles(obj);
  const vertices = buffer(world, GPUBufferUsage.VERTEX);
  const frameBuffer = buffer(Uint8Array.from(atob(frame), (c) => c.charCodeAt(0)), GPUBufferUsage.STORAGE);
  const viewNumbers = new Uint32Array(64 * views.length); // one every 256 bytes: dynamic offsets lie so far apart
  views.forEach((_, i) => (viewNumbers[64 * i] = i));
  const viewBuffer = { buffer: buffer(viewNumbers, GPUBufferUsage.UNIFORM), size: 16 };
  const cameraBuffer = buffer(new Float32Array(camera.clip_from_world.flat()), GPUBufferUsage.UNIFORM);
  const mapTexture = device.createTexture({
    size: [maps.width, maps.height, maps.layers],
    format: maps.format,
    usage: GPUTextureUsage.RENDER_ATTACHMENT | GPUTextureUsage.TEXTURE_BINDING,
  });

  // What Umbrage's texts bind, by the names that they have there.
  const resources = {
    camera_rows: { buffer: cameraBuffer },
    umbrage_frame: { buffer: frameBuffer },
    umbrage_current_view: viewBuffer,
    umbrage_map: mapTexture.createView({ dimension: "2d-array" }),
    umbrage_compare: device.createSampler(maps.compare_sampler),
    umbrage_nearest: device.createSampler(),
  };
  const group = (list) => {
    const layout = device.createBindGroupLayout({ entries: list.map(entry) });
    const entries = list.map(({ binding, name }) => ({ binding, resource: resources[name] }));
    return [layout, device.createBindGroup({ layout, entries })];
  };
  const [casterLayout, casterGroup] = group(bindings.caster);
  const [receiverLayout, receiverGroup] = group(bindings.receiver);
  const [cameraLayout, cameraGroup] = group([{ binding: 0, name: "camera_rows", kind: "uniform", stages: ["vertex"] }]);

  const castModule = device.createShaderModule({ code: caster + cast });
  const castPipeline = device.createRenderPipeline({
    layout: device.createPipelineLayout({ bindGroupLayouts: [casterLayout] }),
    vertex: { module: castModule, buffers: VERTICES },
    primitive: { cullMode: casters.cull_mode, unclippedDepth: casters.unclipped_depth },
    depthStencil: {
      format: maps.format, depthWriteEnabled: true, depthCompare: casters.depth_compare,
      depthBias: casters.depth_bias, depthBiasSlopeScale: casters.depth_bias_slope_scale,
    },
  });
  const canvas = document.querySelector("canvas");
  [canvas.width, canvas.height] = [picture.width, picture.height];
  const context = canvas.getContext("webgpu");
  const format = navigator.gpu.getPreferredCanvasFormat();
  context.configure({ device, format });
  const shadeModule = device.createShaderModule({ code: receiver + shade });
  const shadePipeline = device.createRenderPipeline({
    layout: device.createPipelineLayout({ bindGroupLayouts: [cameraLayout, receiverLayout] }),
    vertex: { module: shadeModule, buffers: VERTICES },
    fragment: { module: shadeModule, targets: [{ format }] },
    depthStencil: { format: "depth32float", depthWriteEnabled: true, depthCompare: "greater" }, // reversed depth
  });

  const encoder = device.createCommandEncoder();
  const drawn = new Set();
  views.forEach(({ tile: { layer, x, y, size } }, i) => {
    const view = mapTexture.createView({ dimension: "2d", baseArrayLayer: layer, arrayLayerCount: 1 });
    const depthLoadOp = drawn.has(layer) ? "load" : "clear";
    drawn.add(layer);
    const pass = encoder.beginRenderPass({
      colorAttachments: [],
      depthStencilAttachment: { view, depthLoadOp, depthClearValue: casters.depth_clear, depthStoreOp: "store" },
    });
    pass.setPipeline(castPipeline);
    pass.setViewport(x, y, size, size, 0, 1);
    pass.setScissorRect(x, y, size, size);
    pass.setBindGroup(0, casterGroup, [256 * i]);
    pass.setVertexBuffer(0, vertices);
    pass.draw(world.length / 6);
    pass.end();
  });
  const size = [canvas.width, canvas.height], usage = GPUTextureUsage.RENDER_ATTACHMENT;
  const depth = device.createTexture({ size, format: "depth32float", usage });
  const pass = encoder.beginRenderPass({
    colorAttachments: [
      { view: context.getCurrentTexture().createView(), loadOp: "clear", storeOp: "store", clearValue: SKY },
    ],
    depthStencilAttachment: {
      view: depth.createView(), depthLoadOp: "clear", depthClearValue: 0, depthStoreOp: "discard",
    },
  });
  pass.setPipeline(shadePipeline);
  pass.setBindGroup(0, cameraGroup);
  pass.setBindGroup(1, receiverGroup);
  pass.setVertexBuffer(0, vertices);
  pass.draw(world.length / 6);
  pass.end();
  device.queue.submit([encoder.finish()]);
  await device.queue.onSubmittedWorkDone();
  document.body.dataset.drawn = "yes";
}

function fail(error) {
  document.querySelector("#message").textContent = error.message ?? error;
}

main().catch(fail);
