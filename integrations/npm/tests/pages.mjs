// Draws the example pages, which stand in a folder with the installed package, in a browser with a software GPU:
//   node pages.mjs FOLDER BROWSER_TEST PICTURES
// BROWSER_TEST is the folder of browser.mjs. Ends with 1 if anything went wrong. Look at the pictures.

import { mkdir } from "node:fs/promises";
import { createRequire } from "node:module";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";

const [folder, browserTest, pictures] = process.argv.slice(2);
if (!pictures) {
  console.error("node pages.mjs FOLDER BROWSER_TEST PICTURES");
  process.exit(2);
}
const { launch, serve } = await import(pathToFileURL(resolve(browserTest, "browser.mjs")));
const { PNG } = createRequire(resolve(browserTest, "browser.mjs"))("pngjs");
await mkdir(pictures, { recursive: true });

const server = await serve(folder);
const browser = await launch({ width: 960, height: 540 });
const { page } = browser;

function check(holds, what) {
  if (!holds) throw new Error(what);
  console.log(`  ${what}`);
}

/** Draws a page, and returns its pixels and what it says of itself. */
async function drawn(name, path, query) {
  const before = page.messages.length;
  await page.goto(`${server.url}${path}/`, query);
  const said = await page.tab.waitForFunction(() => window.drawn, null, { timeout: 120_000 });
  await page.wait(1000);
  const png = PNG.sync.read(await page.tab.screenshot({ path: join(pictures, `${name}.png`) }));
  const faults = page.messages.slice(before).filter(({ kind }) => kind === "error" || kind === "thrown");
  check(faults.length === 0, `${name} is drawn without a fault ${JSON.stringify(faults)}`);
  return { png, ...(await said.jsonValue()) };
}

/** The share of pixels that are darker by 16 or more in the first picture, and of those that are lighter. */
function darker({ png: { data } }, { png: { data: other } }) {
  let [dark, light] = [0, 0];
  for (let i = 0; i < data.length; i += 4) {
    const less = other[i] + other[i + 1] + other[i + 2] - data[i] - data[i + 1] - data[i + 2];
    dark += less > 48;
    light += less < -48;
  }
  return [dark, light].map((count) => (4 * count) / data.length);
}

try {
  const words = (over) => ({ seconds: 3, settings: JSON.stringify(over) });
  const lit = await drawn("webgpu-lit", "webgpu", words({ "shade.darkness": 0 }));
  for (const [name, over] of [["default", {}], ["hard", { "filter.kind": "hard" }], ["soft", { "filter.kind": "pcss", depth: "f32" }], ["depth", { select: "depth", splits: 2 }]]) {
    const [dark, light] = darker(await drawn(`webgpu-${name}`, "webgpu", words(over)), lit);
    check(dark > 0.04 && dark < 0.4 && light === 0, `${name}: shadows lie on ${(100 * dark).toFixed(1)} % of the picture, and nothing is lighter`);
  }
  const planned = await drawn("three", "three", { seconds: 3 });
  const unshadowed = await drawn("three-off", "three", { seconds: 3, off: "" });
  const stock = await drawn("three-stock", "three", { seconds: 3, stock: "" });
  const text = (texels) => texels.map((metres) => metres.toFixed(3)).join(", ");
  check(planned.texelMetres[0] < stock.texelMetres[0], `three.js: texels of ${text(planned.texelMetres)} m, and by its own cascades ${text(stock.texelMetres)} m`);
  for (const [name, picture] of [["planned", planned], ["stock", stock]]) {
    const [dark] = darker(picture, unshadowed);
    check(dark > 0.04 && dark < 0.4, `${name} cascades: shadows lie on ${(100 * dark).toFixed(1)} % of the picture`);
  }
  const [dark, light] = darker(planned, stock);
  check(dark < 0.03 && light < 0.03, `and the same shadows: ${(100 * dark).toFixed(1)} % are darker, ${(100 * light).toFixed(1)} % lighter`);
} finally {
  await browser.close();
  server.close();
}
