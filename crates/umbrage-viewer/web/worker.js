// Sorts triangles beside the page: `src/web/worker.rs` is the other end. Answers with bytes, or with words if it fails.

import start, { sort } from "./umbrage-web.js";

onmessage = async ({ data: { module, triangles } }) => {
  try {
    await start({ module_or_path: module });
    const world = sort(triangles);
    postMessage(world, [world.buffer]);
  } catch (error) {
    postMessage(`${error}`);
  }
};
