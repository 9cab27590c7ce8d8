// Shadows of a three.js sun, in cascades that Umbrage plans: three.js draws the maps and reads them, as its own CSMShadowNode does.
//
//   const node = new PlannedShadowNode(sun, scene, { splits: 3 });
//   sun.shadow.shadowNode = node;

import { Box3, Vector3, WebGPUCoordinateSystem } from "three/webgpu";
import { CSMShadowNode } from "three/addons/csm/CSMShadowNode.js";
import { Planner, settings } from "umbrage";

/** Boxes of the meshes that cast or receive, and nothing of what three.js has of each. */
function boxesOf(meshes) {
  const box = new Box3();
  return new Float32Array(meshes.flatMap((mesh) => [...box.setFromObject(mesh).min, ...box.max]));
}

/** Cascades that fit what the camera sees of the scene. The module's `init()` is awaited before one is made. */
export class PlannedShadowNode extends CSMShadowNode {
  /**
   * @param {DirectionalLight} light - The sun; the size of its maps is that of each cascade.
   * @param {Scene} scene - The scene, whose meshes are looked for once.
   * @param {object} chosen - Settings of Umbrage, by key: `{ splits: 3, distance: 200 }`.
   */
  constructor(light, scene, chosen = {}) {
    // three.js shows what is drawn, so it says the rest: no depth is clamped, and cascades are chosen by view depth.
    const all = settings("default", {
      resolution: light.shadow.mapSize.x, depth: "f32", unclipped_depth: false, select: "depth", ...chosen,
    });
    super(light, { cascades: all.splits });
    this.planner = new Planner(all);
    this.meshes = [];
    scene.traverse((object) => object.isMesh && this.meshes.push(object));
    this.planner.setBoxes(boxesOf(this.meshes));
  }

  /** Says that a mesh has moved. */
  moved(mesh) {
    this.planner.moveBox(this.meshes.indexOf(mesh), boxesOf([mesh]));
  }

  _init(builder) {
    super._init(builder);
    for (const [index, { shadow }] of this.lights.entries()) {
      shadow.camera.coordinateSystem = WebGPUCoordinateSystem;
      shadow.camera.updateProjectionMatrix = () => {};
      shadow.updateMatrices = () => this._look(shadow, this.plan.views[index]);
    }
  }

  /** A cascade's camera stands at the origin and looks along -z; all else is in its projection. */
  _look(shadow, view) {
    const { camera } = shadow;
    const [x, y, z, w] = view.clip_from_world;
    // Umbrage's depth is reversed.
    const depth = camera.reversedDepth ? z : z.map((value, i) => w[i] - value);
    camera.projectionMatrix.set(...x, ...y, ...depth, ...w);
    camera.projectionMatrixInverse.copy(camera.projectionMatrix).invert();
    shadow._updateMatrix(camera, shadow.matrix, shadow.getFrustum());
  }

  /** three.js asks for cascades when it makes the shader. */
  updateFrustums() {
    this._plan();
  }

  updateBefore() {
    super.updateBefore(); // no frustum is there, so all it does is to put the cascades' lights into the scene
    this._plan();
  }

  _plan() {
    const { camera, light } = this;
    if (!camera.isPerspectiveCamera) throw new Error("PlannedShadowNode needs a PerspectiveCamera");
    for (const object of [camera, light, light.target]) object.updateMatrixWorld();
    const column = (object, i) => new Vector3().setFromMatrixColumn(object.matrixWorld, i);
    const { near, far, aspect } = camera;
    this.plan = this.planner.plan({
      camera: {
        eye: column(camera, 3).toArray(), forward: column(camera, 2).negate().toArray(), up: column(camera, 1).toArray(),
        fov_y: (camera.getEffectiveFOV() * Math.PI) / 180, aspect, near, far,
      },
      lights: [{ kind: "sun", direction: column(light.target, 3).sub(column(light, 3)).toArray() }],
      picture: [1, 1], // only Umbrage's own lookup would ask
    });
    // Where cascades begin and end, as shares of the depth range.
    const { splits } = this.plan;
    this.maxFar = Math.min(splits.at(-1), far);
    const share = (depth) => (depth - near) / (this.maxFar - near);
    this._cascades.forEach((cascade, i) => cascade.set(share(splits[i]), share(splits[i + 1])));
  }
}
