// Slices of a volume under the outlines of the surfaces, against the volume's file and the surfaces of the API, which are read here
// without the page.

import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { gunzipSync, gzipSync } from "node:zlib";
import * as h from "./harness.mjs";
import { vertices } from "./surfaces.mjs";

const AXES = { Sagittal: [0, 1, 2], Coronal: [1, 0, 2], Axial: [2, 0, 1] };

/** The voxels of a NIfTI-1 file with an sform, little-endian, of 8 or 16 bits: a function from RAS to the value, null outside. */
function volume(bytes) {
  const data = gunzipSync(bytes);
  const dims = [42, 44, 46].map((at) => data.readInt16LE(at));
  const kind = data.readInt16LE(70);
  assert([2, 4, 512].includes(kind) && data.readInt16LE(254) > 0, "the phantom is as it was");
  const m = Array.from({ length: 12 }, (_, k) => data.readFloatLE(280 + 4 * k));
  const offset = data.readFloatLE(108);
  const det = (a, b, c) => a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
  const columns = [0, 1, 2].map((k) => [m[k], m[4 + k], m[8 + k]]);
  const whole = det(...columns);
  return (place) => {
    const d = place.map((x, k) => x - m[4 * k + 3]);
    // Cramer's rule.
    const voxel = [0, 1, 2].map((k) => Math.round(det(...columns.map((column, c) => (c === k ? d : column))) / whole));
    if (voxel.some((x, k) => x < 0 || x >= dims[k])) return null;
    const at = voxel[0] + dims[0] * (voxel[1] + dims[1] * voxel[2]);
    return kind === 2 ? data.readUInt8(offset + at) : data.readInt16LE(offset + 2 * at);
  };
}

export function sliceTests({ test, service, submit, finished, api, json }) {
  test("slices show the voxels at their places, the outlines of the surfaces, and one crosshair for them and the picture in 3D", async () => {
    const base = service();
    const files = ["source", "target"].map((side) => fileURLToPath(new URL(`../static/phantom-${side}.nii.gz`, import.meta.url)));
    const id = await submit(base, files);
    await finished(base, id);
    const target = vertices(Buffer.from(await (await api(base, `jobs/${id}/surfaces/target?format=ply`)).arrayBuffer()));
    const source = vertices(Buffer.from(await (await api(base, `jobs/${id}/surfaces/source?format=ply`)).arrayBuffer()));
    const { transform } = await json(base, `jobs/${id}/result?correspondences=false`);
    const page = await h.tab();
    await page.goto(`${base}#/jobs/${id}`);
    await page.waitForSelector(".slice canvas", { timeout: 60_000 });
    const canvas = (name) => `canvas[data-plane="${name}"]`;
    const project = (name, place) => page.evaluate(([selector, place]) => document.querySelector(selector).project(place), [canvas(name), place]);
    const crosshair = async () => (await page.textContent("#crosshair")).match(/R (\S+), A (\S+), S (\S+) mm/).slice(1).map(Number);
    const isGray = ([r, g, b]) => Math.abs(r - g) < 8 && Math.abs(g - b) < 8;
    const isOf = (color) => ([r, g, b]) => Math.abs(r - color[0]) < 40 && Math.abs(g - color[1]) < 40 && Math.abs(b - color[2]) < 40;
    const [ofTarget, ofSource] = [isOf([0xe6, 0x9f, 0x00]), isOf([0x56, 0xb4, 0xe9])];

    let nearby = 0;
    for (const [which, bytes] of [["target", readFileSync(files[1])], ["source", readFileSync(files[0])]]) {
      await page.check(`section[aria-label="Slices"] label:has-text("the ${which}'s label volume") input`);
      await page.waitForSelector(canvas("Axial"));
      await page.waitForTimeout(500);
      const value = volume(bytes);
      const point = await crosshair();
      for (const [name, [across, right, up]] of Object.entries(AXES)) {
        await page.locator(canvas(name)).scrollIntoViewIfNeeded();
        await page.waitForTimeout(150);
        const at = await h.pixels(page, canvas(name));
        const box = await page.locator(canvas(name)).boundingBox();
        // Voxels: bright in the structure, dark outside of it, and nothing outside of the volume.
        let [inside, outside, wrong] = [0, 0, 0];
        for (let i = 0; i < 40; i++) for (let j = 0; j < 40; j++) {
          const place = [0, 0, 0];
          place[across] = point[across];
          const span = (axis) => {
            const all = (which === "target" ? target : source).map((p) => p[axis]);
            return [Math.min(...all) - 4, Math.max(...all) + 4];
          };
          for (const [axis, k] of [[right, i], [up, j]]) {
            const [low, high] = span(axis);
            place[axis] = low + ((k + 0.5) / 40) * (high - low);
          }
          const found = value(place);
          const [x, y] = await project(name, place).then((xy) => xy);
          if (x < 20 || y < 20 || x > box.width - 20 || y > box.height - 20) continue;
          const color = at(x, y);
          // Lines lie over some of them.
          if (!isGray(color)) continue;
          found ? inside++ : outside++;
          wrong += found ? color[0] < 60 : color[0] > 60;
        }
        assert(inside > 40 && outside > 40, `${which}, ${name}: ${inside} inside, ${outside} outside`);
        // At the border of a voxel a pixel may be that of its neighbor.
        assert(wrong < 0.03 * (inside + outside), `${which}, ${name}: ${wrong} of ${inside + outside} pixels are not those of their voxels`);
        // Outlines: a vertex near the plane has the color of its surface at its place.
        const placed = which === "target" ? target : source;
        const near = placed.filter((p) => Math.abs(p[across] - point[across]) < 0.12);
        let seen = 0;
        for (const p of near) {
          const [x, y] = await project(name, p);
          let hit = false;
          for (let dx = -3; dx <= 3; dx++) for (let dy = -3; dy <= 3; dy++) hit ||= (which === "target" ? ofTarget : ofSource)(at(x + dx, y + dy)) || (which === "target" ? ofSource : ofTarget)(at(x + dx, y + dy));
          seen += hit;
        }
        nearby += near.length;
        assert(seen >= 0.9 * near.length, `${which}, ${name}: ${seen} of ${near.length} vertices lie on an outline`);
      }
    }

    assert(nearby > 20, `${nearby} vertices lie near the planes`);

    // The crosshair: pressed on a slice, it moves in the two others and in 3D.
    await page.check(`section[aria-label="Slices"] label:has-text("the target's label volume") input`);
    await page.waitForSelector(canvas("Axial"));
    await page.waitForTimeout(300);
    const goal = target[Math.floor(target.length / 3)];
    const inScene = () => page.evaluate(() => {
      const { target } = document.querySelector("#view").scene.crosses;
      return [target.visible, target.position.toArray()];
    });
    for (const name of ["Axial", "Sagittal"]) {
      await page.locator(canvas(name)).scrollIntoViewIfNeeded();
      const [x, y] = await project(name, goal);
      await page.locator(canvas(name)).click({ position: { x, y } });
    }
    await h.until("the crosshair", async () => (await crosshair()).every((x, k) => Math.abs(x - goal[k]) < 0.4));
    await h.until("the crosshair in 3D", async () => {
      const [isVisible, place] = await inScene();
      return isVisible && place.every((x, k) => Math.abs(x - goal[k]) < 0.4);
    });
    assert.equal(Number(/value (\S+)/.exec(await page.textContent("#crosshair"))[1]), volume(readFileSync(files[1]))(await page.evaluate(() => document.querySelector("#view").scene.crosses.target.position.toArray())) ?? NaN);
    await page.locator(".slices").scrollIntoViewIfNeeded();
    await h.accessible(page, "slices");
    await h.fits(page, "slices");
    await page.setViewportSize({ width: 1280, height: 1180 });
    await page.evaluate(() => document.querySelector("#view").scrollIntoView());
    await page.waitForTimeout(500);
    await h.picture(page, "job-slices");
    await page.setViewportSize({ width: 1280, height: 860 });
    await page.waitForTimeout(300);
    // By the keyboard, a voxel at a time.
    await page.focus(canvas("Coronal"));
    const before = await crosshair();
    await page.keyboard.press("ArrowRight");
    await page.keyboard.press("PageUp");
    await page.keyboard.press("PageUp");
    await h.until("keys move it", async () => {
      const after = await crosshair();
      return Math.abs(after[0] - before[0] - 1) < 0.11 && Math.abs(after[1] - before[1] - 2) < 0.11 && after[2] === before[2];
    });
    // Pressed on a surface in 3D.
    const vertex = await page.evaluate(() => {
      const { scene } = document.querySelector("#view");
      scene.mark(null);
      const n = scene.pair.target.getAttribute("position").count;
      for (let v = 0; v < n; v++) {
        const { x, y, facing } = scene.project("target", v);
        const seen = facing > 0.8 ? scene.pick(x, y) : null;
        if (seen?.side === "target" && seen.vertex === v) return { v, x, y };
      }
    });
    await page.locator("#view").click({ position: { x: vertex.x, y: vertex.y } });
    await h.until("a press in 3D", async () => (await crosshair()).every((x, k) => Math.abs(x - target[vertex.v][k]) < 0.06));
    const moved = (p) => transform.matrix.slice(0, 3).map((row) => row[0] * p[0] + row[1] * p[1] + row[2] * p[2] + row[3]);
    const ofSourceVertex = await page.evaluate(() => {
      const { scene } = document.querySelector("#view");
      const n = scene.pair.source.getAttribute("position").count;
      for (let v = 0; v < n; v++) {
        const { x, y, facing } = scene.project("source", v);
        const seen = facing > 0.8 ? scene.pick(x, y) : null;
        if (seen?.side === "source" && seen.vertex === v) return { v, x, y };
      }
    });
    await page.locator("#view").click({ position: { x: ofSourceVertex.x, y: ofSourceVertex.y } });
    await h.until("a press on the source", async () => (await crosshair()).every((x, k) => Math.abs(x - moved(source[ofSourceVertex.v])[k]) < 0.06));

    // A file of one's own stays in the browser; of a kind that cannot be shown it is said.
    const asked = [];
    page.on("request", (request) => request.method() !== "GET" && asked.push(request.url()));
    const own = join(h.folder, "own.nii");
    writeFileSync(own, gunzipSync(readFileSync(files[1])));
    await page.setInputFiles('input[aria-label^="A volume of yours"]', own);
    await page.waitForSelector(canvas("Axial"));
    const cut = join(h.folder, "cut.nii.gz");
    writeFileSync(cut, gzipSync(gunzipSync(readFileSync(files[1])).subarray(0, 2000)));
    const complex = gunzipSync(readFileSync(files[1]));
    complex.writeInt16LE(32, 70);
    writeFileSync(join(h.folder, "complex.nii"), complex);
    for (const [file, said] of [[cut, "ends too early"], [join(h.folder, "complex.nii"), "of a kind that is not shown"], [new URL(import.meta.url).pathname, "no volume of NIfTI, NRRD, MetaImage or MGH"]]) {
      await page.setInputFiles('input[aria-label^="A volume of yours"]', file);
      await page.waitForSelector(`section[aria-label="Slices"] .failure:has-text("${said}")`);
    }
    assert.deepEqual(asked, []);
    page.complaints();
  });
}
