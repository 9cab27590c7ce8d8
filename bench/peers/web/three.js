// three.js: WebGPURenderer, its own loader and materials, and CSMShadowNode.

import * as THREE from "three/webgpu";
import { CSMShadowNode } from "three/addons/csm/CSMShadowNode.js";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";
import { AMBIENT, run } from "./common.js";

/** three.js has no bias by default. Each cascade is given so many of its texels. */
const BIAS_TEXELS = 1.5;

run(async (canvas, { scene: file, width, height, maps, resolution, camera: view, sun: direction }) => {
  const renderer = new THREE.WebGPURenderer({ canvas, antialias: false });
  renderer.setSize(width, height, false);
  renderer.shadowMap.enabled = true;
  renderer.shadowMap.type = THREE.PCFShadowMap;
  await renderer.init();

  const world = (await new GLTFLoader().loadAsync(file)).scene;
  let triangles = 0;
  const lights = [];
  world.traverse((thing) => {
    if (thing.isLight) lights.push(thing);
    if (!thing.isMesh) return;
    thing.castShadow = thing.receiveShadow = true;
    const { index, attributes } = thing.geometry;
    triangles += ((index ?? attributes.position).count / 3) * (thing.isInstancedMesh ? thing.count : 1);
  });
  for (const light of lights) light.removeFromParent();
  const scene = new THREE.Scene();
  scene.background = new THREE.Color(0, 0, 0);
  scene.add(world, new THREE.AmbientLight(0xffffff, AMBIENT));

  const camera = new THREE.PerspectiveCamera(view.fov_y_degrees, width / height, view.near, view.far);
  camera.position.set(...view.eye);
  camera.up.set(...view.up);
  camera.lookAt(...view.eye.map((at, axis) => at + view.forward[axis]));
  camera.updateMatrixWorld();

  // Casters as far away as the world reaches are before the maps' near planes.
  const reach = new THREE.Box3().setFromObject(world).getSize(new THREE.Vector3()).length();
  const sun = new THREE.DirectionalLight(0xffffff, 1);
  sun.position.set(...direction).normalize().negate();
  sun.shadow.mapSize.set(resolution, resolution);
  Object.assign(sun.shadow.camera, { near: 0, far: 2 * (reach + view.far) });
  const cascades = new CSMShadowNode(sun, { cascades: maps, maxFar: view.far, mode: "practical", lightMargin: reach });
  sun.shadow.shadowNode = cascades;
  scene.add(sun, sun.target);

  const { device } = renderer.backend;
  return {
    light(shadows, strength) {
      [sun.castShadow, sun.intensity] = [shadows, strength];
      for (const { shadow } of cascades.lights) {
        const texel = (shadow.camera.right - shadow.camera.left) / resolution;
        shadow.bias = (-BIAS_TEXELS * texel) / (shadow.camera.far - shadow.camera.near);
      }
    },
    draw() {
      renderer.render(scene, camera);
      return device.queue.onSubmittedWorkDone();
    },
    about() {
      const { vendor, architecture, description } = device.adapterInfo ?? {};
      return {
        peer: "three.js",
        version: `r${THREE.REVISION}`,
        adapter: `${vendor} ${architecture} ${description} (WebGPU)`,
        triangles: Math.round(triangles),
        cascades: cascades.breaks.map((share) => share * view.far),
      };
    },
  };
});
