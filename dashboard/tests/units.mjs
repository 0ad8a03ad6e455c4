// Parts of the page that need no browser, over many made-up inputs: names of files, tables, archives.

import assert from "node:assert/strict";
import http from "node:http";
import { build } from "esbuild";
import { fileURLToPath } from "node:url";
import * as h from "./harness.mjs";

/** A module of the page, as node can load it. */
export async function load(name) {
  const { outputFiles } = await build({ entryPoints: [fileURLToPath(new URL(`../src/${name}`, import.meta.url))], bundle: true, format: "esm", jsx: "automatic", jsxImportSource: "preact", write: false, logLevel: "error" });
  return import(`data:text/javascript;base64,${Buffer.from(outputFiles[0].text).toString("base64")}`);
}

/** Numbers from 0 to 1 by a linear congruence: the same in every run. */
export function random(seed) {
  let state = seed >>> 0;
  return () => (state = (Math.imul(state, 1664525) + 1013904223) >>> 0) / 2 ** 32;
}

/** A zip archive whose files are stored as they are; `wide`: with all places and sizes in 64 bits, as those of more than 4 GiB. */
function zipped(files, wide) {
  const parts = [];
  const directory = [];
  let at = 0;
  for (const [name, bytes] of files) {
    const text = Buffer.from(name);
    const head = Buffer.alloc(30);
    head.writeUInt32LE(0x04034b50, 0);
    head.writeUInt32LE(bytes.length, 18);
    head.writeUInt32LE(bytes.length, 22);
    head.writeUInt16LE(text.length, 26);
    // Its own header has another extra field than the directory has.
    const padding = Buffer.alloc(text.length % 7 === 0 ? 8 : 0);
    head.writeUInt16LE(padding.length, 28);
    const extra = Buffer.alloc(wide ? 28 : 0);
    if (wide) {
      extra.writeUInt16LE(1, 0);
      extra.writeUInt16LE(24, 2);
      [bytes.length, bytes.length, at].forEach((value, k) => extra.writeBigUInt64LE(BigInt(value), 4 + 8 * k));
    }
    const entry = Buffer.alloc(46);
    entry.writeUInt32LE(0x02014b50, 0);
    entry.writeUInt32LE(wide ? 0xffffffff : bytes.length, 20);
    entry.writeUInt32LE(wide ? 0xffffffff : bytes.length, 24);
    entry.writeUInt16LE(text.length, 28);
    entry.writeUInt16LE(extra.length, 30);
    entry.writeUInt32LE(wide ? 0xffffffff : at, 42);
    directory.push(entry, text, extra);
    parts.push(head, text, padding, bytes);
    at += 30 + text.length + padding.length + bytes.length;
  }
  const listed = Buffer.concat(directory);
  const end = Buffer.alloc(22);
  end.writeUInt32LE(0x06054b50, 0);
  end.writeUInt16LE(wide ? 0xffff : files.length, 10);
  end.writeUInt32LE(wide ? 0xffffffff : listed.length, 12);
  end.writeUInt32LE(wide ? 0xffffffff : at, 16);
  const end64 = Buffer.alloc(wide ? 76 : 0);
  if (wide) {
    end64.writeUInt32LE(0x06064b50, 0);
    [files.length, listed.length, at].forEach((value, k) => end64.writeBigUInt64LE(BigInt(value), 32 + 8 * k));
    end64.writeUInt32LE(0x07064b50, 56);
    end64.writeBigUInt64LE(BigInt(at + listed.length), 64);
  }
  return Buffer.concat([...parts, listed, end64, end]);
}

export function unitTests({ test }) {
  test("names of files tell subjects apart, whatever they are called", async () => {
    const { references } = await load("files.ts");
    assert.deepEqual(references(["a/sub-01/left.nii.gz", "a/sub-02/left.nii.gz"]), ["sub-01/left", "sub-02/left"]);
    assert.deepEqual(references(["sub-01.nii.gz", "sub-02.ply"]), ["sub-01", "sub-02"]);
    const next = random(1);
    const pick = (list) => list[Math.floor(next() * list.length)];
    for (let round = 0; round < 400; round++) {
      const n = 1 + Math.floor(next() * 12);
      const name = () => `${pick(["", "."])}${pick(["left", "right", "lh", "ä".repeat(300), "x"])}${pick(["", ".1", ".nii"])}${pick(["", ".gz", ".ply"])}`;
      const paths = [...new Set(Array.from({ length: n }, () => Array.from({ length: Math.floor(next() * 3) }, () => pick(["a", "b", "sub.1"])).concat(name()).join("/")))];
      const names = references(paths);
      assert.equal(names.length, paths.length);
      assert(names.every((name) => name !== "" && Buffer.byteLength(name) <= 256), JSON.stringify([paths, names]));
      // Of equal names longer than 256 bytes nothing is left that tells them apart.
      if (paths.every((path) => !path.includes("ää"))) assert.equal(new Set(names).size, names.length, JSON.stringify([paths, names]));
    }
  });

  test("tables are read as they were written", async () => {
    const { readCsv } = await load("csv.ts");
    const next = random(2);
    const letters = ['"', ",", "\n", "\r\n", "'", "=", "a", "é", " ", ""];
    const cell = () => Array.from({ length: Math.floor(next() * 5) }, () => letters[Math.floor(next() * letters.length)]).join("");
    // As the service writes text: in quotes where needed, and with an apostrophe where a spreadsheet would compute.
    const written = (text) => {
      const safe = /^[=+\-@\t\r\n]/.test(text) ? `'${text}` : text;
      return /[",\r\n]/.test(safe) ? `"${safe.replaceAll('"', '""')}"` : safe;
    };
    for (let round = 0; round < 500; round++) {
      const columns = ["id", "why", "x"].slice(0, 1 + Math.floor(next() * 3));
      // An apostrophe before such a sign cannot be told from the one that the service puts there.
      const rows = Array.from({ length: 1 + Math.floor(next() * 4) }, () => Object.fromEntries(columns.map((name) => [name, `${name === "id" ? "s" : ""}${cell().replace(/^'+/, "")}`])));
      const text = [columns.join(","), ...rows.map((row) => columns.map((name) => written(row[name])).join(","))].join("\n") + "\n";
      assert.deepEqual(readCsv(text), rows, JSON.stringify(text));
    }
  });

  test("a small line of energies joins only what can be compared, and stays within its picture", async () => {
    const { lastRun, outline } = await load("spark.tsx");
    const next = random(4);
    const pick = (list) => list[Math.floor(next() * list.length)];
    const run = ({ quantity, start, round, phase }) => [quantity ?? (phase === "displacement" ? "field_energy" : "curvature_energy"), start, round, phase].join();
    let lines = 0;
    for (let round = 0; round < 2000; round++) {
      let point = {};
      const points = Array.from({ length: Math.floor(next() * 14) }, (_, k) => {
        if (k === 0 || next() < 0.2) point = { quantity: pick([undefined, "bethe", "field_energy"]), start: pick([undefined, 0, 1]), round: pick([0, 1]), phase: pick(["inference", "registration", "displacement"]) };
        return { ...point, seq: k + 1, iteration: k, ...(next() < 0.8 ? { energy: pick([1, -1, 1e6, 1e-9, 0]) * next() } : {}) };
      });
      const line = lastRun(points);
      const known = points.filter(({ energy }) => energy !== undefined);
      const last = known.findLastIndex((point, k) => k > 0 && run(point) === run(known[k - 1]));
      assert.equal(line === null, last < 0);
      if (line === null) continue;
      lines++;
      let first = last;
      while (first > 0 && run(known[first - 1]) === run(known[last])) first--;
      assert.deepEqual(line.values, known.slice(first, last + 1).map(({ energy }) => energy));
      const places = outline(line.values).split(" ").map((pair) => pair.split(",").map(Number));
      assert.equal(places.length, line.values.length);
      assert(places.every(([x, y]) => x >= 0 && x <= 80 && y >= 0 && y <= 22), outline(line.values));
      // What is higher is drawn higher.
      line.values.forEach((value, k) => k > 0 && assert((value - line.values[k - 1]) * (places[k][1] - places[k - 1][1]) <= 0));
    }
    assert(lines > 500, `${lines} lines`);
  });

  test("single files of archives are read, small and large, by parts and from servers that know none", async () => {
    globalThis.sessionStorage ??= { getItem: () => null };
    globalThis.document ??= {};
    const { Archive } = await load("zip.ts");
    const next = random(3);
    let [archive, etag, knowsRanges, sent] = [Buffer.alloc(0), '"1"', true, 0];
    const server = http.createServer((request, response) => {
      const asked = /^bytes=(\d*)-(\d*)$/.exec(request.headers.range ?? "");
      const applies = knowsRanges && asked && [undefined, etag].includes(request.headers["if-range"]);
      const [from, to] = !applies ? [0, archive.length] : asked[1] === "" ? [Math.max(0, archive.length - Number(asked[2])), archive.length] : [Number(asked[1]), Math.min(archive.length, Number(asked[2]) + 1)];
      sent += to - from;
      response.writeHead(applies ? 206 : 200, { etag, ...(applies ? { "content-range": `bytes ${from}-${to - 1}/${archive.length}` } : {}) }).end(archive.subarray(from, to));
    });
    await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
    h.atEnd(() => (server.closeAllConnections(), server.close()));
    globalThis.document.baseURI = `http://127.0.0.1:${server.address().port}/`;
    for (const wide of [false, true]) {
      for (const ranges of [true, false]) {
        for (const n of [0, 1, 7, 3000]) {
          const files = Array.from({ length: n }, (_, k) => [`part/ä${"x".repeat(k % 9)}-${k}.vtk`, Buffer.from(Array.from({ length: Math.floor(next() * 90) }, () => Math.floor(next() * 256)))]);
          [archive, knowsRanges] = [zipped(files, wide), ranges];
          const opened = await Archive.open("archive");
          assert.deepEqual(opened.names(), files.map(([name]) => name));
          for (const [name, bytes] of files.filter((_, k) => k % 500 < 3)) assert(bytes.equals(Buffer.from(await opened.bytes(name))), name);
          await assert.rejects(opened.bytes("missing"), /cannot be read/);
        }
      }
    }
    // Of a large archive little is sent.
    const files = Array.from({ length: 40 }, (_, k) => [`${k}.vtk`, Buffer.alloc(100_000, k)]);
    [archive, knowsRanges, sent] = [zipped(files, false), true, 0];
    const opened = await Archive.open("archive");
    assert(files[20][1].equals(Buffer.from(await opened.bytes("20.vtk"))));
    assert(sent < 200_000, `${sent} bytes of ${archive.length}`);
    // Another archive in its place is noticed, and so is one that is cut off.
    etag = '"2"';
    await assert.rejects(opened.bytes("21.vtk"), /computed again/);
    archive = archive.subarray(0, archive.length - 30);
    await assert.rejects(Archive.open("archive"), /cannot be read/);
  });
}
