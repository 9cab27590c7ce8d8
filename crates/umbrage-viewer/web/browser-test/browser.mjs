// A browser with a software GPU, and functions to use a page as a person would.
//
// egui draws its own widgets, so there is nothing in the document to click on: positions are in CSS pixels, and come
// from what the page says of itself (`Page.global`).

import { spawn } from "node:child_process";
import { createReadStream } from "node:fs";
import { access, mkdtemp, rm, stat } from "node:fs/promises";
import { createServer } from "node:http";
import { tmpdir } from "node:os";
import { delimiter, extname, join, normalize } from "node:path";
import { chromium } from "playwright-core";

const TYPES = { ".html": "text/html; charset=utf-8", ".js": "text/javascript", ".wasm": "application/wasm" };

// WebGPU by SwiftShader, which shows nothing headless: presenting to a canvas loses the device there.
const GPU = [
  "--enable-unsafe-webgpu",
  "--use-webgpu-adapter=swiftshader",
  "--use-vulkan=swiftshader",
  "--enable-features=Vulkan",
  "--ignore-gpu-blocklist",
];
const QUIET = [
  "--no-sandbox", // refused to root otherwise
  "--disable-quic",
  "--no-first-run",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
];

/** Serves a folder on a free port of this machine. */
export async function serve(folder) {
  const server = createServer(async (request, response) => {
    const path = normalize(decodeURIComponent(new URL(request.url, "http://localhost").pathname));
    const file = join(folder, path.endsWith("/") ? `${path}index.html` : path);
    const found = await stat(file).catch(() => null);
    if (!found?.isFile()) return response.writeHead(404).end("not found");
    response.writeHead(200, {
      "Content-Type": TYPES[extname(file)] ?? "application/octet-stream",
      "Content-Length": found.size,
    });
    createReadStream(file).pipe(response);
  });
  await new Promise((listening) => server.listen(0, "127.0.0.1", listening));
  return {
    url: `http://127.0.0.1:${server.address().port}/`,
    close() {
      server.closeAllConnections();
      server.close();
    },
  };
}

/** A screen without a monitor, on a free number. */
async function screen(width, height) {
  const xvfb = spawn("Xvfb", ["-displayfd", "3", "-screen", "0", `${width}x${height}x24`, "-nolisten", "tcp"], {
    stdio: ["ignore", "ignore", "ignore", "pipe"],
  });
  const number = await new Promise((found, failed) => {
    xvfb.once("error", (why) => failed(new Error(`Xvfb does not start; install xvfb (${why.message})`)));
    xvfb.once("exit", (status) => failed(new Error(`Xvfb ended with ${status}`)));
    xvfb.stdio[3].once("data", (data) => found(String(data).trim()));
  });
  return { display: `:${number}`, close: () => xvfb.kill() };
}

async function installed(names) {
  for (const name of names) {
    for (const folder of process.env.PATH.split(delimiter)) {
      const path = join(folder, name);
      if (await access(path).then(() => true, () => false)) return path;
    }
  }
  throw new Error(`none of ${names.join(", ")} is installed; set UMBRAGE_BROWSER to a Chromium`);
}

/**
 * Starts a browser with a new profile, on a screen of its own.
 * Options: width and height of the page; without: "gpu" for a browser that knows no WebGPU, "adapter" for one that finds
 * no adapter.
 */
export async function launch({ width = 1280, height = 720, without } = {}) {
  const executablePath =
    process.env.UMBRAGE_BROWSER ?? (await installed(["chromium", "chromium-browser", "google-chrome"]));
  const { display, close } = await screen(width + 100, height + 200);
  const profile = await mkdtemp(join(tmpdir(), "umbrage-browser-"));
  const context = await chromium.launchPersistentContext(profile, {
    executablePath,
    headless: false,
    viewport: { width, height },
    args: [...GPU, ...QUIET],
    env: { ...process.env, DISPLAY: display },
  });
  // Before anything of a page runs, so that no event is missed.
  await context.addInitScript((without) => {
    if (without === "gpu") Object.defineProperty(Navigator.prototype, "gpu", { value: undefined });
    if (without === "adapter") GPU.prototype.requestAdapter = async () => null;
    addEventListener("umbrage-started", () =>
      requestAnimationFrame(() => requestAnimationFrame(() => (window.umbrageShown = performance.now()))));
    if (!window.GPUAdapter) return;
    // The devices that the page was given, for those who take them away.
    window.devices = [];
    const requestDevice = GPUAdapter.prototype.requestDevice;
    GPUAdapter.prototype.requestDevice = async function (...wanted) {
      const device = await requestDevice.apply(this, wanted);
      window.devices.push(device);
      return device;
    };
  }, without);
  return {
    /** The browser's tab. */
    page: new Page(context.pages()[0]),
    async close() {
      await context.close();
      close();
      await rm(profile, { recursive: true, force: true });
    },
  };
}

/** A tab with the page in it. `tab` is Playwright's own, for what is not here. */
export class Page {
  /** What the console said and what was thrown, in order: { kind, text }. */
  messages = [];

  constructor(tab) {
    this.tab = tab;
    tab.on("console", (message) => this.messages.push({ kind: message.type(), text: message.text() }));
    tab.on("pageerror", (error) => this.messages.push({ kind: "thrown", text: error.stack ?? String(error) }));
    tab.on("crash", () => this.messages.push({ kind: "thrown", text: "the tab crashed" }));
  }

  /** Opens the page; `query` is an object, or text after the question mark. */
  async goto(url, query = "") {
    const address = new URL(url);
    address.search = new URLSearchParams(query).toString();
    await this.tab.goto(address.href);
  }

  /** Waits until the program has shown its first picture; the milliseconds that took. Throws what the page says if it fails. */
  async started(timeout = 120_000) {
    const outcome = await this.tab.waitForFunction(
      () => {
        const failure = document.getElementById("failure");
        if (failure && !failure.hidden) return { failure: failure.innerText };
        return window.umbrageShown && { milliseconds: window.umbrageShown };
      },
      null,
      { timeout },
    );
    const { failure, milliseconds } = await outcome.jsonValue();
    if (failure) throw new Error(`the page failed: ${failure}`);
    return milliseconds;
  }

  /** A global of the page, or what it returns if it is a function. Undefined where there is none. */
  global(name, ...args) {
    return this.tab.evaluate(([name, args]) => {
      const value = window[name];
      return typeof value === "function" ? value(...args) : value;
    }, [name, args]);
  }

  /** Waits until what the viewer publishes of itself (`publish` in web.rs) fulfils a condition, and returns it. */
  async until(what, holds, timeout) {
    const end = Date.now() + timeout;
    for (;;) {
      const now = await this.global("umbrage");
      if (now && holds(now)) return now;
      if (Date.now() > end) throw new Error(`${what} did not come: ${JSON.stringify({ ...now, widgets: undefined })}`);
      await this.wait(100);
    }
  }

  /** Presses keys one after the other, as Playwright names them: "w", "Escape", "Control+c". */
  async press(...keys) {
    for (const key of keys) await this.tab.keyboard.press(key);
  }

  async move(x, y) {
    await this.tab.mouse.move(x, y, { steps: 4 });
  }

  async click(x, y, button = "left") {
    await this.move(x, y);
    await this.tab.mouse.down({ button });
    await this.wait(50); // egui sees a click only if the two fall into different frames or events
    await this.tab.mouse.up({ button });
  }

  async drag([fromX, fromY], [toX, toY], button = "left") {
    await this.move(fromX, fromY);
    await this.tab.mouse.down({ button });
    await this.tab.mouse.move(toX, toY, { steps: 10 });
    await this.tab.mouse.up({ button });
  }

  /** Lays fingers down and moves them: for each its way, as a list of points, all equally long. Then lifts them. */
  async touch(...fingers) {
    this.protocol ??= await this.tab.context().newCDPSession(this.tab);
    const send = (type, touchPoints) => this.protocol.send("Input.dispatchTouchEvent", { type, touchPoints });
    for (let step = 0; step < fingers[0].length; step++) {
      const points = fingers.map((way, id) => ({ x: way[step][0], y: way[step][1], id }));
      await send(step === 0 ? "touchStart" : "touchMove", points);
      await this.wait(50);
    }
    await send("touchEnd", []);
  }

  /** How long the page stood still at most, in milliseconds, while `work` went on: its longest task. 0 for less than 50. */
  async longestTask(work) {
    await this.tab.evaluate(() => {
      window.longest = 0;
      window.watch = new PerformanceObserver((list) => {
        for (const { duration } of list.getEntries()) window.longest = Math.max(window.longest, duration);
      });
      window.watch.observe({ type: "longtask" });
    });
    await work();
    await this.wait(300); // tasks are reported when they are over
    return this.tab.evaluate(() => {
      window.watch.disconnect();
      return window.longest;
    });
  }

  /** Takes the page's GPU away, as a driver does that starts anew. */
  async loseDevice() {
    await this.tab.evaluate(() => window.devices.at(-1).destroy());
  }

  /** Drops a file of the given bytes on the canvas. */
  async drop(name, bytes, x = 100, y = 100) {
    const base64 = Buffer.from(bytes).toString("base64");
    await this.tab.evaluate(async ([name, base64, clientX, clientY]) => {
      const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
      const dataTransfer = new DataTransfer();
      dataTransfer.items.add(new File([bytes], name));
      const canvas = document.getElementById("umbrage");
      for (const kind of ["dragenter", "dragover", "drop"]) {
        canvas.dispatchEvent(
          new DragEvent(kind, { dataTransfer, clientX, clientY, bubbles: true, cancelable: true }));
      }
    }, [name, base64, x, y]);
  }

  async resize(width, height) {
    await this.tab.setViewportSize({ width, height });
  }

  wait(milliseconds) {
    return new Promise((over) => setTimeout(over, milliseconds));
  }

  /** What is on the screen, as a PNG file. */
  async screenshot(path) {
    await this.tab.screenshot({ path });
  }

  /** The messages that speak of a fault. */
  faults() {
    return this.messages.filter(({ kind }) => kind === "error" || kind === "thrown");
  }

  /** What WebGPU offers here: features and limits of the adapter. */
  adapter() {
    return this.tab.evaluate(async () => {
      const adapter = await navigator.gpu?.requestAdapter();
      if (!adapter) return null;
      const limits = {};
      for (const name in adapter.limits) limits[name] = adapter.limits[name];
      const { vendor, architecture, device, description } = adapter.info;
      return { info: { vendor, architecture, device, description }, features: [...adapter.features].sort(), limits };
    });
  }
}
