// Uses the page as a person would, and compares its shadows with those of the native program:
//   node viewer.mjs DIST PICTURES UMBRAGE
// UMBRAGE is the command, as target/release/umbrage. Ends with 1 if anything went wrong. Look at the pictures.

import { execFileSync } from "node:child_process";
import { mkdir, mkdtemp, readFile, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { PNG } from "pngjs";
import { launch, serve } from "./browser.mjs";

const [dist, pictures, umbrage] = process.argv.slice(2);
if (!umbrage) {
  console.error("node viewer.mjs DIST PICTURES UMBRAGE");
  process.exit(2);
}
await mkdir(pictures, { recursive: true });
const scratch = await mkdtemp(join(tmpdir(), "umbrage-viewer-"));
const server = await serve(dist);
const browser = await launch({ width: 1180, height: 760 });
const { page } = browser;

function check(holds, what) {
  if (!holds) throw new Error(what);
  console.log(`  ${what}`);
}

/** The state that the page publishes (`publish` in web.rs). */
const state = () => page.global("umbrage");

const until = (what, holds, timeout = 120_000) => page.until(what, holds, timeout);

async function widget(name) {
  const found = (await until(`the widget ${name}`, (now) => now.widgets[name], 10_000)).widgets[name];
  const [left, top, right, bottom] = found;
  return { left, top, right, bottom, x: (left + right) / 2, y: (top + bottom) / 2 };
}

async function click(name) {
  const { x, y } = await widget(name);
  await page.click(x, y);
}

/** Saves a screenshot, and returns the picture in it, without panels. */
async function look(name) {
  await page.wait(600);
  const path = join(pictures, `${name}.png`);
  await page.screenshot(path);
  const all = PNG.sync.read(await readFile(path));
  const { left, top, right, bottom } = await widget("the picture");
  const [width, height] = [Math.round(right - left), Math.round(bottom - top)];
  const picture = new PNG({ width, height });
  PNG.bitblt(all, picture, Math.round(left), Math.round(top), width, height, 0, 0);
  return picture;
}

/** How many pixels differ by more than the noise of eight bits. */
function differing(a, b) {
  let count = 0;
  for (let i = 0; i < a.data.length; i += 4) {
    if ([0, 1, 2].some((c) => Math.abs(a.data[i + c] - b.data[i + c]) > 6)) count += 1;
  }
  return count;
}

/** How many pixels of `a` match no pixel within `reach` in `b`, and so do not differ by the place of an edge alone. */
function unmatched(a, b, reach) {
  const { width, height } = a;
  let count = 0;
  for (let y = reach; y < height - reach; y++) {
    for (let x = reach; x < width - reach; x++) {
      const at = 4 * (y * width + x);
      const isNear = [0, 1, 2].every((c) => {
        let [low, high] = [255, 0];
        for (let dy = -reach; dy <= reach; dy++) {
          for (let dx = -reach; dx <= reach; dx++) {
            const value = b.data[4 * ((y + dy) * width + x + dx) + c];
            [low, high] = [Math.min(low, value), Math.max(high, value)];
          }
        }
        return a.data[at + c] >= low - 6 && a.data[at + c] <= high + 6;
      });
      if (!isNear) count += 1;
    }
  }
  return count;
}

/** Compares a world's first picture with the native program's. */
async function world() {
  const start = Date.now();
  await page.goto(server.url, { world: "primitives", probe: "1" });
  await until("the world", (now) => now.world === "primitives" && now.atRest);
  console.log(`  shown after ${((Date.now() - start) / 1e3).toFixed(1)} s`);
  const first = await look("web-primitives");
  const file = join(pictures, "native-primitives.png");
  // One point of the light is the light, and one sample a pixel: what the page draws on a software GPU.
  const size = `${first.width}x${first.height}`;
  execFileSync(umbrage, ["render", "primitives", "--area-samples", "1", "--size", size, "-o", file]);
  const native = PNG.sync.read(await readFile(file));
  const [apart, total] = [differing(first, native), first.width * first.height];
  const odd = unmatched(first, native, 1);
  console.log(`  ${apart} of ${total} pixels differ from the native picture; ${odd} are like none within a pixel there`);
  check(apart < 0.01 * total, "the picture is the native one but for a hundredth of its pixels");
  check(odd < 1e-4 * total, "and those are at edges, off by a pixel at most");
  return first;
}

async function slider(first) {
  const slider = await widget("λ");
  await page.drag([slider.left + 0.76 * (slider.right - slider.left), slider.y], [slider.left + 4, slider.y]);
  const moved = await until("another λ", (now) => !now.settings.includes("lambda = 0.8\n") && now.atRest, 20_000);
  console.log(`  ${moved.settings.match(/lambda = .*/)[0]}`);
  check(differing(first, await look("web-lambda")) > 20, "the picture changes");
  await click("reset");
  await until("the default", (now) => now.settings.includes("lambda = 0.8\n"));
  check(differing(first, await look("web-reset")) === 0, "and is as it was when it is reset");
}

async function fingers(first) {
  const { left, top, right, bottom } = await widget("the picture");
  const at = (x, y) => [left + x * (right - left), top + y * (bottom - top)];
  const path = (from, to) => Array.from({ length: 9 }, (_, i) => from.map((place, axis) => place + ((to[axis] - place) * i) / 8));
  await page.touch(path(at(0.5, 0.5), at(0.6, 0.5)));
  const turned = await look("web-turned");
  check(differing(first, turned) > 0.1 * first.width * first.height, "one finger looks around");
  await page.touch(path(at(0.42, 0.5), at(0.34, 0.5)), path(at(0.58, 0.5), at(0.66, 0.5)));
  const nearer = await look("web-nearer");
  check(differing(turned, nearer) > 0.1 * first.width * first.height, "two go nearer");
  await page.press("1");
  check(differing(first, await look("web-camera-1")) === 0, "and a key brings the world's camera back");
}

/** A phone held upright: the panels are below the picture. */
async function narrow(first) {
  await page.resize(390, 844);
  await page.wait(1000);
  const { width, height } = await look("web-narrow");
  check(width > 380 && height > 350, `on a page of 390 x 844 the picture has ${width} x ${height}`);
  await page.resize(1180, 760);
  await page.wait(1000);
  check(differing(first, await look("web-wide")) === 0, "and is as it was on a wide one");
}

async function truth() {
  await click("show errors");
  const judged = await until("the truth", (now) => now.judged > 10_000 && now.atRest);
  await look("web-truth");
  console.log(`  ${judged.judged} pixels judged, ${(100 * judged.misShadowed).toFixed(3)} % mis-shadowed`);
  check(judged.misShadowed < 0.02, "less than 2 % is wrong");
  await click("show errors");
}

async function lostDevice(first) {
  await page.loseDevice();
  const back = await until("another device", (now) => now.messages.some((message) => message.includes("was lost")) && now.atRest);
  check(back.world === "primitives", `the page goes on: ${back.messages.at(-1)}`);
  await look("web-lost");
  await click("close");
  check(differing(first, await look("web-another-device")) === 0, "and shows what it showed");
}

async function files() {
  const glb = join(scratch, "stranger.glb");
  execFileSync(umbrage, ["worlds", "export", "bunny", glb]);
  await page.drop("stranger.glb", await readFile(glb), 500, 400);
  await until("the dropped world", (now) => now.world === "stranger" && now.atRest);
  await look("web-dropped");
  check(true, "a .glb is shown");
  await page.drop("no-scene.glb", Buffer.from("glTF, it says"), 500, 400);
  const refused = await until("a refusal", (now) => now.messages.length > 0);
  check(refused.world === "stranger", `what is none is refused, and the world stays: ${refused.messages[0]}`);
  await page.drop("newer.toml", Buffer.from("[shadows]\nvirtual_pages = 4096\n"), 500, 400);
  await until("another refusal", (now) => now.messages.some((message) => message.includes("virtual_pages")));
  await look("web-refused");
  check(true, "settings of a newer version are refused by their key");
  const other = join(scratch, "chosen.glb");
  execFileSync(umbrage, ["worlds", "export", "primitives", other]);
  await click("World");
  await click("Open a file…");
  await page.tab.locator("input[type=file]").setInputFiles(other);
  await until("the chosen world", (now) => now.world === "chosen" && now.atRest);
  await look("web-chosen");
  check(true, "a file that is chosen in a dialog is shown");
}

async function background() {
  const other = await page.tab.context().newPage();
  await other.goto("about:blank");
  await page.wait(3000);
  await other.close();
  await page.tab.bringToFront();
  await until("the page again", (now) => now.world === "chosen" && now.atRest);
  await look("web-back");
}

/** A BVH of more than a million triangles, built beside the page, or by it where the browser starts no worker. */
async function large() {
  const blocked = {};
  for (const builder of ["a worker", "the page"]) {
    const start = Date.now();
    await page.goto(server.url, { probe: "1" });
    await until("the world", (now) => now.world === "mining-terrain" && now.atRest, 300_000);
    console.log(`  shown after ${((Date.now() - start) / 1e3).toFixed(1)} s, on a software GPU`);
    await look("web-mining-terrain");
    if (builder === "the page") await page.tab.evaluate(() => delete window.Worker);
    blocked[builder] = await page.longestTask(async () => {
      await click("show errors");
      await until("some truth", (now) => now.judged > 1000, 300_000);
    });
    console.log(`  blocked for ${blocked[builder].toFixed(0)} ms at most while ${builder} builds the BVH`);
    const rest = await page.longestTask(() => until("all of it", (now) => now.judged > 10_000 && now.atRest, 300_000));
    console.log(`  and for ${rest.toFixed(0)} ms at most while rays are traced and edges measured`);
    await look("web-mining-terrain-truth");
  }
  check(blocked["a worker"] < 0.5 * blocked["the page"], "a worker leaves the page free");
}

async function main() {
  console.log("a world, and its shadows");
  const first = await world();
  console.log("a slider");
  await slider(first);
  console.log("fingers");
  await fingers(first);
  console.log("a narrow page");
  await narrow(first);
  console.log("ground truth");
  await truth();
  console.log("a lost device");
  await lostDevice(first);
  console.log("files");
  await files();
  console.log("a tab in the background");
  await background();
  console.log("the default world");
  await large();
  const faults = page.faults();
  check(faults.length === 0, `the page does not complain${faults.length ? `: ${faults[0].text}` : ""}`);
}

let status = 0;
try {
  await main();
} catch (error) {
  status = 1;
  console.error(error.message);
  for (const { kind, text } of page.messages.slice(-20)) console.error(`  ${kind}: ${text}`);
  await page.screenshot(join(pictures, "web-failed.png")).catch(() => {});
} finally {
  await browser.close();
  server.close();
  await rm(scratch, { recursive: true, force: true });
}
process.exit(status);
