// The corners of a piece of a volume. A cap is a triangle, turned over since the volume lies behind it, and the same at infinity. A
// side lies between an edge and the same edge at infinity. Under a sun infinity is one point: no far cap, and sides are triangles.
// Where the camera's rays are parallel, volumes end beyond what it sees instead, and a sun's have caps there too.
//
// It needs `shot.wgsl`, `instance.wgsl` and `mesh.wgsl`.

@group(0) @binding(2) var<storage, read> pieces: array<vec2u>;
@group(0) @binding(8) var<storage, read> edges: array<vec4u>;

/// Which vertex of its triangle or edge each corner is.
const OF_CAP = array<u32, 6>(0u, 2u, 1u, 0u, 1u, 2u);
const OF_SIDE = array<u32, 6>(0u, 1u, 1u, 0u, 1u, 0u);
/// Whether it lies where shadows end.
const CAP_IS_FAR = array<u32, 6>(0u, 0u, 0u, 1u, 1u, 1u);
const SIDE_IS_FAR = array<u32, 6>(0u, 0u, 1u, 0u, 1u, 1u);

/// The share of its distance by which a cap lies behind the surface that it is of, or before it.
const ASIDE: f32 = 4e-6;

struct Corner {
    vertex: u32,
    is_far: bool,
}

fn of_cap(instance: u32, triangle: u32, corner: u32, mirrors: bool) -> Corner {
    var caps = OF_CAP;
    var far = CAP_IS_FAR;
    // Another way round.
    let vertex = select(caps[corner], (3u - caps[corner]) % 3u, mirrors);
    return Corner(triangles[3u * (instances[instance].first_triangle + triangle) + vertex], far[corner] == 1u);
}

fn of_side(instance: u32, edge: u32, corner: u32, turned: bool) -> Corner {
    var sides = OF_SIDE;
    var far = SIDE_IS_FAR;
    let its = edges[instances[instance].first_edge + edge];
    let is_second = (sides[corner] == 1u) != turned;
    return Corner(select(its.x, its.y, is_second), far[corner] == 1u);
}

/// Which side of a cap is in shadow should not be chance. From outside a caster one sees a surface that faces away, which is. Where
/// the near plane has opened a caster one sees the inside of such a surface, which is in shadow too, unless the light is inside.
fn aside(instance: u32, triangle: u32) -> f32 {
    let first = 3u * (instances[instance].first_triangle + triangle);
    let base = instances[instance].first_vertex;
    let a = place(base + triangles[first]);
    let normal = cross(place(base + triangles[first + 1u]) - a, place(base + triangles[first + 2u]) - a);
    let eye = instances[instance].eye;
    let is_outside = dot(normal, eye.xyz - a * eye.w) >= 0.0;
    let lies_behind = is_outside || (instances[instance].flags & OPENED) == 0u;
    return select(ASIDE, -ASIDE, lies_behind);
}

/// Where the shadow of a vertex ends: at infinity, or under parallel rays of the camera beyond all that they see.
fn end(instance: u32, near: vec3f) -> vec4f {
    let light = instances[instance].light;
    let is_finite = f32(shot.is_parallel);
    return vec4f(is_finite * near + instances[instance].reach * (near * light.w - light.xyz), is_finite);
}

struct Clip {
    place: vec4f,
    /// The share of its depth by which it lies nearer than its place.
    aside: f32,
}

fn clip(vertex: u32) -> Clip {
    let piece = pieces[vertex / shot.corners];
    let number = vertex % shot.corners;
    let is_side = (piece.y & 1u) == 1u;
    let mirrors = (instances[piece.x].flags & MIRRORS) != 0u;
    var corner: Corner;
    if is_side {
        corner = of_side(piece.x, piece.y >> 2u, number, ((piece.y & 2u) != 0u) != mirrors);
    } else {
        corner = of_cap(piece.x, piece.y >> 1u, number, mirrors);
    }
    let near = place(instances[piece.x].first_vertex + corner.vertex);
    let point = select(vec4f(near, 1.0), end(piece.x, near), corner.is_far);
    var clip = Clip(instances[piece.x].clip_from_mesh * point, 0.0);
    if !is_side && !corner.is_far {
        clip.aside = aside(piece.x, piece.y >> 1u);
    }
    return clip;
}

/// A corner before a perspective camera, whose depth is 0 at infinity.
@vertex
fn volume(@builtin(vertex_index) vertex: u32) -> @builtin(position) @invariant vec4f {
    let clip = clip(vertex);
    return vec4f(clip.place.xy, clip.place.z * (1.0 + clip.aside), clip.place.w);
}

/// Up where a volume ends, down where it begins.
@fragment
fn count(@builtin(front_facing) begins: bool) -> @location(0) f32 {
    return select(1.0, -1.0, begins);
}

/// A corner before parallel rays: in the middle of all depths, so that nothing cuts it off, with its depth beside it.
struct Flattened {
    @builtin(position) @invariant place: vec4f,
    @location(0) @interpolate(linear) depth: f32,
}

@vertex
fn parallel_volume(@builtin(vertex_index) vertex: u32) -> Flattened {
    let clip = clip(vertex);
    return Flattened(vec4f(clip.place.xy, 0.5, 1.0), clip.place.z + clip.aside);
}

struct Counted {
    @location(0) count: f32,
    @builtin(frag_depth) depth: f32,
}

/// The same, where what lies before the nearest depth or beyond the farthest counts as lying there.
@fragment
fn parallel_count(@builtin(front_facing) begins: bool, @location(0) @interpolate(linear) depth: f32) -> Counted {
    return Counted(select(1.0, -1.0, begins), saturate(depth));
}
