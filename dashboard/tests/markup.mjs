// Texts of users with markup, in every page that shows them: the dashboard, the reports of a match and of a study (served, and as a file of
// the archive), and the documentation of the API.

import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import * as h from "./harness.mjs";

/** Each would be seen: one opens another site, the others run a script. */
const TEXTS = [
  // Without spaces, so that it can be part of a column in a sum.
  '</script><meta/http-equiv="refresh"/content="0;url=about:blank#elsewhere">',
  "</title></style><script>globalThis.ran=1</script>",
  "\"'><img src=x onerror=globalThis.ran=1>",
  "<svg onload=globalThis.ran=1>&lt;iframe srcdoc=x>",
];
const [refresh, script, image, svg] = TEXTS;

/** A page that stays where it is, runs nothing of the texts, and has no element of them. */
async function holds(page, url, shows, open = () => page.goto(url)) {
  const places = [];
  const note = (frame) => places.push(frame.url());
  await open();
  page.on("framenavigated", note);
  for (const text of shows) await h.until(`${url} shows ${text}`, async () => (await page.evaluate(() => document.body.textContent)).includes(text));
  await page.waitForTimeout(1_000);
  page.off("framenavigated", note);
  const found = await page.evaluate(() => ({
    ran: globalThis.ran,
    elements: [...document.querySelectorAll('meta[http-equiv="refresh"], [onerror], [onload], iframe, img[src="x"]')].map((element) => element.outerHTML),
  }));
  assert.deepEqual(found, { ran: undefined, elements: [] }, url);
  assert(places.every((place) => !place.includes("elsewhere")) && page.mainFrame().childFrames().length === 0, `${url}: ${places}`);
}

export function markupTests({ test, service, pair, json, api, sent, finished }) {
  test("texts of users are markup on no page", async () => {
    const base = service();
    const named = async (path, name) => {
      const answer = await api(base, `meshes?file_name=${encodeURIComponent(name)}`, { method: "POST", body: readFileSync(path), headers: { "content-type": "application/octet-stream" } });
      return (await answer.json()).id;
    };
    const [source, target] = [await named(pair()[0], `${image}.ply`), await named(pair()[1], `${script}.ply`)];
    const tags = { [svg.slice(0, 60)]: image, source_file: `${image}.ply`, target_file: `${script}.ply` };
    const job = (await json(base, "jobs", sent({ source: { mesh_id: source }, target: { mesh_id: target }, external_ref: refresh, tags }))).id;
    const batch = (await json(base, "batches", sent({ pairs: [{ source: { mesh_id: source }, target: { mesh_id: target }, tags, external_ref: script }], external_ref: refresh, tags }))).id;

    const subjects = [];
    for (let k = 0; k < 6; k++) {
      const out = join(h.folder, `markup-${k}`);
      h.run("phantom", "--subject", String(k + 1), "--kind", "surface", "--edge", "3", "--out", out);
      const covariates = { [`group${refresh}`]: `${k % 2 ? "patient" : "control"}${refresh}`, [`site ${image}`]: script };
      subjects.push({ id: `m${k}`, input: { mesh_id: await named(join(out, "source.ply"), `${svg}.ply`) }, covariates });
    }
    const effect = `group${refresh}`;
    const asked = { effect, reference: { [effect]: `control${refresh}` }, contrasts: { [`contrast ${image}`]: `${effect}:patient${refresh}` }, permutations: 20 };
    const { id } = await json(base, "studies", sent({ subjects, template: subjects[0].input, ...asked, external_ref: refresh, tags }));
    const isFinished = () => h.until("the study", async () => (await json(base, `studies/${id}`)).state === "finished", 180_000);
    await isFinished();
    await api(base, `studies/${id}/subjects/m1/decision`, { ...sent({ decision: "kept", reason: `seen ${refresh}${image}` }), method: "PUT" });
    await isFinished();
    assert.equal((await finished(base, job)).state, "succeeded");

    const page = await h.tab();
    await holds(page, `${base}#/jobs`, [refresh]);
    await holds(page, `${base}#/jobs/${job}`, [refresh]);
    await holds(page, `${base}#/batches/${batch}`, [refresh]);
    await holds(page, `${base}#/studies`, [refresh]);
    await holds(page, `${base}#/studies/${id}`, [refresh, `seen ${refresh}${image}`]);
    page.complaints();

    const reports = await h.tab();
    await holds(reports, `${base}v1/jobs/${job}/report`, []);
    await holds(reports, `${base}v1/studies/${id}/report`, [`seen ${refresh}${image}`]);
    reports.complaints();
    // A file has the rights of no site, and no header says what it may load.
    for (const [name, path] of [["job", `jobs/${job}/report`], ["study", `studies/${id}/report`]]) {
      const file = join(h.folder, `${name}.html`);
      writeFileSync(file, Buffer.from(await (await api(base, path)).arrayBuffer()));
      await holds(reports, pathToFileURL(file).href, name === "study" ? [`seen ${refresh}${image}`] : []);
    }
    // The documentation, and an answer of the service in it.
    const docs = await h.tab();
    await holds(docs, `${base}docs/?${encodeURIComponent(image)}#/jobs/get_job`, ["homolog"]);
    await docs.click("button.try-out__btn");
    await docs.fill('tr[data-param-name="id"] input', job);
    await holds(docs, `${base}docs/`, [refresh.slice(0, 25)], () => docs.click("button.execute"));

    // On a page that does not escape them each text is noticed.
    const careless = await h.tab();
    for (const [k, text] of TEXTS.entries()) {
      const file = join(h.folder, `careless-${k}.html`);
      writeFileSync(file, `<!doctype html><title>x</title><script type="application/json">0</script><p title="">${text}</p>`);
      await assert.rejects(() => holds(careless, pathToFileURL(file).href, []), assert.AssertionError, text);
    }
  });
}
