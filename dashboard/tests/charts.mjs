// Charts: texts that cover nothing, whatever the numbers are, and lines that join only what can be compared.

import assert from "node:assert/strict";
import * as h from "./harness.mjs";

/** Keeps, for each canvas, where the texts of its last drawing are: rectangles in its pixels. */
function watchTexts() {
  const texts = new WeakMap();
  const { clearRect, fillText } = CanvasRenderingContext2D.prototype;
  CanvasRenderingContext2D.prototype.clearRect = function (...rest) {
    texts.set(this.canvas, []);
    return clearRect.apply(this, rest);
  };
  CanvasRenderingContext2D.prototype.fillText = function (text, x, y, ...rest) {
    const size = this.measureText(text);
    const transform = this.getTransform();
    const corners = [[-size.actualBoundingBoxLeft, -size.actualBoundingBoxAscent], [size.actualBoundingBoxRight, size.actualBoundingBoxDescent]].map(([dx, dy]) => transform.transformPoint({ x: x + dx, y: y + dy }));
    const list = texts.get(this.canvas) ?? [];
    list.push({ text, left: Math.min(corners[0].x, corners[1].x), right: Math.max(corners[0].x, corners[1].x), top: Math.min(corners[0].y, corners[1].y), bottom: Math.max(corners[0].y, corners[1].y) });
    texts.set(this.canvas, list);
    return fillText.call(this, text, x, y, ...rest);
  };
  globalThis.textsOf = (canvas) => texts.get(canvas) ?? [];
}

/** Of every plot: no text covers another or the picture, and none is cut off. */
async function readable(page, what) {
  const plots = await page.evaluate(() =>
    [...document.querySelectorAll(".plot")].map((element) => {
      const canvas = element.querySelector("canvas");
      const { left, top, width, height } = element.plot.bbox;
      return { texts: globalThis.textsOf(canvas), picture: { text: "the picture", left, top, right: left + width, bottom: top + height }, width: canvas.width, height: canvas.height };
    }),
  );
  assert(plots.length > 0, what);
  const over = (a, b) => a.left < b.right - 1 && b.left < a.right - 1 && a.top < b.bottom - 1 && b.top < a.bottom - 1;
  for (const { texts, picture, width, height } of plots) {
    assert(texts.length > 3, `${what}: ${texts.length} texts`);
    assert(picture.right - picture.left > 0.35 * width && picture.bottom - picture.top > 0.4 * height, `${what}: the picture has ${JSON.stringify(picture)} of ${width} × ${height}`);
    texts.forEach((a, k) => {
      for (const b of [picture, ...texts.slice(k + 1)]) assert(!over(a, b), `${what}: “${a.text}” covers “${b.text}”: ${JSON.stringify([a, b])}`);
      assert(a.left >= -1 && a.top >= -1 && a.right <= width + 1 && a.bottom <= height + 1, `${what}: “${a.text}” is cut off: ${JSON.stringify(a)} of ${width} × ${height}`);
    });
  }
}

/** Energies of all magnitudes and signs. */
const SCALES = [1, 400_000, 4e12, 3e-7, -250_000];

export function chartTests({ test, service, pair, submit, finished, json }) {
  test("texts of charts cover nothing, whatever the energies are", async () => {
    const base = service();
    const id = await submit(base, pair());
    const job = await finished(base, id);
    const event = (name, number, data) => `event: ${name}\nid: ${number}\ndata: ${JSON.stringify(data)}\n\n`;
    let points = [];
    const proxy = await h.prefixed(base, "/", (request, response) => {
      if (!request.url.split("?")[0].endsWith(`/jobs/${id}/events`)) return false;
      response.writeHead(200, { "content-type": "text/event-stream" });
      response.end(points.map((point) => event("trace", point.seq, point)).join("") + event("done", `${points.length}-done`, job));
      return true;
    });
    for (const width of [1280, 390]) {
      const page = await h.tab({ width });
      await page.addInitScript(watchTexts);
      for (const scale of SCALES) {
        // Twelve fits, so that their names would cover each other; inliers on the right.
        points = Array.from({ length: 48 }, (_, k) => ({ seq: k + 1, round: k >> 2, phase: "displacement", iteration: 1 + (k % 4), energy: scale * (2 + Math.cos(k)), energy_unary: scale, energy_pairwise: scale * Math.cos(k), ...(k % 4 === 3 ? { support: 1_000_000 + k } : {}) }));
        await page.goto("about:blank");
        await page.goto(`${proxy}#/jobs/${id}`);
        await h.until("the trace", async () => Number(await page.getAttribute("#trace", "data-points").catch(() => 0)) === points.length);
        await page.waitForSelector("#trace .plot canvas");
        await page.waitForTimeout(200);
        await readable(page, `energies of ${scale}, ${width} px`);
        await page.check('#trace label:has-text("Logarithmic") input');
        await page.check('#trace label:has-text("Its parts") input');
        await page.waitForTimeout(200);
        if (scale > 0) await readable(page, `logarithms of energies of ${scale}, ${width} px`);
      }
      const said = await page.textContent("#trace");
      assert(!/improve|lower is better/i.test(said), said);
      page.complaints();
    }
  });

  test("histograms of one value, of equal ones and of any magnitude show bars that no text covers", async () => {
    const base = service();
    const id = "019d8a1b-2c3d-7e4f-8a5b-000000000099";
    let values = [];
    const proxy = await h.prefixed(base, "/", (request, response) => {
      const say = (body) => response.writeHead(200, { "content-type": "application/json" }).end(JSON.stringify(body));
      if (request.url.endsWith(`/batches/${id}`)) return say({ id, n_jobs: values.length, counts: { succeeded: values.length }, finished: true, tags: {}, created_at: "2026-01-01T00:00:00Z" });
      if (!request.url.includes(`/batches/${id}/jobs`)) return false;
      return say({ jobs: values.map((value, k) => ({ id: `${k}`, state: "succeeded", reliable: true, tags: {}, created_at: "2026-01-01T00:00:00Z", source: {}, target: {}, surface_distance: { mean_mm: value, p95_mm: 2 * value, max_mm: 3 * value } })) });
    });
    for (const width of [1280, 390]) {
      const page = await h.tab({ width });
      await page.addInitScript(watchTexts);
      for (const given of [[0.4], [0.4, 0.4, 0.4], [0], [400_000], [0.001, 0.0011], [1, 2, 3, 400_000], Array.from({ length: 3000 }, (_, k) => 1 + Math.sin(k)), [5, 5, 5, 5, 1]]) {
        values = given;
        await page.goto("about:blank");
        await page.goto(`${proxy}#/batches/${id}`);
        await page.waitForFunction(() => document.querySelectorAll(".plot canvas").length === 3);
        await page.waitForTimeout(200);
        await readable(page, `a histogram of ${given.slice(0, 4)}, ${width} px`);
        // Every match is in a bar, and every bar lies whole within the picture.
        const plots = await page.evaluate(() => [...document.querySelectorAll(".plot")].map(({ plot }) => ({ data: plot.data, x: [plot.scales.x.min, plot.scales.x.max], y: [plot.scales.y.min, plot.scales.y.max] })));
        for (const { data, x, y } of plots) {
          const [middles, counts] = data;
          assert.equal(counts.reduce((sum, n) => sum + (n ?? 0), 0), given.length);
          const half = (middles[1] - middles[0]) / 2;
          counts.forEach((n, k) => n && assert(middles[k] - half >= x[0] - 1e-9 * Math.abs(x[0]) && middles[k] + half <= x[1] + 1e-9 * Math.abs(x[1]) && n <= y[1] && y[0] === 0, `a bar at ${middles[k]} of ${x}`));
        }
      }
      page.complaints();
    }
  });

  test("lines join only points of one quantity, start, round and phase", async () => {
    const base = service();
    const id = await submit(base, pair(), { method: "thesis" });
    await finished(base, id);
    const { points } = await json(base, `jobs/${id}/trace?limit=5000`);
    const run = (point) => [point.quantity, point.start, point.round, point.phase, point.phase === "displacement"].join();
    const page = await h.tab();
    await page.goto(`${base}#/jobs/${id}`);
    await h.until("the trace", async () => Number(await page.getAttribute("#trace", "data-points").catch(() => 0)) === points.length);
    const choice = page.locator('#trace label:has-text("Of ") select');
    const quantities = (await choice.count()) === 0 ? [null] : await choice.locator("option").evaluateAll((options) => options.map(({ value }) => value));
    let [joined, runs] = [0, new Set()];
    for (const quantity of quantities) {
      if (quantity !== null) await choice.selectOption(quantity);
      await page.waitForTimeout(200);
      const help = await page.textContent("#trace");
      assert(/Energy of the (assignment of target vertices|displacement field)/.test(help), `${quantity}: ${help}`);
      const lines = await page.evaluate(() => {
        const { plot } = document.querySelector("#trace .plot");
        return plot.series.slice(1).flatMap((series, k) => (["support (inliers)", "energy, single points"].includes(series.label) ? [] : [Array.from(plot.data[0], (x, i) => [x, plot.data[k + 1][i] === undefined ? "none" : plot.data[k + 1][i]])]));
      });
      for (const line of lines) {
        let before = null;
        for (const [x, y] of line) {
          if (y === null) before = null;
          if (typeof y !== "number") continue;
          const point = points.find(({ seq }) => seq === x);
          assert(point, `a value at ${x}`);
          if (before !== null) {
            assert.equal(run(before), run(point), `${JSON.stringify(before)} is joined with ${JSON.stringify(point)}`);
            joined++;
          }
          runs.add(run(point));
          before = point;
        }
      }
    }
    assert(joined > 5 && runs.size > 1, `${joined} joined, ${runs.size} runs`);
    page.complaints();
  });
}
