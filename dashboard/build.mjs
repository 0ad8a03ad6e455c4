// Builds the page into dist/: one script and one style sheet, named by their content. The same sources and versions give the
// same bytes.
import { build } from "esbuild";
import { createHash } from "node:crypto";
import { copyFileSync, mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { basename, dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";

const here = dirname(fileURLToPath(import.meta.url));
const out = process.argv[2] ?? join(here, "dist");
rmSync(out, { recursive: true, force: true });
mkdirSync(out, { recursive: true });

const result = await build({
  absWorkingDir: here,
  entryPoints: ["src/main.tsx", "src/style.css"],
  entryNames: "[name]-[hash]",
  outdir: out,
  bundle: true,
  minify: true,
  format: "esm",
  target: "es2022",
  jsx: "automatic",
  jsxImportSource: "preact",
  legalComments: "none",
  charset: "utf8",
  metafile: true,
  logLevel: "warning",
});
const names = Object.keys(result.metafile.outputs).map((path) => basename(path));
const script = names.find((name) => name.startsWith("main-") && name.endsWith(".js"));
const style = names.find((name) => name.startsWith("style-") && name.endsWith(".css"));
const drawing = readFileSync(join(here, "static/icon.svg"));
const icon = `icon-${createHash("sha256").update(drawing).digest("hex").slice(0, 8)}.svg`;
writeFileSync(join(out, icon), drawing);
const page = readFileSync(join(here, "src/index.html"), "utf8").replace("SCRIPT", script).replace("STYLE", style)
  .replace("ICON", icon);
writeFileSync(join(out, "index.html"), page);
for (const name of ["phantom-source.nii.gz", "phantom-target.nii.gz"]) {
  copyFileSync(join(here, "static", name), join(out, name));
}

// Licenses of what is bundled travel with it.
const packages = new Set(
  Object.keys(result.metafile.inputs)
    .map((path) => /node_modules\/((?:@[^/]+\/)?[^/]+)/.exec(path)?.[1])
    .filter(Boolean),
);
const notices = [...packages].sort().map((name) => {
  const folder = join(here, "node_modules", name);
  const { version, license } = JSON.parse(readFileSync(join(folder, "package.json"), "utf8"));
  const text = ["LICENSE", "LICENSE.md", "license"].map((file) => read(join(folder, file))).find(Boolean) ?? license;
  return `${name} ${version}\n\n${text.trim()}\n`;
});
writeFileSync(join(out, "licenses.txt"), notices.join("\n----\n\n"));

function read(path) {
  try {
    return readFileSync(path, "utf8");
  } catch {
    return undefined;
  }
}

const sizes = [script, style].map((name) => gzipSync(readFileSync(join(out, name))).length);
console.log(`built: ${script} ${sizes[0]} bytes, ${style} ${sizes[1]} bytes compressed`);
