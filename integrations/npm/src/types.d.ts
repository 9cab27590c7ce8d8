/** Three coordinates, metres, or the components of a direction of any length. */
export type Vec3 = [number, number, number];

/** Four rows of four; a point is a column on their right. */
export type Mat4 = [Vec4, Vec4, Vec4, Vec4];
export type Vec4 = [number, number, number, number];

/** Settings by their keys: see docs/settings.md of Umbrage. `settings("default")` returns all of them. */
export interface Settings {
  [key: string]: SettingsValue;
}
export type SettingsValue = number | boolean | string | number[] | undefined | { [key: string]: SettingsValue };

/** A camera looks along `forward`. It has either `fov_y` or `half_height`. */
export interface Camera {
  eye: Vec3;
  forward: Vec3;
  /** What is up as near as can be; +y without. */
  up?: Vec3;
  /** The whole vertical field of view, radians. */
  fov_y?: number;
  /** Half the height of what a camera with parallel rays sees, metres. */
  half_height?: number;
  /** The picture's width over its height. */
  aspect: number;
  /** The nearest and the farthest visible view depth, metres. A perspective camera without `far` sees without end. */
  near: number;
  far?: number;
  /** Where the direction of view lies in the picture, NDC; its middle without. */
  centre?: [number, number];
}

/** A light that casts shadows. `resolution` is the side of its tiles, texels; `size` how large it is, where the filter asks. */
export type Light =
  | { kind: "sun"; direction: Vec3; size?: number; resolution?: number }
  | (Lamp & { kind: "spot"; direction: Vec3; half_angle: number })
  | (Lamp & { kind: "point" });
export interface Lamp {
  position: Vec3;
  /** How far it shines, metres; without end where it is left out. */
  range?: number;
  /** How near casters may be, metres. */
  near?: number;
  size?: number;
  resolution?: number;
}

/** What a frame is planned from. */
export interface Frame {
  camera: Camera;
  lights: Light[];
  /** The size of the picture, pixels. */
  picture: [number, number];
  /** The point of the world that positions in shaders are relative to, metres: see `localOrigin`. The world's own without. */
  origin?: Vec3;
}

/**
 * What `umbrage plan --json` prints of a plan; names of formats, faces and samplers are WebGPU's. What has no end is Infinity here, and
 * null in JSON.
 */
export interface Plan {
  /** The split distances of suns, view depths in metres. */
  splits: number[];
  picture: { width: number; height: number };
  camera: { eye: Vec3; forward: Vec3; near: number; far: number; clip_from_world: Mat4 };
  lights: (Light & { first_view: number; view_count: number })[];
  /** The texture that holds the views' tiles, and the sampler that it is compared with. */
  maps: {
    width: number;
    height: number;
    layers: number;
    format: "depth16unorm" | "depth32float";
    compare_sampler: { compare: "greater-equal"; magFilter: "linear" | "nearest"; minFilter: "linear" | "nearest" };
  };
  /** What pipelines that draw casters are set to. Depth is reversed: a tile is cleared to 0, and what is greater is nearer. */
  casters: {
    cull_mode: "none" | "back" | "front";
    depth_compare: "greater-equal";
    depth_clear: number;
    depth_bias: number;
    depth_bias_slope_scale: number;
    unclipped_depth: boolean;
  };
  views: View[];
  /** The bytes of the storage buffer `umbrage_frame`. */
  frame: Uint8Array<ArrayBuffer>;
  /** A sun overhead needs so many texels for each pixel: with these splits, and at the least. */
  storage_factor: number;
  min_storage_factor: number;
  texels: number;
  bytes: number;
}

/** One view of a light, which is drawn into its tile. */
export interface View {
  light: number;
  split: number;
  tile: { layer: number; x: number; y: number; size: number };
  clip_from_world: Mat4;
  texel_metres: number;
  /** Which view depths it serves, metres. */
  depths: [number, number];
  near_metres: number;
  depth_metres: number;
  /** Whether depth is stored as 1 / d, as it is where rays spread from a point. */
  spreads: boolean;
  /** What a warp scales stored depth by, at x and y of NDC, is dot(this, (x, y, 1)). */
  depth_scale: Vec3;
  /** Planes (a, b, c, d) around what may cast into this view: inside, a x + b y + c z + d ≥ 0. Null where nothing may. */
  casters: Vec4[] | null;
}

/** The name of a shader text: see `umbrage wgsl --help`. */
export type Stage =
  | "receiver" | "caster" | "contact" | "map" | "clear" | "peel" | "join"
  | "convert" | "across" | "down" | "halve" | "rows" | "columns";

/** An entry of WebGPU's `createBindGroupLayout`, with the name of the variable in the text. */
export interface LayoutEntry {
  binding: number;
  name: string;
  visibility: number;
  buffer?: { type: "uniform" | "storage" | "read-only-storage"; hasDynamicOffset: boolean };
  texture?: { sampleType: "depth" | "float" | "unfilterable-float" | "uint"; viewDimension: "2d" | "2d-array"; multisampled: boolean };
  storageTexture?: { access: "write-only"; format: string };
  sampler?: { type: "comparison" | "filtering" | "non-filtering" };
}
