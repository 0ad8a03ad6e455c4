// Studies in the browser: from the list to decisions, maps and modes, against the files of the archive, which are read here without
// the page.

import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import * as h from "./harness.mjs";

/** Files of a zip archive whose files are stored as they are, by a walk over their own headers. */
function unzipped(buffer) {
  const files = new Map();
  for (let at = 0; buffer.readUInt32LE(at) === 0x04034b50; ) {
    const [size, name, extra] = [buffer.readUInt32LE(at + 18), buffer.readUInt16LE(at + 26), buffer.readUInt16LE(at + 28)];
    const from = at + 30 + name + extra;
    files.set(buffer.toString("utf8", at + 30, at + 30 + name), buffer.subarray(from, from + size));
    at = from + size;
  }
  return files;
}

/** An array of doubles at the vertices of a legacy VTK file. */
function column(buffer, name) {
  const head = new RegExp(`\\n${name} 1 (\\d+) double\\n`, "d").exec(buffer.toString("latin1"));
  return Array.from({ length: Number(head[1]) }, (_, k) => buffer.readDoubleBE(head.indices[0][1] + 8 * k));
}

const points = (buffer) => {
  const head = /\nPOINTS (\d+) double\n/d.exec(buffer.toString("latin1"));
  return Array.from({ length: Number(head[1]) }, (_, v) => [0, 1, 2].map((k) => buffer.readDoubleBE(head.indices[0][1] + 8 * (3 * v + k))));
};

/**
 * A report in print, on the width of a page: nothing is cut off, every subject is in the table of quality control, columns are
 * explained, what only a screen can do is left out, and each map and mode has a picture that shows something, with a bar.
 */
async function printed(report, ids, nFigures) {
  const before = report.viewportSize();
  await report.emulateMedia({ media: "print" });
  // A4 and Letter between the margins of Chromium.
  await report.setViewportSize({ width: 718, height: 1000 });
  const isShown = (selector) => report.locator(selector).evaluateAll((all) => all.map((element) => element.getClientRects().length > 0));
  const wide = await report.evaluate(() => [...document.querySelectorAll("main *")].filter((element) => element.getBoundingClientRect().right > innerWidth + 1).map((element) => element.outerHTML.slice(0, 120)));
  assert.deepEqual(wide, [], "wider than the page");
  const cut = await report.evaluate(() => [...document.querySelectorAll(".scroll")].filter((element) => element.scrollHeight > element.clientHeight + 1 || element.scrollWidth > element.clientWidth + 1).map((element) => element.textContent.slice(0, 80)));
  assert.deepEqual(cut, [], "cut off");
  const rows = await report.evaluate(() => [...document.querySelector("table").tBodies[0].rows].filter((row) => row.getClientRects().length > 0).map((row) => row.cells[0].textContent));
  assert.deepEqual([...rows].sort(), [...ids].sort());
  for (const selector of [".stage", ".controls", "button", "details"]) assert((await isShown(selector)).every((shown) => !shown), `${selector} on paper`);
  const text = await report.evaluate(() => document.querySelector("main").innerText);
  for (const word of ["Residual: mean distance", "Compactness: variance", "Mean ± standard deviation", "\"seed\": 0", "patient-control: displacement along the outward normal, mm", "mode 5"]) assert(text.includes(word), `no "${word}" on paper`);
  for (const word of ["Drag or use", "write its id"]) assert(!text.includes(word), `"${word}" on paper`);
  const figures = await report.locator("#figures figure").evaluateAll((all) => all.map((figure) => {
    const picture = figure.querySelector("canvas");
    const { data } = picture.getContext("2d").getImageData(0, 0, picture.width, picture.height);
    const colors = new Set();
    for (let k = 0; k < data.length; k += 4) colors.add((data[k] >> 3 << 10) | (data[k + 1] >> 3 << 5) | (data[k + 2] >> 3));
    return { colors: colors.size, shown: picture.getBoundingClientRect().width, bar: figure.querySelector(".bar").getBoundingClientRect().width, says: figure.textContent };
  }));
  assert.equal(figures.length, nFigures);
  for (const { colors, shown, bar, says } of figures) assert(colors > 20 && shown > 200 && bar > 50 && /^−[\d.e+-]+.{8}/.test(says), `${says}: ${colors} colors`);
  // A heading is not left alone at the end of a page, and no row is cut in two.
  assert((await report.evaluate(() => getComputedStyle(document.querySelector("h2")).breakAfter)) === "avoid");
  assert((await report.evaluate(() => getComputedStyle(document.querySelector("tr")).breakInside)) === "avoid");
  const pdf = await report.pdf();
  if (h.PICTURES) writeFileSync(join(h.folder, "report.pdf"), pdf);
  assert(pdf.subarray(0, 5).toString() === "%PDF-" && pdf.length > 50_000, `${pdf.length} bytes`);
  await report.emulateMedia({ media: null });
  await report.setViewportSize(before);
}

export function studyTests({ test, service, upload, json, sent, sphere }) {
  test("a study: whom to look at, decisions, maps of contrasts with their units, modes, and the report", async () => {
    const base = service();
    const subjects = [];
    for (let k = 1; k <= 9; k++) {
      const out = join(h.folder, `study-${k}`);
      h.run("phantom", "--subject", String(k), "--kind", "surface", "--edge", "1.8", "--rotate-seed", String(k), "--out", out);
      subjects.push({ id: `sub-0${k}`, input: { mesh_id: await upload(base, join(out, "source.ply")) }, covariates: { group: k % 2 ? "patient" : "control", age: 60 + ((5 * k) % 9) } });
    }
    const ball = join(h.folder, "study-ball.obj");
    writeFileSync(ball, sphere(20, 30));
    subjects.push({ id: "ball", input: { mesh_id: await upload(base, ball) }, covariates: { group: "control", age: 66 } });
    const name = "trial 7";
    const { id } = await json(base, "studies", sent({ subjects, template: subjects[0].input, effect: "group", adjust: ["age"], contrasts: { older: "age" }, permutations: 99, external_ref: name, tags: { cohort: "memory clinic" } }));
    const finished = () => h.until("the study", async () => ((await json(base, `studies/${id}`)).state === "finished" ? true : null), 240_000);

    // A picture that is asked for while the study is computed again is refused.
    const page = await h.tab({ ignore: /status of 409/ });
    await page.goto(base);
    await page.click('nav a:has-text("Studies")');
    await page.click(`a:has-text("${name}")`);
    await page.waitForURL(new RegExp(`#/studies/${id}`));
    await page.waitForSelector("tr[data-subject]");
    await finished();
    await page.waitForSelector("#map", { timeout: 60_000 });
    const zip = async () => unzipped(Buffer.from(await (await fetch(new URL(`v1/studies/${id}/archive`, base))).arrayBuffer()));
    let files = await zip();
    const map = (measure, contrast) => files.get(`maps/${measure}.${contrast}.vtk`);

    // Quality control: the order and the flags of the table, and a picture for each subject that has a match.
    const table = () => files.get("quality.csv").toString().trim().split("\n").slice(1).map((line) => line.split(","));
    const ids = () => page.locator("tr[data-subject]").evaluateAll((rows) => rows.map((row) => row.dataset.subject));
    assert.deepEqual(await ids(), table().map(([id]) => id));
    const ball1 = page.locator('tr[data-subject="ball"]');
    assert((await ball1.textContent()).includes("match not reliable (unlike shape"), await ball1.textContent());
    const flagged = table().filter((row) => row[2] !== "").length;
    assert(flagged >= 1);
    assert.equal(await page.textContent("#verdict"), `${flagged} of ${subjects.length} to look at`);
    assert((await page.textContent(".facts")).includes("memory clinic"));
    await h.until("pictures", async () => {
      await page.locator("tr[data-subject]").last().scrollIntoViewIfNeeded();
      return (await page.locator("tr[data-subject] .picture img").count()) >= subjects.length - 1;
    });
    const shades = await page.locator("tr[data-subject] .picture img").first().evaluate(async (image) => {
      const canvas = new OffscreenCanvas(image.naturalWidth, image.naturalHeight);
      const context = canvas.getContext("2d");
      context.drawImage(image, 0, 0);
      const { data } = context.getImageData(0, 0, canvas.width, canvas.height);
      let [drawn, colored] = [0, 0];
      for (let k = 0; k < data.length; k += 4) {
        drawn += data[k + 3] > 200;
        colored += data[k + 3] > 200 && Math.abs(data[k] - data[k + 2]) > 30;
      }
      return { share: drawn / (data.length / 4), colored };
    });
    assert(shades.share > 0.15 && shades.share < 0.95 && shades.colored > 50, JSON.stringify(shades));
    await page.evaluate(() => scrollTo(0, 0));
    await h.accessible(page, "a study");
    await h.fits(page, "a study");
    await h.picture(page, "study");

    // A map: each vertex that faces the viewer has the color of its value, blue below zero and red above.
    await page.locator("#map").scrollIntoViewIfNeeded();
    await page.waitForTimeout(500);
    const colors = async (values) => {
      const at = await h.pixels(page, "#map");
      const places = await page.evaluate((n) => {
        const { scene } = document.querySelector("#map");
        return Array.from({ length: n }, (_, v) => {
          const { x, y, facing } = scene.project(v);
          return facing > 0.5 && scene.pick(x, y) === v ? { v, x, y } : null;
        }).filter(Boolean);
      }, values.length);
      const top = [...values].map(Math.abs).sort((a, b) => a - b)[Math.floor(0.99 * values.length)];
      const clear = places.filter(({ v }) => Math.abs(values[v]) > 0.4 * top);
      const right = clear.filter(({ v, x, y }) => {
        const [r, , b] = at(x, y);
        return values[v] > 0 ? r > b + 15 : b > r + 15;
      });
      assert(clear.length > 20, `${clear.length} vertices are seen`);
      return right.length / clear.length;
    };
    const shownAs = async (measure, contrast, quantity) => {
      await page.selectOption('section[aria-label="Maps"] label:has-text("Contrast") select', contrast);
      await page.selectOption('section[aria-label="Maps"] label:has-text("Measure") select', measure);
      await page.selectOption('section[aria-label="Maps"] label:has-text("Color by") select', quantity);
      await page.mouse.move(5, 5);
      await page.waitForTimeout(600);
    };
    for (const [measure, contrast, quantity] of [["normal_displacement", "patient-control", "effect"], ["thickness", "older", "hedges_g"]]) {
      await shownAs(measure, contrast, quantity);
      const values = column(map(measure, contrast), quantity);
      const share = await colors(values);
      assert(share > 0.9, `${measure}, ${contrast}: ${share} of the vertices have the color of their value`);
      assert((await colors(values.map((value) => -value))) < 0.1, "the opposite would be seen");
      const bar = await page.locator('section[aria-label="Maps"] .colorbar').textContent();
      assert(bar.includes(quantity === "effect" ? "mm" : "Hedges' g") && bar.includes("≥ ") && bar.includes("≤ −"), bar);
    }
    await shownAs("normal_displacement", "patient-control", "p_tfce_fwe");
    const said = await page.textContent("#map-says");
    const { found } = await json(base, `studies/${id}/result`);
    const { smallest_p: p } = found.maps.find((each) => each.measure === "normal_displacement" && each.contrast === "patient-control");
    assert(said.includes(`Smallest corrected p ${Number(p.toPrecision(2))}`), `${said} ${p}`);
    await page.check('section[aria-label="Maps"] label:has-text("Only local") input');
    await shownAs("normal_displacement", "patient-control", "effect");
    const significant = column(map("normal_displacement", "patient-control"), "p_local").filter((p) => p < 0.05).length;
    if (significant === 0) await assert.rejects(async () => assert((await colors(column(map("normal_displacement", "patient-control"), "effect"))) > 0.3), "all is gray");
    await page.uncheck('section[aria-label="Maps"] label:has-text("Only local") input');
    // By the keyboard, and the values of a vertex.
    await page.focus("#map");
    const before = await page.locator("#map").screenshot();
    await page.keyboard.press("ArrowLeft");
    await page.waitForTimeout(200);
    assert(!before.equals(await page.locator("#map").screenshot()), "arrow keys turn it");
    await page.keyboard.press("Home");
    await page.waitForTimeout(200);
    const box = await page.locator("#map").boundingBox();
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    const readout = page.locator('section[aria-label="Maps"] .readout');
    await h.until("a vertex", async () => /vertex \d+/.test(await readout.textContent()));
    const vertex = Number(/vertex (\d+)/.exec(await readout.textContent())[1]);
    const effect = column(map("normal_displacement", "patient-control"), "effect")[vertex];
    assert((await readout.textContent()).includes(`effect ${Number(effect.toPrecision(3)).toLocaleString("en", { maximumSignificantDigits: 3 })} mm`), `${await readout.textContent()} ${effect}`);
    await page.evaluate(() => document.querySelector('section[aria-label="Maps"]').scrollIntoView());
    await page.evaluate(() => document.activeElement.blur());
    await page.waitForTimeout(300);
    await h.picture(page, "study-maps");

    // A mode: the slider moves the surface between those of the archive.
    await page.locator("#mode").scrollIntoViewIfNeeded();
    await h.until("the mode", () => page.evaluate(() => Boolean(document.querySelector("#mode").scene)));
    const slider = page.locator('section[aria-label="Modes"] input[type="range"]');
    const places = () => page.evaluate(() => {
      const { scene } = document.querySelector("#mode");
      return Array.from(scene.mesh.geometry.getAttribute("position").array);
    });
    await page.selectOption('section[aria-label="Modes"] label:has-text("Mode") select', "2");
    for (const [value, file] of [["2", "plus"], ["-2", "minus"]]) {
      await slider.fill(value);
      const expected = points(files.get(`modes/mode-2-${file}-2sd.vtk`)).flat();
      await h.until(`the mode at ${value}`, async () => (await places()).every((x, k) => Math.abs(x - expected[k]) < 1e-3));
    }
    const mean = points(files.get("mean.vtk")).flat();
    await page.click('section[aria-label="Modes"] button:has-text("Mean")');
    await h.until("the mean", async () => (await places()).every((x, k) => Math.abs(x - mean[k]) < 1e-3));
    await slider.focus();
    await page.keyboard.press("End");
    await page.waitForTimeout(300);
    await page.evaluate(() => document.querySelector('section[aria-label="Modes"]').scrollIntoView());
    await page.evaluate(() => document.activeElement.blur());
    await page.waitForTimeout(300);
    await h.picture(page, "study-modes");

    // The report, in a tab of its own; the archive, as a file.
    const [report] = await Promise.all([page.context().waitForEvent("page"), page.click('button:has-text("Open the report")')]);
    await report.waitForLoadState();
    assert((await report.textContent("h1")).includes(`Study of ${subjects.length} subjects`));
    // Its figures are saved as files that stand alone: plots, and the view with its color bar.
    for (const place of ["p.save:not(#save) >> nth=0", "#save"]) {
      for (const [kind, begin] of [["SVG", Buffer.from("<svg ")], ["PNG", Buffer.from("\x89PNG", "latin1")]]) {
        const [download] = await Promise.all([report.waitForEvent("download"), report.locator(place).locator(`button:has-text("${kind}")`).click()]);
        const bytes = readFileSync(await download.path());
        assert(download.suggestedFilename().endsWith(`.${kind.toLowerCase()}`) && bytes.subarray(0, begin.length).equals(begin), `${place} ${kind}: ${bytes.subarray(0, 40)}`);
        if (kind === "SVG") assert(bytes.toString().includes('xmlns="http://www.w3.org/2000/svg"') && (place !== "#save" || /<image href="data:image\/png;base64,[^"]{2000}/.test(bytes.toString())), place);
        else assert(bytes.length > 4000, `${bytes.length} bytes`);
      }
    }
    await printed(report, subjects.map((subject) => subject.id), 2 * 3 + 5);
    await report.close();
    const [download] = await Promise.all([page.waitForEvent("download"), page.click('button:has-text("Save the archive")')]);
    assert.equal(unzipped(readFileSync(await download.path())).size, files.size);

    // A decision, by the keyboard; the study is computed again, and the page follows.
    const decide = ball1.locator("button");
    await decide.focus();
    await page.keyboard.press("Enter");
    await page.waitForFunction(() => document.activeElement?.getAttribute("aria-label") === "Decision");
    await page.keyboard.press("Tab");
    await page.keyboard.type("a ball, see scan");
    await h.accessible(page, "a decision");
    await h.picture(page, "study-decision");
    await page.keyboard.type(" <img src=x onerror=globalThis.ran=1>");
    await page.keyboard.press("Enter");
    await h.until("the decision", async () => (await json(base, `studies/${id}`)).subjects.find((subject) => subject.id === "ball").decision === "dropped");
    await finished();
    await h.until("the page", async () => (await ball1.getAttribute("data-place")) === "dropped");
    files = await zip();
    assert.deepEqual(await ids(), table().map(([id]) => id));
    assert((await ball1.textContent()).includes("a ball, see scan <img src=x onerror=globalThis.ran=1>"));
    assert.equal(await page.evaluate(() => globalThis.ran), undefined);
    assert.equal(await page.textContent("#verdict"), "No subject stands out");
    await page.click('button[aria-label="Take back the decision about ball"]');
    await h.until("it is taken back", async () => (await ball1.getAttribute("data-place")) === "unreliable", 120_000);

    // The match of a subject, and all matches.
    await page.click('tr[data-subject="ball"] a');
    await page.waitForURL(/#\/jobs\/[0-9a-f-]{36}/);
    await page.goBack();
    await page.click('a:has-text("All matches")');
    await page.waitForURL(new RegExp(`study=${id}`));
    await h.until("the matches", async () => (await page.locator("tr[data-state]").count()) === (await json(base, `jobs?study=${id}`)).jobs.length);
    page.complaints();
    for (const [colorScheme, width, height] of [["dark", 1280, 860], ["light", 390, 844]]) {
      const other = await h.tab({ width, height, colorScheme });
      await other.goto(`${base}#/studies/${id}`);
      await other.waitForSelector("#map", { timeout: 60_000 });
      await other.waitForTimeout(800);
      await h.fits(other, `a study at ${width}`);
      await h.accessible(other, `a study, ${colorScheme}, ${width}`);
      other.complaints();
    }
  });

  test("with a key, report and archive of a study are opened by tickets", async () => {
    const key = h.run("keys", "create", "--init", "--tenant", "clinic-b", "--role", "submitter", "--data-dir", join(h.folder, "study-keys")).match(/hml_\S+/)[0];
    const base = await h.service("study-keys", "--auth", "keys");
    const headers = { authorization: `Bearer ${key}` };
    const subjects = [];
    for (let k = 1; k <= 4; k++) {
      const out = join(h.folder, `keyed-${k}`);
      h.run("phantom", "--subject", String(k), "--kind", "surface", "--edge", "2.4", "--out", out);
      subjects.push({ id: `k${k}`, input: { mesh_id: await upload(base, join(out, "source.ply"), headers) } });
    }
    const attack = "<img src=x onerror=globalThis.ran=1>";
    const request = sent({ subjects, template: subjects[0].input, external_ref: attack, tags: { [attack]: attack } });
    const { id } = await json(base, "studies", { ...request, headers: { ...request.headers, ...headers } });
    await h.until("the study", async () => (await json(base, `studies/${id}`, { headers })).state === "finished", 120_000);
    const page = await h.tab({ ignore: /status of 401/ });
    await page.goto(`${base}#/studies/${id}`);
    await page.fill("form.key input", key);
    await page.click("form.key button");
    await page.waitForSelector("#mode", { timeout: 60_000 });
    await page.waitForSelector('text="No effect was asked for, so there are no maps."');
    assert((await page.textContent("h1")).includes(attack) && (await page.textContent(".columns")).includes(attack));
    assert.equal(await page.evaluate(() => globalThis.ran), undefined);
    const [report] = await Promise.all([page.context().waitForEvent("page"), page.click('button:has-text("Open the report")')]);
    await report.waitForLoadState();
    assert((await report.textContent("h1")).includes("Study of 4 subjects"));
    assert(!report.url().includes(key) && report.url().includes("ticket="), report.url());
    const [download] = await Promise.all([page.waitForEvent("download"), page.click('button:has-text("Save the archive")')]);
    assert(unzipped(readFileSync(await download.path())).has("report.html"));
    page.complaints();
  });
}
