// Works beside the page: `src/browser/worker.rs` is the other end. Posts steps on the way, and then bytes, or words if it
// fails.

import start, * as program from "./umbrage-web.js";

onmessage = async ({ data: { module, job, name, bytes } }) => {
  try {
    await start({ module_or_path: module });
    const answer = program[job](name, bytes, (step) => postMessage({ step }));
    postMessage({ answer }, [answer.buffer]);
  } catch (error) {
    postMessage({ answer: `${error}` });
  }
};
