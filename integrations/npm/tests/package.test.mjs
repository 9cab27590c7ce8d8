// What the installed package says is what the command says, and what is wrong is told with its key. UMBRAGE is the command.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { test } from "node:test";
import init, { Planner, Shaders, localOrigin, presets, settings } from "umbrage";

await init({ module_or_path: readFileSync(fileURLToPath(import.meta.resolve("umbrage/umbrage_bg.wasm"))) });
const umbrage = (...words) => execFileSync(process.env.UMBRAGE, words, { encoding: "utf8", maxBuffer: 1 << 26 });

const camera = { eye: [0, 2, 9], forward: [0, 0, -1], fov_y: 1, aspect: 1.6, near: 0.1, far: 300 };
const sun = { kind: "sun", direction: [-1, -2, -1] };
const frame = { camera, lights: [sun], picture: [1280, 720] };
const itself = () => {
  const object = {};
  object.bias = object;
  return object;
};
const planner = (chosen = settings("default")) => {
  const planner = new Planner(chosen);
  planner.setBoxes([-50, 0, -50, 50, 0, 50, -1, 0, -1, 1, 3, 1, 40, 0, 40, 42, 2, 42]);
  return planner;
};

test("presets, texts and bindings are those of the command", () => {
  for (const name of presets()) assert.ok(umbrage("presets").includes(name), name);
  for (const [name, words] of [["default", []], ["soft", ["--preset", "soft"]], ["vsm", ["--set", "filter.kind=vsm"]]]) {
    const chosen = name === "vsm" ? settings("default", { "filter.kind": "vsm" }) : settings(name);
    const shaders = new Shaders(chosen);
    assert.ok(shaders.stages().includes("receiver"), name);
    for (const stage of shaders.stages()) {
      assert.equal(shaders.text(stage, 2), umbrage("wgsl", "--stage", stage, "--group", "2", ...words), `${name} ${stage}`);
    }
    const { bindings } = JSON.parse(umbrage("plan", "primitives", "--json", "-", ...words));
    for (const [stage, wanted] of Object.entries(bindings)) {
      const names = shaders.bindings(stage, 4).map(({ binding, name }) => [binding, name]);
      assert.deepEqual(names, wanted.map(({ binding, name }) => [binding + 4, name]), `${name} ${stage}`);
    }
  }
  assert.match(new Shaders(settings("default")).text("receiver", 1, 5), /@group\(1\) @binding\(5\)/);
});

/** Asserts that two values are the same but for the rounding of 32 bits. */
function assertNear(got, wanted, what) {
  if (typeof wanted === "number") return assert.ok(Math.abs(got - wanted) <= 2e-7 * Math.max(1, Math.abs(wanted)), `${what}: ${got}, ${wanted}`);
  if (typeof wanted !== "object" || wanted === null) return assert.equal(got, wanted, what);
  assert.deepEqual(Object.keys(got), Object.keys(wanted), what);
  for (const key of Object.keys(wanted)) assertNear(got[key], wanted[key], `${what}.${key}`);
}

test("a plan is that of the command but for what the world holds", () => {
  const wanted = JSON.parse(umbrage("plan", "primitives", "--json", "-"));
  const { eye, forward, near, far } = wanted.camera;
  // The command's camera has this field of view: the height of clip space is 1 / tan(fov / 2).
  const height = Math.hypot(...wanted.camera.clip_from_world[1].slice(0, 3));
  const like = { eye, forward, near, far, fov_y: 2 * Math.atan(1 / height), aspect: 1280 / 720 };
  const [{ kind, direction }] = wanted.lights;
  const plan = planner().plan({ camera: like, lights: [{ kind, direction }], picture: [1280, 720] });
  assert.deepEqual(Object.keys(plan).filter((key) => !(key in wanted)), []);
  for (const key of ["picture", "lights", "maps", "casters", "texels", "bytes"]) assertNear(plan[key], wanted[key], key);
  plan.splits.forEach((split, i) => assert.ok(Math.abs(split / wanted.splits[i] - 1) < 1e-5, `split ${i}: ${split}`));
  assert.deepEqual(plan.views.map(({ tile, light, split }) => [tile, light, split]),
    wanted.views.map(({ tile, light, split }) => [tile, light, split]));
  assert.equal(plan.frame.byteLength, Buffer.from(wanted.frame, "base64").byteLength);
});

test("settings do not depend on the order of their keys, and objects may be nested", () => {
  const chosen = settings("default", { "filter.size": 5, "filter.kind": "pcf", bias: { normal: 1 }, distance: undefined });
  assert.deepEqual([chosen.filter, chosen.bias.normal], [{ kind: "pcf", size: 5 }, 1]);
  assert.deepEqual(settings("default", null), settings("default"));
});

test("a view names the boxes that cast into it, and boxes move", () => {
  const it = planner();
  const { views } = it.plan(frame);
  assert.deepEqual([...it.casters(0)].sort(), [0, 1], "the box at 40 m is behind the camera and casts away from it");
  const height = views.map((view) => view.depth_metres);
  it.moveBox(1, [-1, 0, -1, 1, 30, 1]);
  assert.notDeepEqual(it.plan(frame).views.map((view) => view.depth_metres), height, "a tower needs deeper maps");
});

test("a camera may see without end, far from the origin", () => {
  const eye = [100000.5, 2, 9];
  const far = { ...camera, eye, far: Infinity };
  assert.ok(Math.abs(localOrigin(far)[0] - eye[0]) < 100, "the origin is near the eye");
  const there = new Planner(settings("default"));
  there.setBoxes(new Float32Array([99950, 0, -50, 100050, 3, 50]));
  const plan = there.plan({ ...frame, camera: far, origin: localOrigin(far) });
  assert.ok(plan.views.every(({ texel_metres }) => texel_metres > 0 && texel_metres < 1), "and its texels are as near the origin");
  assert.equal(plan.camera.far, Infinity);
  const endless = there.plan({ ...frame, camera: far, lights: [{ kind: "point", position: [100000, 2, 0] }] });
  assert.equal(endless.lights[0].range, Infinity);
});

test("what is wrong is told by its key", () => {
  const it = planner();
  for (const [wrong, wanted] of [
    [() => settings("defualt"), /no preset is called `defualt`/],
    [() => settings("default", { splitz: 3 }), /splitz/],
    [() => settings("default", { splits: 30 }), /`splits` must be from 1 to 9, got 30/],
    [() => settings("default", { "filter.size": "large" }), /filter/],
    [() => settings("default", { lambda: NaN }), /lambda/],
    [() => new Planner("default"), /should be an object/],
    [() => new Planner(), /should be an object/],
    [() => settings("default", [3]), /should be an object/],
    [() => new Planner(itself()), /too deep, or itself/],
    [() => new Planner({ splits: 0 }), /splits/],
    [() => new Shaders(settings("default"), "webgl"), /webgl/],
    [() => new Shaders(settings("default")).text("reciever"), /reciever/],
    [() => new Shaders(settings("default")).text("receiver", -1), /group should be from 0 to 31/],
    [() => new Shaders(settings("default")).text("receiver", 0, 4294967295), /first binding should be from 0 to 980/],
    [() => new Shaders(settings("default")).bindings("receiver", 1e6), /first binding/],
    [() => it.setBoxes([1, 2, 3]), /six numbers/],
    [() => it.moveBox(9, [0, 0, 0, 1, 1, 1]), /no box 9: 3/],
    [() => it.moveBox(0, [0, 0, 0]), /six numbers.*got 3/],
    [() => new Planner(settings("default")).casters(0), /plan/],
    [() => it.plan({ ...frame, camera: { ...camera, forwards: [0, 0, 1] } }), /forwards/],
    [() => it.plan({ ...frame, camera: { ...camera, near: NaN } }), /near/],
    [() => it.plan({ ...frame, camera: { ...camera, far: NaN } }), /NaN|near/],
    [() => it.plan({ ...frame, lights: [{ kind: "lamp" }] }), /lamp/],
    [() => it.plan({ ...frame, picture: [0, 0] }), /`picture`/],
    [() => it.plan({ ...frame, origin: [NaN, 0, 0] }), /`origin`/],
    [() => it.plan({}), /camera/],
    [() => it.plan({ ...frame, lights: [{ kind: "point", position: [0, 1] }] }), /length/],
    [() => it.plan({ ...frame, lights: Array(99).fill(sun) }), /99/],
  ]) {
    assert.throws(wrong, (error) => error instanceof Error && wanted.test(error.message), String(wrong));
  }
  it.plan(frame);
  assert.throws(() => it.casters(7), /no view 7: the plan has 4/);
  assert.doesNotThrow(() => it.plan({ ...frame, camera: { ...camera, up: undefined, far: null } }), "left out is as undefined");
});
