// How many workgroups trace what is left to rays, for an indirect dispatch.

@group(0) @binding(0) var<storage, read> umbrage_left_count: array<u32>;
@group(0) @binding(1) var<storage, read_write> umbrage_workgroups: array<u32, 3>;

/// In rows, since a dispatch has no more than 65535 along a side.
const UMBRAGE_ROW: u32 = 1024u;

@compute @workgroup_size(1)
fn count() {
    let groups = (umbrage_left_count[0] + 63u) / 64u;
    umbrage_workgroups[0] = min(groups, UMBRAGE_ROW);
    umbrage_workgroups[1] = (groups + UMBRAGE_ROW - 1u) / UMBRAGE_ROW;
    umbrage_workgroups[2] = 1u;
}
