// Draws an exported world in three.js or Babylon, and prints what its shadows cost as JSON, as the Bevy peer does:
//   node peers.mjs three|babylon SCENE.glb --cameras CAMERAS.json [--camera N] [--sun X,Y,Z] [--width PX] [--height PX]
//     [--maps N] [--resolution TEXELS] [--frames N] [--batches N] [--pictures DIR]
// Files lie in the repository, which is served to the browser. Ends with 1 if anything went wrong.

import { mkdir, writeFile } from "node:fs/promises";
import { join, relative, resolve } from "node:path";
import { parseArgs } from "node:util";
import { launch, serve } from "umbrage-browser-test/browser.mjs";

const ROOT = resolve(import.meta.dirname, "../../..");
/** A world of millions of triangles is loaded and drawn by a CPU in that time, milliseconds. */
const PATIENCE = 1_200_000;

const text = (otherwise) => ({ type: "string", default: otherwise });
const { positionals: [peer, scene], values } = parseArgs({
  allowPositionals: true,
  options: {
    cameras: text(), camera: text("0"), sun: text(), width: text("640"), height: text("360"), maps: text("4"),
    resolution: text("1024"), frames: text("14"), batches: text("1"), pictures: text(),
  },
});
if (!["three", "babylon"].includes(peer) || !scene || !values.cameras) {
  console.error("node peers.mjs three|babylon SCENE.glb --cameras CAMERAS.json");
  process.exit(2);
}

/** A file as the browser asks for it. */
function served(path) {
  const within = relative(ROOT, resolve(path));
  if (within.startsWith("..")) throw new Error(`only files in the repository are served: ${path}`);
  return `/${within}`;
}

const { pictures, ...question } = values;
const [width, height] = [Number(values.width), Number(values.height)];
const server = await serve(ROOT);
const browser = await launch({ width, height });
try {
  const { page } = browser;
  const asked = { ...question, scene: served(scene), cameras: served(values.cameras) };
  for (const word in asked) if (asked[word] === undefined) delete asked[word];
  await page.goto(`${server.url}bench/peers/web/${peer}.html`, asked);
  const answer = await page.tab.waitForFunction(() => window.answer, null, { timeout: PATIENCE });
  const { failed, ...report } = await answer.jsonValue();
  if (failed) throw new Error([failed, ...page.faults().map(({ text }) => text)].join("\n"));
  for (const [name, shadows, sun] of [["lit", true, 1], ["unshadowed", false, 1], ["ambient", false, 0]]) {
    if (!pictures) break;
    await mkdir(pictures, { recursive: true });
    const png = await page.tab.evaluate(([shadows, sun]) => window.picture(shadows, sun), [shadows, sun]);
    await writeFile(join(pictures, `${name}.png`), Buffer.from(png, "base64"));
  }
  console.log(JSON.stringify(report, null, 2));
} catch (why) {
  console.error(String(why?.stack ?? why));
  process.exitCode = 1;
} finally {
  await browser.close();
  server.close();
}
