// A page of another origin uses the service from Chromium.
// Usage: node browser.mjs PORT BASE REFUSING [KEY]; PORT: where the page is served, BASE: a service that lists its origin,
// REFUSING: one that does not, KEY: an API key where keys are required.
import assert from "node:assert/strict";
import { mkdtemp, writeFile } from "node:fs/promises";
import { createServer } from "node:http";
import { tmpdir } from "node:os";
import { join } from "node:path";
import puppeteer from "puppeteer-core";

const [port, base, refusing, key] = process.argv.slice(2);
// A closed tetrahedron is a surface.
const ply = `ply
format ascii 1.0
element vertex 4
property float x
property float y
property float z
element face 4
property list uchar int vertex_indices
end_header
0 0 0
10 0 0
0 11 0
0 0 12
3 0 2 1
3 0 1 3
3 0 3 2
3 1 2 3
`;
const server = createServer((_, answer) => {
  answer.setHeader("content-type", "text/html");
  answer.end("<!doctype html><title>viewer</title>");
}).listen(Number(port), "127.0.0.1");
const browser = await puppeteer.launch({
  executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
  args: ["--no-sandbox", "--disable-dev-shm-usage"],
});
try {
  const page = await browser.newPage();
  await page.goto(`http://localhost:${port}/`);
  const found = await page.evaluate(
    async (base, refusing, key, ply) => {
      const headers = key ? { authorization: `Bearer ${key}` } : {};
      const call = (path, options = {}) => fetch(base + path, { ...options, headers: { ...headers, ...options.headers } });
      const blocked = async (url) => fetch(url, { headers }).then(() => false, () => true);
      const ticketed = async (path) => {
        if (!key) return base + path;
        const made = await call("/v1/tickets", {
          method: "POST",
          headers: { "content-type": "application/json" },
          body: JSON.stringify({ path }),
        });
        return `${base}${path}?ticket=${(await made.json()).ticket}`;
      };
      const states = [];
      const all = new EventSource(await ticketed("/v1/events"));
      const opened = new Promise((done) => all.addEventListener("open", done));
      const ended = new Promise((done) =>
        all.addEventListener("change", (event) => {
          const { state } = JSON.parse(event.data);
          states.push(state);
          if (["succeeded", "failed"].includes(state)) done(event.lastEventId);
        }),
      );
      await opened;
      const form = new FormData();
      form.append("source", new Blob([ply]), "a.ply");
      form.append("target", new Blob([ply]), "b.ply");
      form.append("parameters", JSON.stringify({ method: "rigid" }));
      const sent = await call("/v1/jobs", { method: "POST", body: form, headers: { "idempotency-key": crypto.randomUUID() } });
      const job = await sent.json();
      const lastId = await ended;
      all.close();
      const stream = new EventSource(await ticketed(`${job.links.self}/events`));
      const done = await new Promise((done) => stream.addEventListener("done", (event) => done(JSON.parse(event.data))));
      stream.close();
      const slim = await (await call("/v1/jobs?fields=id,state")).json();
      const got = await call(job.links.self);
      const file = await fetch(await ticketed(`${job.links.self}/files/correspondences.csv`));
      return {
        status: sent.status,
        location: sent.headers.get("location"),
        problem: job.title,
        states,
        lastId,
        done: done.state,
        slim: Object.keys(slim.jobs[0]),
        etag: got.headers.get("etag"),
        csv: (await file.text()).slice(0, 13),
        without: key ? (await fetch(base + "/v1/jobs")).status : 200,
        blocked: await blocked(refusing + "/v1/jobs"),
      };
    },
    base,
    refusing,
    key ?? "",
    ply,
  );
  assert.equal(found.status, 202, found.problem);
  assert.deepEqual(found.states, ["queued", "running", "succeeded"]);
  assert.equal(found.done, "succeeded");
  assert.deepEqual(found.slim, ["id", "state"]);
  assert(Number(found.lastId) >= 3 && found.location && found.etag, JSON.stringify(found));
  assert.equal(found.csv, "source,target");
  assert.equal(found.without, key ? 401 : 200);
  assert(found.blocked, "a service that does not list the origin must be out of reach");

  // The page of the API fills in nothing that would make a job expire or fail.
  if (!key) {
    await page.goto(`${base}/docs/`);
    await page.waitForSelector("#operations-jobs-submit_job");
    await page.click("#operations-jobs-submit_job .opblock-summary-control");
    await page.waitForSelector("#operations-jobs-submit_job .try-out__btn");
    await page.click("#operations-jobs-submit_job .try-out__btn");
    await page.select("#operations-jobs-submit_job .opblock-section-request-body select", "multipart/form-data");
    await page.waitForSelector("#operations-jobs-submit_job .parameters-col_description input[type=file]");
    const [source, target] = await page.$$("#operations-jobs-submit_job .parameters-col_description input[type=file]");
    const folder = await mkdtemp(join(tmpdir(), "homolog-"));
    await writeFile(join(folder, "a.ply"), ply);
    for (const field of [source, target]) await field.uploadFile(join(folder, "a.ply"));
    const filled = await page.evaluate(() => {
      const rows = document.querySelectorAll("#operations-jobs-submit_job .opblock-section-request-body tr[data-property-name]");
      return [...rows].map((row) => {
        const field = row.querySelector("input:not([type=file]):not([type=checkbox]), textarea, select");
        return [row.dataset.propertyName, field?.value ?? ""];
      });
    });
    const values = Object.fromEntries(filled);
    assert.equal(values.deadline_at, "", JSON.stringify(values));
    assert.equal(values.parameters, "{}", JSON.stringify(values));
    // Sent as it was filled in, it becomes a job.
    await page.click("#operations-jobs-submit_job .execute");
    await page.waitForSelector("#operations-jobs-submit_job .live-responses-table .response-col_status");
    const shown = await page.$eval("#operations-jobs-submit_job .live-responses-table", (table) => table.innerText);
    assert(/\b202\b/.test(shown) && shown.includes('"queued"'), shown);
  }
  console.log("all of it");
} finally {
  await browser.close();
  server.close();
}
