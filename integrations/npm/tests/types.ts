// Compiles, with no error but those that are expected, when the package's types say what it does.

import init, { Planner, Shaders, type Frame, type LayoutEntry, type Plan, presets, settings } from "umbrage";

export async function plan(device: GPUDevice): Promise<Plan> {
  await init();
  const chosen = settings(presets()[0]!, { splits: 3, filter: { kind: "pcf", size: 5 } });
  const shaders = new Shaders(chosen, "webgpu");
  const entries: LayoutEntry[] = shaders.bindings("receiver", 2) ?? [];
  device.createBindGroupLayout({ entries: entries.map((entry) => entry as GPUBindGroupLayoutEntry) });
  device.createShaderModule({ code: shaders.text("receiver", 1) ?? "" });
  const planner = new Planner(chosen);
  planner.setBoxes(new Float32Array(6));
  const frame: Frame = {
    camera: { eye: [0, 0, 0], forward: [0, 0, -1], fov_y: 1, aspect: 1, near: 0.1 },
    lights: [{ kind: "spot", position: [0, 3, 0], direction: [0, -1, 0], half_angle: 0.5 }],
    picture: [640, 480],
  };
  // @ts-expect-error a sun has no position
  frame.lights.push({ kind: "sun", position: [0, 0, 0] });
  // @ts-expect-error there is no such stage
  shaders.text("reciever");
  const made = planner.plan(frame);
  const casters: Uint32Array = planner.casters(made.views[0]!.split);
  device.queue.writeBuffer(device.createBuffer({ size: casters.length, usage: 8 }), 0, made.frame);
  device.createSampler(made.maps.compare_sampler);
  return made;
}
