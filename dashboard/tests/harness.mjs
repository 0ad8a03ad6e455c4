// What the end-to-end tests share: services, a browser, proxies that can be cut, and pixels.

import assert from "node:assert/strict";
import { spawn, spawnSync } from "node:child_process";
import { existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync } from "node:fs";
import http from "node:http";
import net from "node:net";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { basename, extname, join } from "node:path";
import { gzipSync } from "node:zlib";
import { chromium } from "playwright-core";

export const BINARY = process.env.DASHBOARD_BINARY;
export const CHROMIUM = process.env.DASHBOARD_CHROMIUM ?? "/usr/bin/chromium";
export const PICTURES = process.env.DASHBOARD_SCREENSHOTS;
/** A folder with a built page, which is then tested instead of the one that the program has. */
const PAGE = process.env.DASHBOARD_PAGE;
/** Without settings of the program. */
const ENVIRONMENT = Object.fromEntries(Object.entries(process.env).filter(([name]) => !name.startsWith("HOMOLOG_")));
const AXE = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

export const folder = mkdtempSync(join(tmpdir(), "homolog-dashboard-"));
const ending = [];
export const atEnd = (work) => ending.push(work);
export async function end() {
  for (const work of ending.reverse()) await work();
  rmSync(folder, { recursive: true, force: true });
}

export const sleep = (ms) => new Promise((resolve) => setTimeout(resolve, ms));

export async function until(what, found, ms = 60_000) {
  const began = Date.now();
  for (;;) {
    const value = await found();
    if (value) return value;
    assert(Date.now() - began < ms, `${what}: not within ${ms} ms`);
    await sleep(60);
  }
}

/** Runs a command of homolog and returns its output. */
export function run(...parameters) {
  const done = spawnSync(BINARY, parameters, { encoding: "utf8", env: ENVIRONMENT });
  assert.equal(done.status, 0, `homolog ${parameters[0]}: ${done.stderr}`);
  return done.stdout.trim();
}

export function freePort() {
  return new Promise((resolve) => {
    const server = net.createServer().listen(0, "127.0.0.1", () => {
      const { port } = server.address();
      server.close(() => resolve(port));
    });
  });
}

/** A service on a free port with a data folder of its own. */
export async function service(name, ...parameters) {
  const port = await freePort();
  const child = spawn(BINARY, ["serve", "--listen", `127.0.0.1:${port}`, "--data-dir", join(folder, name), ...parameters], { stdio: ["ignore", "ignore", "pipe"], env: ENVIRONMENT });
  let log = "";
  child.stderr.on("data", (text) => (log = (log + text).slice(-4000)));
  atEnd(async () => {
    child.kill("SIGTERM");
    await Promise.race([new Promise((resolve) => child.once("exit", resolve)), sleep(5000)]);
    child.kill("SIGKILL");
  });
  const base = `http://127.0.0.1:${port}/`;
  await until(`service ${name}`, async () => {
    assert.equal(child.exitCode, null, log);
    return fetch(`${base}readyz`).then((answer) => answer.ok, () => false);
  });
  return PAGE ? withPage(base) : base;
}

/** The service, with the page of the folder `PAGE` under the policy that it gives its own. */
async function withPage(base) {
  const kinds = { ".html": "text/html; charset=utf-8", ".js": "text/javascript; charset=utf-8", ".css": "text/css; charset=utf-8", ".svg": "image/svg+xml" };
  const policy = (await fetch(base)).headers.get("content-security-policy");
  return prefixed(base, "/", (request, response) => {
    const path = request.url.split("?")[0];
    if (path !== "/" && !path.startsWith("/assets/")) return false;
    const file = join(PAGE, path === "/" ? "index.html" : basename(path));
    if (!existsSync(file)) return response.writeHead(404).end();
    return response.writeHead(200, { "content-type": kinds[extname(file)] ?? "application/octet-stream", "content-security-policy": policy, "content-encoding": "gzip" }).end(gzipSync(readFileSync(file)));
  });
}

/** A connection to `base` that can be cut and mended. */
export async function cuttable(base) {
  const { port } = new URL(base);
  let isCut = false;
  const open = new Set();
  const server = net.createServer((client) => {
    if (isCut) return client.destroy();
    const upstream = net.connect(Number(port), "127.0.0.1");
    for (const socket of [client, upstream]) {
      open.add(socket);
      socket.on("error", () => undefined);
      socket.on("close", () => (open.delete(socket), client.destroy(), upstream.destroy()));
    }
    client.pipe(upstream).pipe(client);
  });
  await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
  atEnd(() => server.close());
  return {
    base: `http://127.0.0.1:${server.address().port}/`,
    cut() {
      isCut = true;
      open.forEach((socket) => socket.destroy());
    },
    mend: () => (isCut = false),
  };
}

/** A proxy that serves `base` below a path of its own; what `instead` answers, and says so, does not come from there. */
export async function prefixed(base, prefix, instead = () => false) {
  const server = http.createServer((request, response) => {
    if (instead(request, response)) return;
    if (!request.url.startsWith(prefix)) return response.writeHead(404).end();
    const { hostname, port } = new URL(base);
    const upstream = http.request({ hostname, port, method: request.method, path: request.url.slice(prefix.length - 1), headers: { ...request.headers, host: `${hostname}:${port}` } }, (answer) => {
      response.writeHead(answer.statusCode, answer.headers);
      answer.pipe(response);
    });
    upstream.on("error", () => response.destroy());
    response.on("close", () => upstream.destroy());
    request.pipe(upstream);
  });
  await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
  atEnd(() => (server.closeAllConnections(), server.close()));
  return `http://127.0.0.1:${server.address().port}${prefix}`;
}

let browser;
export async function launch() {
  browser = await chromium.launch({
    executablePath: CHROMIUM,
    args: [...(process.getuid?.() === 0 ? ["--no-sandbox"] : []), "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
  });
  atEnd(() => browser.close());
}

/** A tab in a context of its own; whatever it complains about is collected. */
const contexts = [];

/** Closes all tabs, so that none goes on asking. */
export async function closeTabs() {
  for (const context of contexts.splice(0)) await context.close();
}

export async function tab({ width = 1280, height = 860, colorScheme = "light", ignore = null } = {}) {
  const context = await browser.newContext({ viewport: { width, height }, colorScheme, acceptDownloads: true });
  contexts.push(context);
  const page = await context.newPage();
  const complaints = [];
  page.on("console", (message) => {
    if (["error", "warning"].includes(message.type()) && !(ignore && ignore.test(message.text()))) complaints.push(`${message.type()}: ${message.text()}`.slice(0, 400));
  });
  page.on("pageerror", (error) => complaints.push(String(error.stack).slice(0, 800)));
  page.complaints = () => assert.deepEqual(complaints.filter((text) => !/GPU stall due to ReadPixels|GL Driver Message/.test(text)), []);
  return page;
}

/** No rule of WCAG 2 A and AA is broken, in the rules that axe can check. */
export async function accessible(page, what) {
  // The policy of the page forbids scripts that are put into it, but not those of the debugger.
  await page.evaluate(AXE);
  const { violations } = await page.evaluate(() => globalThis.axe.run(document, { runOnly: ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa"] }));
  const found = violations.map(({ id, nodes }) => `${id}: ${nodes.slice(0, 3).map(({ html, failureSummary }) => `${html} ${failureSummary}`).join(" | ")}`);
  assert.deepEqual(found, [], `${what}: axe`);
}

/** Nothing is wider than the window. */
export async function fits(page, what) {
  const [content, window] = await page.evaluate(() => [document.documentElement.scrollWidth, innerWidth]);
  if (content <= window) return;
  const wide = await page.evaluate(() => [...document.querySelectorAll("main *")].filter((element) => element.getBoundingClientRect().right > innerWidth && !element.closest(".scroll, .rows")).slice(0, 5).map((element) => element.outerHTML.slice(0, 200)));
  assert.fail(`${what}: ${content} px of content in ${window} px: ${wide.join(" | ")}`);
}

export async function picture(page, name) {
  if (!PICTURES) return;
  mkdirSync(PICTURES, { recursive: true });
  await page.screenshot({ path: join(PICTURES, `${name}.png`) });
}

/** The colors of the canvas `selector` as they are on the screen: a function from place in CSS pixels to red, green, blue. */
export async function pixels(page, selector) {
  const shot = await page.locator(selector).screenshot();
  const { width, height, data } = await page.evaluate(async (base64) => {
    const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
    const bitmap = await createImageBitmap(new Blob([bytes], { type: "image/png" }));
    const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
    const context = canvas.getContext("2d");
    context.drawImage(bitmap, 0, 0);
    const all = context.getImageData(0, 0, bitmap.width, bitmap.height).data;
    let text = "";
    for (let k = 0; k < all.length; k += 8192) text += String.fromCharCode(...all.subarray(k, k + 8192));
    return { width: bitmap.width, height: bitmap.height, data: btoa(text) };
  }, shot.toString("base64"));
  const bytes = Buffer.from(data, "base64");
  return (x, y) => {
    const at = 4 * (Math.min(height - 1, Math.max(0, Math.round(y))) * width + Math.min(width - 1, Math.max(0, Math.round(x))));
    return [bytes[at], bytes[at + 1], bytes[at + 2]];
  };
}
