// Builds a BVH beside the page: `src/browser/worker.rs` is the other end. Answers with bytes, or with a message if it fails.

import start, { build_bvh } from "./umbrage-web.js";

onmessage = async ({ data: { module, triangles } }) => {
  try {
    await start({ module_or_path: module });
    const bvh = build_bvh(triangles);
    postMessage(bvh, [bvh.buffer]);
  } catch (error) {
    postMessage(`${error}`);
  }
};
