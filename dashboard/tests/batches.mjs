// Batches that are made in the browser.

import assert from "node:assert/strict";
import { copyFileSync, mkdirSync, renameSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import * as h from "./harness.mjs";

export function batchTests({ test, service, pair, json, drop }) {
  test("a batch from a folder: what can be matched is, what cannot is said, and names stay here unless they are sent", async () => {
    const base = service();
    const folder = join(h.folder, "cohort");
    const put = (path, write) => {
      mkdirSync(dirname(join(folder, path)), { recursive: true });
      write(join(folder, path));
    };
    put("sub-01/left.ply", (path) => copyFileSync(pair()[0], path));
    put("sub-02/left.ply", (path) => copyFileSync(pair()[1], path));
    put("sub-10/left.ply", (path) => copyFileSync(pair()[0], path));
    put("sub-03/left.obj", (path) => writeFileSync(path, "no surface\n"));
    put("sub-03/notes.json", (path) => writeFileSync(path, "{}"));
    put(".hidden.ply", (path) => writeFileSync(path, ""));
    const page = await h.tab({ ignore: /status of 4\d\d/ });
    const given = async () => {
      await page.goto(`${base}#/batches`);
      await page.click('a:has-text("New batch")');
      await drop(page, 'section[aria-label="Template"]', [pair()[1]]);
      await page.setInputFiles('input[aria-label$="a folder"]', folder);
      await h.until("all files", async () => /3 of 4 can be matched, 1 cannot/.test(await page.textContent('section[aria-label="Subjects"]')));
      await page.waitForSelector('section[aria-label="Template"] .badge.good');
    };
    await given();
    await h.accessible(page, "a new batch");
    await h.fits(page, "a new batch");
    await h.picture(page, "batch-new");
    renameSync(join(folder, "sub-10/left.ply"), join(folder, "sub-10/left <img src=x onerror=globalThis.ran=1>.ply"));
    await given();
    const rows = () => page.locator(".scroll.files tbody tr").evaluateAll((rows) => rows.map((row) => [...row.querySelectorAll("td")].map((cell) => cell.textContent)));
    const shown = await rows();
    assert.deepEqual(shown.map(([name]) => name), ["sub-03/left", "sub-01/left", "sub-02/left", "sub-10/left <img src=x onerror=globalThis"]);
    assert(shown[0][2].includes("cannot be matched") && shown[0][2].length > 20, shown[0][2]);
    assert.equal(await page.evaluate(() => globalThis.ran), undefined);

    const sentBatch = async (keeps) => {
      await page.setChecked('label:has-text("Name the jobs by their files") input', keeps);
      await page.click('button.primary:has-text("Match 3 subjects")');
      await page.waitForURL(/#\/batches\/[0-9a-f-]{36}/);
      const id = /batches\/([0-9a-f-]{36})/.exec(page.url())[1];
      return [await json(base, `batches/${id}`), (await json(base, `batches/${id}/jobs`)).jobs.sort((a, b) => (a.id < b.id ? -1 : 1))];
    };
    const [bare, numbered] = await sentBatch(false);
    assert.deepEqual(numbered.map(({ external_ref }) => external_ref), ["subject 001", "subject 002", "subject 003"]);
    assert.deepEqual([bare.tags, ...numbered.map(({ tags }) => tags)], [{}, {}, {}, {}]);

    await given();
    await page.selectOption('label:has-text("The template is") select', "source");
    await page.fill('label:has-text("Tags") input', "wave:2");
    const [batch, named] = await sentBatch(true);
    assert.deepEqual(batch.tags, { source_file: "target.ply", wave: "2" });
    assert.deepEqual(named.map(({ external_ref, tags }) => [external_ref, tags.target_file, tags.wave]), [
      ["sub-01/left", "cohort/sub-01/left.ply", "2"],
      ["sub-02/left", "cohort/sub-02/left.ply", "2"],
      ["sub-10/left <img src=x onerror=globalThis", "cohort/sub-10/left <img src=x onerror=globalThis.ran=1>.ply", "2"],
    ]);
    const template = await json(base, `jobs/${named[0].id}`);
    assert.equal(template.source.hash, template.source.hash && named[1].source.hash, "the template is the source of all");
    await h.until("the batch", async () => (await json(base, `batches/${batch.id}`)).finished, 120_000);
    await page.waitForSelector('a:has-text("sub-02/left")');
    page.complaints();

    // Many files at once, one of them taken out again; the template is the target.
    await page.goto(`${base}#/batches/new`);
    await page.setInputFiles('input[aria-label="Files of the subjects"]', [join(folder, "sub-01/left.ply"), pair()[1], join(folder, "sub-03/left.obj")]);
    await page.setInputFiles('input[aria-label="File of the template"]', pair()[0]);
    await h.until("all files", async () => /2 of 3 can be matched, 1 cannot/.test(await page.textContent('section[aria-label="Subjects"]')));
    await page.click('button[aria-label="Take out target.ply"]');
    await page.waitForSelector('button.primary:has-text("Match 1 subject"):not([disabled])');
    const narrow = await h.tab({ width: 390, height: 844, colorScheme: "dark" });
    await narrow.goto(`${base}#/batches/new`);
    await narrow.setInputFiles('input[aria-label="Files of the subjects"]', [pair()[0]]);
    await narrow.waitForSelector(".scroll.files .badge.good");
    await h.fits(narrow, "a new batch at 390");
    await h.accessible(narrow, "a new batch, dark, 390");
    narrow.complaints();
  });
}
