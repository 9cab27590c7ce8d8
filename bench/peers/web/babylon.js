// Babylon: its WebGL 2 engine, its own loader and materials, and CascadedShadowGenerator. Its WebGPU engine fetches a
// compiler from elsewhere for shaders that it has in GLSL alone.

import { AMBIENT, run } from "./common.js";

/** Babylon's own default leaves every surface in the shadow of itself in maps of this size: the best of some, by the error. */
const BIAS = 0.003;

run(async (canvas, { scene: file, maps, resolution, camera: view, sun: direction }) => {
  const engine = new BABYLON.Engine(canvas, false, { preserveDrawingBuffer: true });
  const scene = new BABYLON.Scene(engine);
  scene.useRightHandedSystem = true;
  scene.clearColor = new BABYLON.Color4(0, 0, 0, 1);
  await BABYLON.AppendSceneAsync(file, scene);
  for (const thing of [...scene.lights, ...scene.cameras]) thing.dispose();

  const vector = (numbers) => new BABYLON.Vector3(...numbers);
  const camera = new BABYLON.FreeCamera("camera", vector(view.eye), scene);
  Object.assign(camera, { fov: (view.fov_y_degrees * Math.PI) / 180, minZ: view.near, maxZ: view.far });
  camera.upVector = vector(view.up);
  camera.setTarget(vector(view.eye).add(vector(view.forward)));
  scene.activeCamera = camera;

  const sun = new BABYLON.DirectionalLight("sun", vector(direction).normalize(), scene);
  const around = new BABYLON.HemisphericLight("around", BABYLON.Vector3.Up(), scene);
  [around.intensity, around.groundColor] = [AMBIENT, BABYLON.Color3.White()];
  const shadows = new BABYLON.CascadedShadowGenerator(resolution, sun);
  Object.assign(shadows, { numCascades: maps, lambda: 0.5, shadowMaxZ: view.far, depthClamp: true });
  shadows.bias = BIAS;
  shadows.filter = BABYLON.ShadowGenerator.FILTER_PCF;
  shadows.filteringQuality = BABYLON.ShadowGenerator.QUALITY_LOW; // 2 x 2, as hardware has it
  let triangles = 0;
  for (const mesh of scene.meshes) {
    if (!mesh.getTotalIndices?.()) continue;
    shadows.addShadowCaster(mesh, false);
    mesh.receiveShadows = true;
    triangles += mesh.getTotalIndices() / 3;
  }
  await scene.whenReadyAsync();

  return {
    light(withShadows, strength) {
      [sun.shadowEnabled, sun.intensity] = [withShadows, strength];
      // Without shadows no map is drawn.
      const map = shadows.getShadowMap();
      map.refreshRate = withShadows ? 1 : BABYLON.RenderTargetTexture.REFRESHRATE_RENDER_ONCE;
    },
    draw() {
      engine.beginFrame();
      scene.render();
      engine.endFrame();
      return fenced(engine._gl);
    },
    about() {
      return {
        peer: "Babylon",
        version: BABYLON.Engine.Version,
        adapter: `${engine.getGlInfo().renderer} (WebGL 2)`,
        triangles: Math.round(triangles),
      };
    },
  };
});

/** Resolves when the device has done all that it was given. */
function fenced(gl) {
  const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
  gl.flush();
  // Timers are late by milliseconds; messages are not.
  const { port1, port2 } = new MessageChannel();
  return new Promise((done, failed) => {
    port1.onmessage = () => {
      const status = gl.clientWaitSync(fence, 0, 0);
      if (status === gl.WAIT_FAILED) return failed(new Error("the WebGL context is lost"));
      if (status === gl.TIMEOUT_EXPIRED) return port2.postMessage(null);
      gl.deleteSync(fence);
      port1.close();
      done();
    };
    port2.postMessage(null);
  });
}
