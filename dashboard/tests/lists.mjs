// The list of jobs: what tells them apart, filters that are kept, and the keyboard.

import assert from "node:assert/strict";
import { copyFileSync } from "node:fs";
import { join } from "node:path";
import * as h from "./harness.mjs";

export function listTests({ test, service, pair, submit, finished, api, json, drop }) {
  test("jobs are told apart by the names of their files, if these are sent, and by a picture", async () => {
    const base = service();
    const page = await h.tab();
    const [plain, attack] = ["left-hippocampus.ply", "left <img src=x onerror=globalThis.ran=1>.ply"].map((name) => join(h.folder, name));
    for (const path of [plain, attack]) copyFileSync(pair()[0], path);
    const jobs = [];
    for (const [file, keeps] of [[plain, false], [plain, true], [attack, true]]) {
      await page.goto(`${base}#/submit`);
      await page.waitForSelector("h1:has-text('Submit')");
      await drop(page, 'section[aria-label="source"]', [file]);
      await drop(page, 'section[aria-label="target"]', [pair()[1]]);
      await h.until("both files", async () => (await page.locator("section.drop p.success").count()) === 2);
      await page.setChecked('label:has-text("Keep the names of the files") input', keeps);
      await page.click('button.primary:has-text("Match them")');
      await page.waitForURL(/#\/jobs\/[0-9a-f-]{36}/);
      jobs.push(/jobs\/([0-9a-f-]{36})/.exec(page.url())[1]);
      if (jobs.length !== 2) continue;
      // As it is in use: something runs, something waits.
      const more = [];
      for (let k = 0; k < 4; k++) more.push(await submit(base, pair(), { method: "gibbs", inference: { max_iterations: 100000 }, seed: 700 + k }, { external_ref: `visit ${k + 1}` }));
      await page.goto(`${base}#/jobs`);
      await page.waitForSelector('tr[data-state="running"] .spark', { timeout: 60_000 });
      await page.waitForSelector("tr[data-state] .picture img");
      await page.waitForTimeout(2500);
      await h.picture(page, "jobs");
      for (const id of more) await api(base, `jobs/${id}/cancel`, { method: "POST" });
    }
    for (const id of jobs) await finished(base, id);
    const [without, , named] = await Promise.all(jobs.map((id) => json(base, `jobs/${id}`)));
    assert.deepEqual(without.tags, {});
    assert.deepEqual(named.tags, { source_file: "left <img src=x onerror=globalThis.ran=1>.ply", target_file: "target.ply" });
    await page.click('nav a:has-text("Jobs")');
    const row = (id) => page.locator("tr[data-state]").filter({ has: page.locator(`a[title="${id}"]`) });
    await h.until("the names", async () => (await row(jobs[2]).textContent()).includes("left <img src=x onerror=globalThis.ran=1>.ply → target.ply"));
    assert(!(await row(jobs[0]).textContent()).includes("→"));
    // Nothing is cut off at the usual width.
    assert(await page.evaluate(() => document.querySelector(".rows").scrollWidth <= document.querySelector(".rows").clientWidth), "the list is as wide as its window");
    // The list knows where each row is, because all are equally high, with a picture and without.
    const heights = await page.locator("tr[data-index]").evaluateAll((rows) => rows.map((row) => Math.round(row.getBoundingClientRect().height)));
    assert(heights.length > 3 && heights.every((height) => height === 44), String(heights));
    assert.equal(await page.evaluate(() => globalThis.ran), undefined);
    // The picture is that of the surface: as much longer than high as the source is.
    await row(jobs[2]).locator(".picture img").waitFor();
    const seen = await row(jobs[2]).locator(".picture img").evaluate((image) => {
      const canvas = new OffscreenCanvas(image.naturalWidth, image.naturalHeight);
      const context = canvas.getContext("2d");
      context.drawImage(image, 0, 0);
      const { data, width, height } = context.getImageData(0, 0, canvas.width, canvas.height);
      const isDrawn = (x, y) => data[4 * (y * width + x) + 3] > 128;
      const columns = Array.from({ length: width }, (_, x) => x).filter((x) => Array.from({ length: height }, (_, y) => y).some((y) => isDrawn(x, y)));
      const rows = Array.from({ length: height }, (_, y) => y).filter((y) => Array.from({ length: width }, (_, x) => x).some((x) => isDrawn(x, y)));
      return columns.length / rows.length;
    });
    await page.goto(`${base}#/jobs/${jobs[2]}`);
    await page.waitForSelector("#view", { timeout: 60_000 });
    await h.until("the surface", () => page.evaluate(() => Boolean(document.querySelector("#view").scene)));
    const expected = await page.evaluate(() => {
      // The extents along the principal axes, by power iteration over the source's own vertices.
      const position = document.querySelector("#view").scene.pair.source.getAttribute("position").array;
      const n = position.length / 3;
      const center = [0, 1, 2].map((k) => position.reduce((sum, x, at) => (at % 3 === k ? sum + x : sum), 0) / n);
      const rows = Array.from({ length: n }, (_, v) => [0, 1, 2].map((k) => position[3 * v + k] - center[k]));
      const axes = [];
      for (let a = 0; a < 2; a++) {
        let axis = [0.3, 0.5, 0.8];
        for (let step = 0; step < 500; step++) {
          const next = [0, 0, 0];
          for (const row of rows) {
            let along = row.reduce((sum, x, k) => sum + x * axis[k], 0);
            for (let k = 0; k < 3; k++) next[k] += along * row[k];
          }
          for (const before of axes) {
            const along = next.reduce((sum, x, k) => sum + x * before[k], 0);
            for (let k = 0; k < 3; k++) next[k] -= along * before[k];
          }
          const length = Math.hypot(...next);
          axis = next.map((x) => x / length);
        }
        axes.push(axis);
      }
      const [long, wide] = axes.map((axis) => {
        const all = rows.map((row) => row.reduce((sum, x, k) => sum + x * axis[k], 0));
        return Math.max(...all) - Math.min(...all);
      });
      return long / wide;
    });
    assert(Math.abs(seen / expected - 1) < 0.1, `the picture is ${seen} times wider than high, the surface ${expected}`);
    // Without pictures no surface is asked for.
    await page.goto(`${base}#/jobs`);
    await page.uncheck('label:has-text("Pictures") input');
    const asked = [];
    page.on("request", (request) => request.url().includes("/surfaces/") && asked.push(request.url()));
    await page.reload();
    await page.waitForSelector("tr[data-state]");
    await page.waitForTimeout(1000);
    assert.deepEqual([asked, await page.locator(".picture").count()], [[], 0]);
    await page.check('label:has-text("Pictures") input');
    page.complaints();
  });

  test("filters are kept under a name by the browser", async () => {
    const base = service();
    await finished(base, await submit(base, pair(), {}, { tags: { site: "a" } }));
    const page = await h.tab();
    await page.goto(`${base}#/jobs?state=succeeded&tag=site%3Aa`);
    await page.click('button:has-text("Save these filters")');
    await page.fill('input[aria-label="Name of these filters"]', "site <i>a</i>");
    await page.keyboard.press("Enter");
    await page.waitForSelector('button:has-text("Forget")');
    await page.click('button:has-text("Clear filters")');
    await page.waitForURL((url) => !url.hash.includes("state="));
    await page.reload();
    await page.selectOption('label:has-text("Saved filters") select', "site <i>a</i>");
    await page.waitForURL(/state=succeeded&tag=site%3Aa/);
    await h.until("the filtered list", async () => (await page.locator("tr[data-state]").count()) === (await json(base, "jobs?state=succeeded&tag=site:a")).jobs.length);
    await h.accessible(page, "saved filters");
    await page.click('button:has-text("Forget")');
    await page.waitForSelector('label:has-text("Saved filters")', { state: "detached" });
    // What another program has left there does no harm.
    for (const kept of ["{", "[1]", '{"a":1}', '[{"name":"x","filters":null}]']) {
      await page.evaluate((kept) => localStorage.setItem("homolog-filters", kept), kept);
      await page.reload();
      await page.waitForSelector("tr[data-state]");
    }
    page.complaints();
  });

  test("the list is used by the keyboard from the moment that the page is there", async () => {
    const base = service();
    for (let k = 0; k < 3; k++) await finished(base, await submit(base, pair(), { seed: 900 + k }));
    const { jobs } = await json(base, "jobs?page_size=3");
    const page = await h.tab();
    await page.goto(`${base}#/jobs`);
    await page.waitForSelector("tr[data-state]");
    const at = () => page.evaluate(() => document.activeElement?.getAttribute("title"));
    for (const [key, k] of [["ArrowDown", 0], ["j", 1], ["ArrowDown", 2], ["k", 1]]) {
      await page.keyboard.press(key);
      await h.until(`${key} moves to row ${k}`, async () => (await at()) === jobs[k].id);
    }
    await page.keyboard.press("Enter");
    await page.waitForURL(new RegExp(jobs[1].id));
    // Elsewhere, and in fields, keys are what they are.
    await page.goto(`${base}#/jobs`);
    await page.waitForSelector("tr[data-state]");
    await page.fill('label:has-text("Reference") input', "j");
    await page.keyboard.press("j");
    assert.equal(await page.inputValue('label:has-text("Reference") input'), "jj");
    page.complaints();
  });
}
