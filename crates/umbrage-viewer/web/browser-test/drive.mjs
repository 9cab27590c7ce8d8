// Opens the page as `cargo xtask web` built it, waits for its first picture, and keeps a screenshot:
//   node drive.mjs DIST PICTURES [QUERY]
// Then does the same where the page cannot run, and checks that it says so. Ends with 1 if anything went wrong.

import { cp, mkdir, mkdtemp, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { launch, serve } from "./browser.mjs";

const [dist, pictures, query = ""] = process.argv.slice(2);
if (!pictures) {
  console.error("node drive.mjs DIST PICTURES [QUERY]");
  process.exit(2);
}
await mkdir(pictures, { recursive: true });

/** Runs a check with a page of its own, and keeps its picture; whether it passed. */
async function check(name, folder, options, look) {
  const server = await serve(folder);
  const browser = await launch(options);
  const { page } = browser;
  try {
    await look(page, server.url);
    console.log(`${name}: passed`);
    return true;
  } catch (error) {
    console.error(`${name}: ${error.message}`);
    for (const { kind, text } of page.messages) console.error(`  ${kind}: ${text}`);
    return false;
  } finally {
    await page.screenshot(join(pictures, `${name}.png`)).catch((error) => console.error(error.message));
    await browser.close();
    server.close();
  }
}

/** The page must show an error message that contains `words`. */
async function says(page, words) {
  const message = await page.started().then(() => "nothing is wrong", (error) => error.message);
  if (!message.includes(words)) throw new Error(`\`${words}\` was wanted: ${message}`);
}

/** A check of what a page that cannot run says. */
function refuses(words) {
  return async (page, url) => {
    await page.goto(url);
    await says(page, words);
  };
}

/** A copy of the page with a file of it replaced. */
async function spoiled(file, bytes) {
  const folder = await mkdtemp(join(tmpdir(), "umbrage-dist-"));
  await cp(dist, folder, { recursive: true });
  await writeFile(join(folder, file), bytes);
  return folder;
}

const cut = await spoiled("umbrage-web_bg.wasm", new Uint8Array([0, 0x61, 0x73, 0x6d, 1, 0, 0]));
const passed = [
  await check("page", dist, {}, async (page, url) => {
    await page.goto(url, query);
    console.log(`first picture after ${(await page.started()).toFixed(0)} ms`);
    await page.wait(1000);
    console.log(JSON.stringify(await page.adapter(), null, 1));
    const faults = page.faults();
    if (faults.length > 0) throw new Error(`the page complains: ${faults[0].text}`);
  }),
  await check("stopped", dist, {}, async (page, url) => {
    await page.goto(url, query);
    await page.started();
    await page.tab.evaluate(() => dispatchEvent(new CustomEvent("umbrage-failed", { detail: "a fault for a test" })));
    await says(page, "a fault for a test");
  }),
  await check("without-webgpu", dist, { without: "gpu" }, refuses("has no WebGPU")),
  await check("without-adapter", dist, { without: "adapter" }, refuses("no graphics adapter")),
  await check("cut-short", cut, {}, refuses("could not be loaded")),
];
await rm(cut, { recursive: true });
process.exit(passed.every(Boolean) ? 0 : 1);
