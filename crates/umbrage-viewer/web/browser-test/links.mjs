// Opens links in the page, which is served in a folder below another, as many static hosts do:
//   node links.mjs DIST PICTURES
// Ends with 1 if anything went wrong. Look at the pictures.

import { cp, mkdir, mkdtemp, rm, writeFile } from "node:fs/promises";
import { createServer } from "node:http";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { launch, serve } from "./browser.mjs";

const [dist, pictures] = process.argv.slice(2);
if (!pictures) {
  console.error("node links.mjs DIST PICTURES");
  process.exit(2);
}
await mkdir(pictures, { recursive: true });
const root = await mkdtemp(join(tmpdir(), "umbrage-links-"));
const folder = join(root, "shadows", "of", "large worlds");
await cp(dist, folder, { recursive: true });

/** A triangle of 4 m, 1 m above the origin, as a glTF file that needs nothing beside it. */
const model = (() => {
  const corners = Buffer.alloc(36);
  [-2, 1, -2, -2, 1, 2, 2, 1, 2].forEach((metres, i) => corners.writeFloatLE(metres, 4 * i));
  return JSON.stringify({
    asset: { version: "2.0" },
    buffers: [{ byteLength: 36, uri: `data:application/octet-stream;base64,${corners.toString("base64")}` }],
    bufferViews: [{ buffer: 0, byteLength: 36 }],
    accessors: [
      { bufferView: 0, componentType: 5126, count: 3, type: "VEC3", min: [-2, 1, -2], max: [2, 1, 2] },
    ],
    meshes: [{ primitives: [{ attributes: { POSITION: 0 } }] }],
    nodes: [{ mesh: 0 }],
    scenes: [{ nodes: [0] }],
    scene: 0,
  });
})();
await writeFile(join(folder, "triangle.gltf"), model);
await writeFile(join(folder, "words.html"), "<!doctype html><p>no model");

/** Another server, which lets no page read its files, or all of them below /open/. */
const elsewhere = createServer((request, response) => {
  const headers = request.url.startsWith("/open/") ? { "Access-Control-Allow-Origin": "*" } : {};
  response.writeHead(200, headers).end(model);
});
await new Promise((listening) => elsewhere.listen(0, "127.0.0.1", listening));
const other = `http://127.0.0.1:${elsewhere.address().port}`;

const server = await serve(root);
const address = `${server.url}shadows/of/large%20worlds/`;
const browser = await launch({ width: 1180, height: 760 });
const { page } = browser;
const requests = [];
page.tab.on("request", (request) => requests.push(request.url()));

function check(holds, what) {
  if (!holds) throw new Error(what);
  console.log(`  ${what}`);
}

const state = () => page.global("umbrage");

const until = (what, holds, timeout = 180_000) => page.until(what, holds, timeout);

/** Opens the page anew with a query as it stands, and waits until a world is there and at rest. */
async function open(query, world) {
  await page.tab.goto("about:blank");
  await page.tab.goto(`${address}?${query}&probe`);
  return until(`the world ${world}`, (now) => now.world === world && now.atRest);
}

async function look(name) {
  await page.wait(800);
  await page.screenshot(join(pictures, `${name}.png`));
}

async function middle(name) {
  const now = await until(`the widget ${name}`, (now) => now.widgets[name], 20_000);
  const [left, top, right, bottom] = now.widgets[name];
  return { left, top, right, bottom, x: (left + right) / 2, y: (top + bottom) / 2 };
}

async function click(name) {
  const { x, y } = await middle(name);
  await page.click(x, y);
}

async function link() {
  const query = "world=primitives&eye=6,5,14&target=0,1,0&set=filter.kind=pcf&set=splits=2&right.preset=default&show=splits";
  const now = await open(query, "primitives");
  check(now.messages.length === 0, "a link opens without a message");
  check(/splits = 2/.test(now.settings) && /kind = "pcf"/.test(now.settings), "with its settings");
  await look("link");
  await page.tab.context().grantPermissions(["clipboard-read", "clipboard-write"], { origin: new URL(address).origin });
  await click("Copy link");
  await page.wait(500);
  const copied = await page.tab.evaluate(() => navigator.clipboard.readText());
  check(copied === `${address}?${query}`, `and the button copies the same: ${copied}`);
  const outside = requests.filter((url) => url.startsWith("http") && !url.startsWith(address));
  check(outside.length === 0, "all that the page asks for lies in its own folder");
}

async function wrong() {
  const now = await open("world=primitives&set=splits=0&colour=red&set=lambda=0.25", "primitives");
  check(now.messages.length === 2, "what is wrong with a link is two messages");
  check(/lambda = 0\.25/.test(now.settings), "and the rest of it holds");
  await look("link-wrong");
}

async function lesson() {
  await open("world=primitives", "primitives");
  await click("Lessons");
  await click("5 Bias");
  await until("the lesson's world", (now) => now.world === "bias-court" && now.atRest);
  check((await state()).messages.length === 0, "a lesson opens from the menu");
  await look("lesson");
}

async function pick() {
  await open("world=primitives&set=splits=1&set=resolution=256&set=filter.kind=hard&truth", "primitives");
  const { left, right, top, bottom } = await middle("the picture");
  await page.press("i");
  await page.click(left + 0.5 * (right - left), top + 0.72 * (bottom - top));
  const now = await until("an answer", (now) => now.why, 60_000);
  check(/\./.test(now.why), `a pixel says why: ${now.why}`);
  await look("why");
}

async function load() {
  let now = await open("load=triangle.gltf", "triangle");
  check(now.messages.every((message) => !message.includes("load=")), "a file beside the page opens by its address");
  await look("load");
  now = await open(`load=${other}/open/a.gltf`, "a");
  check(now.world === "a", "and one of a server that allows it");
  for (const [query, wanted] of [
    [`load=${other}/closed/a.gltf`, "Access-Control-Allow-Origin"],
    ["load=nowhere.glb", "404"],
    ["load=words.html", "no .glb, .gltf or .obj"],
  ]) {
    await page.tab.goto("about:blank");
    await page.tab.goto(`${address}?${query}&set=splits=2&probe`);
    now = await until("the default world", (now) => now.world && now.atRest, 300_000);
    const message = now.messages.find((message) => message.includes(wanted));
    check(message?.includes(query), `${message}`);
    check(/splits = 2/.test(now.settings), "and the rest of the link holds");
  }
  await look("load-refused");
}

let failed = false;
for (const part of [link, wrong, lesson, pick, load]) {
  console.log(part.name);
  try {
    await part();
  } catch (error) {
    failed = true;
    console.error(`  ${error.stack ?? error}`);
    await page.screenshot(join(pictures, `failed-${part.name}.png`)).catch(() => {});
  }
}
await browser.close();
server.close();
elsewhere.close();
await rm(root, { recursive: true, force: true });
process.exit(failed ? 1 : 0);
