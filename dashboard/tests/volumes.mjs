// Volumes of every format that the page reads, written here from one truth; and those that the service alone reads, which the page
// shows as NIfTI.

import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { deflateSync, gunzipSync, gzipSync } from "node:zlib";
import * as h from "./harness.mjs";
import { load, random } from "./units.mjs";

/** Numbers as bytes; `kind` is the name of a method of DataView without its beginning. */
function bytesOf(values, kind, little) {
  const width = Number(/\d+/.exec(kind)[0]) / 8;
  const view = new DataView(new ArrayBuffer(width * values.length));
  values.forEach((value, k) => view[`set${kind}`](k * width, kind.startsWith("Big") ? BigInt(value) : value, little));
  return Buffer.from(view.buffer);
}

/** The columns of an affine from voxels to RAS: three axes and the origin, as `signs` turn them. */
const turned = (affine, signs) => affine.map((column) => column.map((x, axis) => x * signs[axis]));

export function nrrd({ dims, values, affine }, { kind = "Int16", little = true, gzip = false, space = "left-posterior-superior", unit = null, skip = 0 } = {}) {
  const names = { Uint8: "uchar", Int16: "short", Uint16: "uint16", Int32: "int", Float32: "float", Float64: "double", BigInt64: "long long" };
  const signs = { "left-posterior-superior": [-1, -1, 1], LAS: [-1, 1, 1], "right-anterior-superior": [1, 1, 1] }[space];
  const scale = { '"m"': 1000, '"cm"': 10 }[unit] ?? 1;
  const vector = (column) => `(${column.map((x) => x / scale).join(",")})`;
  const [x, y, z, origin] = turned(affine, signs);
  const fields = [`type: ${names[kind]}`, "dimension: 3", `space: ${space}`, `sizes: ${dims.join(" ")}`, `space directions: ${[x, y, z].map(vector).join(" ")}`, `endian: ${little ? "little" : "big"}`, `encoding: ${gzip ? "gzip" : "raw"}`, `space origin: ${vector(origin)}`, ...(unit ? [`space units: ${unit} ${unit} ${unit}`] : []), ...(skip ? [`byte skip: ${skip}`] : []), "Segment0_Name:=a : b"];
  const before = Buffer.alloc(skip > 0 ? skip : 7);
  const raw = skip ? Buffer.concat([before, bytesOf(values, kind, little)]) : bytesOf(values, kind, little);
  return Buffer.concat([Buffer.from(`NRRD0004\n# a comment\n${fields.join("\n")}\n\n`), gzip ? gzipSync(raw) : raw]);
}

export function metaImage({ dims, values, affine }, { kind = "Int16", little = true, zlib = false } = {}) {
  const names = { Uint8: "MET_UCHAR", Int16: "MET_SHORT", Uint16: "MET_USHORT", Int32: "MET_INT", Float32: "MET_FLOAT", Float64: "MET_DOUBLE", BigInt64: "MET_LONG_LONG" };
  const [x, y, z, origin] = turned(affine, [-1, -1, 1]);
  const sizes = [x, y, z].map((axis) => Math.hypot(...axis));
  const raw = zlib ? deflateSync(bytesOf(values, kind, little)) : bytesOf(values, kind, little);
  const fields = ["ObjectType = Image", "NDims = 3", "BinaryData = True", `BinaryDataByteOrderMSB = ${little ? "False" : "True"}`, `CompressedData = ${zlib ? "True" : "False"}`, ...(zlib ? [`CompressedDataSize = ${raw.length}`] : []), `TransformMatrix = ${[x, y, z].flatMap((axis, k) => axis.map((c) => c / sizes[k])).join(" ")}`, `Offset = ${origin.join(" ")}`, `ElementSpacing = ${sizes.join(" ")}`, `DimSize = ${dims.join(" ")}`, `ElementType = ${names[kind]}`, "ElementDataFile = LOCAL"];
  return Buffer.concat([Buffer.from(`${fields.join("\n")}\n`), raw]);
}

export function mgh({ dims, values, affine }, { kind = "Int16", gzip = false } = {}) {
  const head = Buffer.alloc(284);
  [1, ...dims, 1, { Uint8: 0, Int32: 1, Float32: 3, Int16: 4, Uint16: 10 }[kind], 0].forEach((value, k) => head.writeInt32BE(value, 4 * k));
  head.writeInt16BE(1, 28);
  const [x, y, z, origin] = affine;
  const sizes = [x, y, z].map((axis) => Math.hypot(...axis));
  const center = origin.map((o, k) => o + (dims[0] * x[k] + dims[1] * y[k] + dims[2] * z[k]) / 2);
  [...sizes, ...[x, y, z].flatMap((axis, k) => axis.map((c) => c / sizes[k])), ...center].forEach((value, k) => head.writeFloatBE(value, 30 + 4 * k));
  const whole = Buffer.concat([head, bytesOf(values, kind, false)]);
  return gzip ? gzipSync(whole) : whole;
}

/** The dimensions, voxels and affine of a NIfTI-1 file with an sform, little-endian, of 8, 16 or 32 bits. */
export function niftiTruth(file) {
  const data = file[0] === 0x1f ? gunzipSync(file) : file;
  const dims = [42, 44, 46].map((at) => data.readInt16LE(at));
  const [kind, offset] = [data.readInt16LE(70), data.readFloatLE(108)];
  const read = { 2: (k) => data.readUInt8(offset + k), 4: (k) => data.readInt16LE(offset + 2 * k), 512: (k) => data.readUInt16LE(offset + 2 * k), 8: (k) => data.readInt32LE(offset + 4 * k), 768: (k) => data.readUInt32LE(offset + 4 * k) }[kind];
  assert(read && data.readInt16LE(254) > 0, `a NIfTI file of kind ${kind}`);
  const row = (k) => [0, 1, 2, 3].map((c) => data.readFloatLE(280 + 16 * k + 4 * c));
  const rows = [row(0), row(1), row(2)];
  return { dims, values: Array.from({ length: dims[0] * dims[1] * dims[2] }, (_, k) => read(k)), affine: [0, 1, 2, 3].map((c) => rows.map((r) => r[c])) };
}

function same(volume, truth, what) {
  assert.deepEqual([...volume.dims], truth.dims, what);
  assert.deepEqual([...volume.values], truth.values, what);
  const e = volume.worldFromVoxel.elements;
  truth.affine.forEach((column, c) => column.forEach((x, k) => assert(Math.abs(e[4 * c + k] - x) < 1e-3, `${what}: ${e[4 * c + k]} at ${k}, ${c} instead of ${x}`)));
}

export function volumeTests({ test, service, submit, finished, api, json }) {
  test("volumes of NRRD, MetaImage and MGH are read as they were written, whatever the numbers, orders and spaces", async () => {
    const { readVolume } = await load("volumes.ts");
    const next = random(11);
    const between = (low, high) => low + next() * (high - low);
    for (let n = 0; n < 20; n++) {
      const dims = [0, 1, 2].map(() => Math.floor(between(1, 9)));
      const values = Array.from({ length: dims[0] * dims[1] * dims[2] }, () => Math.floor(between(0, 250)));
      // A rotation about each axis, with voxels of three sizes, left- or right-handed.
      const [a, b] = [between(-3, 3), between(-1.5, 1.5)];
      const turn = [[Math.cos(a), Math.sin(a), 0], [-Math.sin(a) * Math.cos(b), Math.cos(a) * Math.cos(b), Math.sin(b)], [Math.sin(a) * Math.sin(b), -Math.cos(a) * Math.sin(b), Math.cos(b)]];
      const affine = [...turn.map((axis, k) => { const size = between(0.4, 3) * (k === 2 && n % 2 ? -1 : 1); return axis.map((c) => c * size); }), [between(-90, 90), between(-90, 90), between(-90, 90)]];
      const truth = { dims, values, affine };
      const read = async (bytes, what) => same(await readVolume(new Blob([bytes])), truth, `${n}: ${what}`);
      for (const kind of ["Uint8", "Int16", "Uint16", "Int32", "Float32", "Float64", "BigInt64"]) {
        const little = next() < 0.5;
        for (const space of ["left-posterior-superior", "LAS", "right-anterior-superior"]) await read(nrrd(truth, { kind, little, gzip: next() < 0.5, space, unit: ['"m"', '"cm"', null][n % 3] }), `NRRD ${kind} ${space}`);
        await read(nrrd(truth, { kind, little, gzip: n % 2 === 0, skip: n % 3 ? 13 : -1 }), `NRRD ${kind} with bytes to skip`);
        await read(metaImage(truth, { kind, little, zlib: next() < 0.5 }), `MetaImage ${kind}`);
        if (!["Float64", "BigInt64"].includes(kind)) await read(mgh(truth, { kind, gzip: next() < 0.5 }), `MGH ${kind}`);
      }
    }
    const truth = { dims: [2, 2, 2], values: [0, 1, 2, 3, 4, 5, 6, 7], affine: [[1, 0, 0], [0, 1, 0], [0, 0, 1], [0, 0, 0]] };
    const cut = (bytes) => bytes.subarray(0, bytes.length - 3);
    const dicom = Buffer.alloc(600);
    dicom.write("DICM", 128);
    const text = (bytes, from, to) => Buffer.from(bytes.toString("latin1").replace(from, to), "latin1");
    for (const [bytes, said] of [
      [cut(nrrd(truth)), /ends too early/],
      [cut(metaImage(truth)), /ends too early/],
      [cut(mgh(truth)), /ends too early/],
      [text(nrrd(truth), "encoding: raw", "encoding: hex"), /encoding that is not shown/],
      [text(nrrd(truth), "\n\n", "\ndata file: a.raw\n\n"), /in another file/],
      [text(nrrd(truth), "type: short", "type: block"), /of a kind that is not shown/],
      [text(nrrd(truth), "sizes: 2 2 2", "sizes: 2 2 2 2"), /not three dimensions/],
      [text(nrrd(truth), "sizes: 2 2 2", "sizes: 9999 9999 99"), /too large/],
      [text(metaImage(truth), "= LOCAL", "= a.raw"), /in another file/],
      [Buffer.from("NRRD0004\ntype: short\n"), /ends within its header/],
      [dicom, /dcm2niix/],
      [Buffer.from("x".repeat(600)), /no volume of NIfTI, NRRD, MetaImage or MGH/],
    ]) await assert.rejects(readVolume(new Blob([bytes])), said);
  });

  test("slices of label volumes in every format, and of files sent with a job", async () => {
    const base = service();
    const phantom = ["source", "target"].map((side) => fileURLToPath(new URL(`../static/phantom-${side}.nii.gz`, import.meta.url)));
    const truth = niftiTruth(readFileSync(phantom[1]));
    const files = { nrrd: nrrd(truth, { gzip: true }), mha: metaImage(truth, { zlib: true }), mgz: mgh(truth, { gzip: true }) };
    const jobs = {};
    for (const [ending, bytes] of Object.entries(files)) {
      const file = join(h.folder, `volume.${ending}`);
      writeFileSync(file, bytes);
      jobs[ending] = await submit(base, [phantom[0], file], { method: "rigid" });
    }
    // Sent with the job instead of as an upload.
    const form = new FormData();
    for (const [k, side] of ["source", "target"].entries()) form.append(side, new Blob([readFileSync(phantom[k])]), `${side}.nii.gz`);
    form.append("parameters", JSON.stringify({ method: "rigid", seed: 5 }));
    jobs.sent = (await json(base, "jobs", { method: "POST", body: form })).id;
    await finished(base, jobs.sent);
    // A segmentation of DICOM on the grid of the target, from the service itself.
    const segmented = join(h.folder, "volume.dcm");
    writeFileSync(segmented, Buffer.from(await (await api(base, `jobs/${jobs.sent}/warped?format=dicom&study_uid=1.2.3&target_frame_uid=1.2.4`)).arrayBuffer()));
    jobs.dcm = await submit(base, [phantom[0], segmented], { method: "rigid" });
    const page = await h.tab();
    for (const [format, id] of Object.entries(jobs)) {
      const job = await finished(base, id);
      assert.equal(job.state, "succeeded", `${format}: ${JSON.stringify(job.error)}`);
      const volume = niftiTruth(Buffer.from(await (await api(base, `jobs/${id}/volumes/target`)).arrayBuffer()));
      // The voxels of a segmentation may have another order of axes.
      if (format !== "dcm") same({ ...volume, worldFromVoxel: { elements: volume.affine.flatMap((column) => [...column, 0]) } }, truth, format);
      await page.goto(`${base}#/jobs/${id}`);
      await page.waitForSelector(`section[aria-label="Slices"] label:has-text("the target's label volume")`, { timeout: 60_000 });
      await h.until(`slices of ${format}`, async () => /value \d/.test((await page.textContent("#crosshair").catch(() => "")) ?? ""));
      // Voxels of the structure are bright, others dark.
      await page.locator('canvas[data-plane="Axial"]').scrollIntoViewIfNeeded();
      await page.waitForTimeout(200);
      const box = await page.locator('canvas[data-plane="Axial"]').boundingBox();
      const at = await h.pixels(page, 'canvas[data-plane="Axial"]');
      let [bright, dark] = [0, 0];
      for (let x = 20; x < box.width - 20; x += 4) for (let y = 20; y < box.height - 20; y += 4) {
        const [r, g, b] = at(x, y);
        if (Math.abs(r - g) > 8 || Math.abs(g - b) > 8) continue;
        if (r > 200) bright++;
        else if (r < 40) dark++;
      }
      assert(bright > 50 && dark > 50, `${format}: ${bright} bright and ${dark} dark points`);
    }
    // A surface has no volume, and says so.
    const missing = await fetch(new URL(`v1/jobs/${jobs.sent}/volumes/aligned`, base));
    assert.equal(missing.status, 404);
    // A file of one's own in another format.
    const own = join(h.folder, "own.nrrd");
    writeFileSync(own, files.nrrd);
    await page.setInputFiles('input[aria-label^="A volume of yours"]', own);
    await h.until("the own file", async () => /value \d/.test((await page.textContent("#crosshair").catch(() => "")) ?? ""));
    page.complaints();
  });
}
