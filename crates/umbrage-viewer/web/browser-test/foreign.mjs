// Opens the page that draws with `umbrage wgsl` and `umbrage plan --json` alone, and compares its shadows with those that
// Umbrage draws itself; keeps a screenshot:
//   node foreign.mjs UMBRAGE PICTURES
// UMBRAGE is the command. Ends with 1 if anything went wrong.

import { execFileSync } from "node:child_process";
import { cp, mkdir, mkdtemp, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { launch, serve } from "./browser.mjs";

const [umbrage, pictures] = process.argv.slice(2);
if (!pictures) {
  console.error("node foreign.mjs UMBRAGE PICTURES");
  process.exit(2);
}
await mkdir(pictures, { recursive: true });

const SIZE = { width: 1280, height: 720 };
const example = resolve(import.meta.dirname, "../../../../examples/webgpu-page");
const folder = await mkdtemp(join(tmpdir(), "umbrage-foreign-"));
await cp(example, folder, { recursive: true });
const command = resolve(umbrage);
execFileSync(join(folder, "make"), { env: { ...process.env, UMBRAGE: command }, stdio: "inherit" });
// The same frame by Umbrage: what `make` gives to `umbrage plan`.
const camera = ["--eye=-14,8,12", "--target=1,1.5,-6", "--fov", "50", "--near", "0.2", "--far", "200",
  "--sun=0.6,-0.7,-0.45", "--size", "1280x720"];
const own = ["--set", "unclipped_depth=false", "--visibility", join(folder, "visibility.png")];
execFileSync(command, ["render", join(folder, "scene.obj"), ...camera, ...own], { stdio: "inherit" });

/** Runs in the page. Of the pixels that Umbrage has in shadow, and of those in light: the shares that the page has in shadow. */
async function compare(screenshot) {
  const pixels = async (url) => {
    const bitmap = await createImageBitmap(await (await fetch(url)).blob());
    const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext("2d");
    context.drawImage(bitmap, 0, 0);
    return context.getImageData(0, 0, bitmap.width, bitmap.height).data;
  };
  const [visibility, shown] = [await pixels("visibility.png"), await pixels(screenshot)];
  const ambient = [0.16, 0.19, 0.25].map((c) => 255 * c ** (1 / 2.2));
  const counts = { 0: [0, 0], 255: [0, 0] };
  for (let i = 0; i < visibility.length; i += 4) {
    const count = counts[visibility[i]];
    if (!count) continue;
    count[0]++;
    if (ambient.every((c, k) => Math.abs(shown[i + k] - c) < 3)) count[1]++;
  }
  return { shadowed: counts[0][1] / counts[0][0], lit: counts[255][1] / counts[255][0], of: counts[0][0] };
}

const server = await serve(folder);
const browser = await launch(SIZE);
const { page } = browser;
let failed = true;
try {
  await page.goto(server.url);
  await page.tab.waitForFunction(
    () => document.body.dataset.drawn || document.querySelector("#message").textContent, null, { timeout: 60_000 });
  const message = await page.tab.evaluate(() => document.querySelector("#message").textContent);
  if (message) throw new Error(message);
  await page.wait(500); // until it is on the screen
  const file = join(pictures, "foreign.png");
  await page.screenshot(file);
  await cp(file, join(folder, "screenshot.png"));
  const { shadowed, lit, of } = await page.tab.evaluate(compare, "screenshot.png");
  const percent = (share) => `${(100 * share).toFixed(2)} %`;
  console.log(`of ${of} pixels in shadow the page has ${percent(shadowed)} so, of those in light ${percent(lit)}`);
  if (of < 10_000 || shadowed < 0.99 || lit > 0.01) throw new Error("these are not Umbrage's shadows");
  if (page.faults().length > 0) throw new Error("the console speaks of faults");
  failed = false;
} catch (error) {
  console.error(error.message);
  for (const { kind, text } of page.messages) console.error(`  ${kind}: ${text}`);
} finally {
  await browser.close();
  server.close();
  await rm(folder, { recursive: true, force: true });
}
process.exit(failed ? 1 : 0);
