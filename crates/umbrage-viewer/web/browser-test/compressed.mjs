// Drops compressed files on the page, which must draw what their original draws, and go on while a worker reads them:
//   node compressed.mjs DIST PICTURES [FILE.glb …]
// Further files are dropped, too: their steps are printed, and how long the page stood still. Ends with 1 if anything went
// wrong. Look at the pictures.

import { mkdir, readFile } from "node:fs/promises";
import { basename, join } from "node:path";
import { PNG } from "pngjs";
import { launch, serve } from "./browser.mjs";

const [dist, pictures, ...others] = process.argv.slice(2);
if (!pictures) {
  console.error("node compressed.mjs DIST PICTURES [FILE.glb …]");
  process.exit(2);
}
await mkdir(pictures, { recursive: true });
const scenes = join(import.meta.dirname, "../../../umbrage-scene/tests/compressed");
const server = await serve(dist);
const browser = await launch({ width: 900, height: 600 });
const { page } = browser;

/** Waits until the dropped world is shown; the steps that the page said meanwhile. */
async function shown(world) {
  const steps = new Set();
  for (const end = Date.now() + 300_000; Date.now() < end; await page.wait(20)) {
    const now = await page.global("umbrage");
    if (now?.loading) steps.add(now.loading);
    if (now?.world === world && now.atRest) return [...steps];
  }
  throw new Error(`${world} did not come, the page says ${JSON.stringify(await page.global("umbrage"))}`);
}

/** The picture of a file, in the middle of the page. */
async function drop(path) {
  const [world, bytes] = [basename(path, ".glb"), await readFile(path)];
  let steps;
  const stood = await page.longestTask(async () => {
    await page.drop(`${world}.glb`, bytes, 500, 300);
    steps = await shown(world);
  });
  await page.wait(600);
  const file = join(pictures, `web-${world}.png`);
  await page.screenshot(file);
  console.log(`  ${world}: stood still for ${stood.toFixed(0)} ms at most; said ${JSON.stringify(steps)}`);
  return PNG.sync.read(await readFile(file));
}

/** The share of pixels that differ by more than half a step of quantisation, seen through the tone map, would explain. */
function differing(a, b) {
  let count = 0;
  for (let i = 0; i < a.data.length; i += 4) {
    if ([0, 1, 2].some((c) => Math.abs(a.data[i + c] - b.data[i + c]) > 12)) count += 1;
  }
  return count / (a.data.length / 4);
}

try {
  await page.goto(server.url, "world=primitives");
  await page.started();
  await shown("primitives");
  const original = await drop(join(scenes, "plain.glb"));
  for (const name of ["draco_edgebreaker", "draco_sequential", "meshopt_high"]) {
    const share = differing(original, await drop(join(scenes, `${name}.glb`)));
    console.log(`  ${(100 * share).toFixed(2)} % of the page differ`);
    // Edges, and the name of the file in the panel.
    if (share > 0.01) throw new Error(`${name} looks different`);
  }
  for (const path of others) await drop(path);
  if (page.faults().length > 0) throw new Error(JSON.stringify(page.faults()));
} catch (error) {
  console.error(error.message);
  process.exitCode = 1;
} finally {
  await browser.close();
  server.close();
}
