// Asks the page for rays where maps are not sure: the error against maps alone, how long the page is blocked while a worker builds
// what rays go through, and what a frame costs the device beside one of maps alone:
//   node rays.mjs DIST PICTURES [error] [worker] [time]
// Ends with 1 if anything went wrong. Look at the pictures.

import { mkdir } from "node:fs/promises";
import { join } from "node:path";
import { launch, serve } from "./browser.mjs";

const [dist, pictures, ...wanted] = process.argv.slice(2);
if (!pictures) {
  console.error("node rays.mjs DIST PICTURES [error] [worker] [time]");
  process.exit(2);
}
await mkdir(pictures, { recursive: true });
const server = await serve(dist);
const browser = await launch({ width: 1000, height: 600 });
const { page } = browser;

function check(holds, what) {
  if (!holds) throw new Error(what);
  console.log(`  ${what}`);
}

// How long each submission takes until the device has done it, and the longest task of the page, milliseconds.
await page.tab.context().addInitScript(() => {
  window.submitted = [];
  window.pending = 0;
  window.longest = 0;
  new PerformanceObserver((list) => {
    for (const { duration } of list.getEntries()) window.longest = Math.max(window.longest, duration);
  }).observe({ type: "longtask", buffered: true });
  if (!window.GPUQueue) return;
  const submit = GPUQueue.prototype.submit;
  GPUQueue.prototype.submit = function (...buffers) {
    submit.apply(this, buffers);
    const start = performance.now();
    window.pending++;
    this.onSubmittedWorkDone().then(() => {
      window.pending--;
      window.submitted.push({ start, end: performance.now() });
    });
  };
});

const until = (what, holds, timeout = 300_000) => page.until(what, holds, timeout);

/** Opens a world with some settings; `truth` says whether pixels are compared with rays traced on the processor. */
async function open(world, settings, truth) {
  await page.tab.goto("about:blank");
  await page.tab.goto(`${server.url}?world=${world}&${settings}${truth ? "&truth" : ""}&probe`);
  const now = await until(`${world} with ${settings}`, (now) => now.world === world && now.atRest && (!truth || now.judged > 10_000));
  if (now.messages.length > 0) throw new Error(`${world} with ${settings}: ${now.messages}`);
  return now;
}

const [MAPS, UNDECIDED, ALWAYS] = ["preset=default", "preset=exact", "set=exact=always"];

async function error() {
  for (const world of ["robot-war", "grove"]) {
    const found = [];
    for (const settings of [MAPS, UNDECIDED, ALWAYS]) {
      found.push((await open(world, settings, true)).misShadowed);
      await page.wait(800);
      await page.screenshot(join(pictures, `rays-${world}-${settings.replaceAll("=", "-")}.png`));
    }
    // A browser's rasteriser may round corners more than the judge allows for; what rays alone leave wrong is that.
    const [maps, undecided, always] = found;
    const text = found.map((share) => `${(100 * share).toFixed(3)} %`);
    check(undecided - always < 0.25 * (maps - always),
      `${world}: ${text[0]} of the pixels are wrong by maps, ${text[1]} with rays where they are not sure, ${text[2]} with rays alone`);
  }
}

async function worker() {
  const longest = [];
  for (const settings of [MAPS, UNDECIDED]) {
    await open("mining-terrain", settings, false);
    await page.wait(500); // tasks are reported when they are over
    longest.push((await page.global("longest")).toFixed(0));
  }
  const [maps, rays] = longest;
  console.log(`  a million triangles: the longest task of the page is ${maps} ms with maps alone, ${rays} ms until rays answer`);
}

/** The milliseconds that the device needs for a frame while the camera turns: the median of 24. */
async function frame(world, settings) {
  await open(world, settings, false);
  const { widgets } = await page.global("umbrage");
  const [left, top, right, bottom] = widgets["the picture"];
  const [x, y] = [(left + right) / 2, (top + bottom) / 2];
  await page.move(x, y);
  await page.tab.mouse.down();
  const idle = () => page.tab.waitForFunction(() => window.pending === 0, null, { polling: 10 });
  const times = [];
  for (let step = 1; step <= 24; step++) {
    await idle();
    await page.tab.evaluate(() => (window.submitted = []));
    await page.tab.mouse.move(x + 2 * step, y);
    await page.wait(60);
    await idle();
    const done = await page.tab.evaluate(() => window.submitted);
    if (done.length > 0) times.push(Math.max(...done.map(({ end }) => end)) - Math.min(...done.map(({ start }) => start)));
  }
  await page.tab.mouse.up();
  times.sort((a, b) => a - b);
  return times[Math.floor(times.length / 2)];
}

async function time() {
  for (const world of ["robot-war", "mining-terrain", "grove"]) {
    const ratios = [];
    for (let round = 0; round < 3; round++) ratios.push((await frame(world, UNDECIDED)) / (await frame(world, MAPS)));
    ratios.sort((a, b) => a - b);
    console.log(`  ${world}: a frame with rays takes ${ratios[1].toFixed(2)} times (${ratios[0].toFixed(2)} to ${ratios[2].toFixed(2)}) as long as with maps alone`);
  }
}

let failed = false;
for (const part of [error, worker, time].filter(({ name }) => wanted.length === 0 || wanted.includes(name))) {
  console.log(part.name);
  try {
    await part();
  } catch (fault) {
    failed = true;
    console.error(`  ${fault.stack ?? fault}`);
    await page.screenshot(join(pictures, `failed-${part.name}.png`)).catch(() => {});
  }
}
await browser.close();
server.close();
process.exit(failed ? 1 : 0);
