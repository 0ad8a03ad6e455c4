// What a program in TypeScript does with the service, through types that openapi-typescript makes of its document and the client
// openapi-fetch. Usage: node roundtrip.js BASE SOURCE TARGET
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import createClient from "openapi-fetch";
import type { components, paths } from "./schema.js";

type Job = components["schemas"]["JobDocument"];
type Parameters = components["schemas"]["PartialParameters"];

const [base, sourcePath, targetPath] = process.argv.slice(2) as [string, string, string];
const client = createClient<paths>({ baseUrl: base });
const blob = async (path: string) => new Blob([await readFile(path)]);
const [source, target] = [await blob(sourcePath), await blob(targetPath)];

const toForm = (fields: object) => {
  const form = new FormData();
  for (const [name, value] of Object.entries(fields)) {
    form.append(name, value instanceof Blob ? value : typeof value === "object" ? JSON.stringify(value) : String(value));
  }
  return form;
};

async function finished(id: string): Promise<Job> {
  for (;;) {
    const { data } = await client.GET("/v1/jobs/{id}", { params: { path: { id }, query: { wait: 20 } } });
    assert(data);
    if (data.state !== "queued" && data.state !== "running") return data;
  }
}

// A typo in a parameter, and a number where a word is needed, do not compile.
const parameters: Parameters = { method: "rigid", energy: { alpha: 1 }, seed: 3 };
// @ts-expect-error: there is no such parameter
const misspelled: Parameters = { energy: { alfa: 1 } };
assert(misspelled);

// Multipart, and the kinds of answer.
const form = { source, target, parameters, tags: { study: "ts" }, use_cache: true };
const sent = await client.POST("/v1/jobs", { body: form, bodySerializer: toForm });
assert.equal(sent.response.status, 202);
assert(sent.data?.kind === "job");
const job = await finished(sent.data.id);
assert.equal(job.state, "succeeded");
assert.equal(job.parameters, undefined);

const tried = await client.POST("/v1/jobs", {
  params: { query: { validate_only: true } },
  body: form,
  bodySerializer: toForm,
});
assert(tried.data?.kind === "validation");
assert.equal(tried.data.parameters.method, "rigid");

// By reference.
const upload = async (file: Blob) => {
  const { data } = await client.POST("/v1/meshes", { body: { file }, bodySerializer: toForm });
  assert(data);
  return data.id;
};
const [s, t] = [await upload(source), await upload(target)];
const referred = await client.POST("/v1/jobs", {
  params: { header: { "Idempotency-Key": "ts-1" } },
  body: { source: { mesh_id: s }, target: { mesh_id: t }, parameters: { method: "rigid" } },
});
assert(referred.data?.kind === "job");
assert.equal((await finished(referred.data.id)).state, "succeeded");

// The result, and correspondences in each format.
const at = { params: { path: { id: job.id } } };
const result = await client.GET("/v1/jobs/{id}/result", at);
assert.equal(result.data?.transform.matrix.length, 4);
const columns = (await client.GET("/v1/jobs/{id}/correspondences", at)).data;
assert(columns && columns.source.length === columns.target.length);
for (const format of ["json", "csv", "npy", "npz", "arrow", "parquet", "ply", "vtk", "vtp", "gifti", "glb"]) {
  const file = await client.GET("/v1/jobs/{id}/files/{name}", {
    params: { path: { id: job.id, name: `correspondences.${format}` } },
    parseAs: "blob",
  });
  const content: Blob | undefined = file.data;
  assert(content && content.size > 100, format);
}

// A batch, with the template as source.
const batch = await client.POST("/v1/batches", {
  body: { template: { mesh_id: s }, template_as: "source", subjects: [{ input: { mesh_id: t } }], parameters: { method: "rigid", seed: 9 } },
});
assert(batch.data);
for (let done = false; !done; ) {
  const { data } = await client.GET("/v1/batches/{id}", { params: { path: { id: batch.data.id }, query: { wait: 20 } } });
  assert(data);
  done = data.finished;
}
const members = await client.GET("/v1/batches/{id}/jobs", { params: { path: { id: batch.data.id } } });
assert.equal(members.data?.jobs[0]?.state, "succeeded");

// Cancelling, errors, webhooks.
const refused = await client.POST("/v1/jobs/{id}/cancel", at);
assert.equal(refused.response.status, 409);
assert.equal(refused.error?.type, "/problems/job-finished");
const invalid = await client.POST("/v1/jobs", {
  body: { ...form, parameters: { energy: { alpha: -1 } } },
  bodySerializer: toForm,
});
assert.equal(invalid.error?.errors?.[0]?.pointer, "/parameters/energy/alpha");
const slow = await client.POST("/v1/jobs", {
  body: { ...form, use_cache: false, parameters: { method: "metropolis", inference: { max_iterations: 100000 } } },
  bodySerializer: toForm,
});
assert(slow.data?.kind === "job");
const cancelled = await client.POST("/v1/jobs/{id}/cancel", { params: { path: { id: slow.data.id } } });
assert.equal(cancelled.response.status, 202);
assert.equal((await finished(slow.data.id)).state, "cancelled");
const hook = await client.POST("/v1/webhooks", { body: { url: "http://127.0.0.1:9/", states: ["succeeded"] } });
assert(hook.data?.secret);
const listed = await client.GET("/v1/webhooks");
assert.equal(listed.data?.webhooks.length, 1);
const test = await client.POST("/v1/webhooks/{id}/test", { params: { path: { id: hook.data.id } } });
assert.equal(test.response.status, 202);
const removed = await client.DELETE("/v1/webhooks/{id}", { params: { path: { id: hook.data.id } } });
assert.equal(removed.response.status, 204);
console.log("all of it");
