// Submit a pair: see each surface at once, choose a method, send.

import { useEffect, useState } from "preact/hooks";
import { ApiError, type FieldFault, type Job, type Mesh, address, call, describe, get, send } from "./api";
import { bytes, number, words } from "./format";
import { Check, Facts, Failure, useKept } from "./parts";
import { Preview } from "./preview";
import { go } from "./router";

type Side = "source" | "target";
const SIDES: Side[] = ["source", "target"];

interface Given {
  name: string;
  mesh: Mesh | null;
  ply: ArrayBuffer | null;
  failure: string | null;
}

const LONGEST_PREVIEW_BYTES = 128 << 20;

export function Submit() {
  const [given, setGiven] = useState<Record<Side, Given | null>>({ source: null, target: null });
  const [methods, setMethods] = useState<Method[]>([]);
  const [schemas, setSchemas] = useState<Record<string, Schema>>({});
  const [method, setMethod] = useState("balanced");
  const [changed, setChanged] = useState<Record<string, unknown>>({});
  const [priority, setPriority] = useState(0);
  const [reference, setReference] = useState("");
  const [labels, setLabels] = useState("");
  const [faults, setFaults] = useState<FieldFault[]>([]);
  const [failure, setFailure] = useState<string | null>(null);
  const [refusal, setRefusal] = useState<{ side: Side; text: string; place: [number, number, number] | null } | null>(null);
  const [isSending, setSending] = useState(false);
  const [names, setNames] = useKept("names", "no");

  useEffect(() => {
    get<{ methods: Method[] }>("v1/methods").then(({ methods }) => setMethods(methods), (error: unknown) => setFailure(describe(error)));
    get<{ components: { schemas: Record<string, Schema> } }>("openapi.json").then(({ components }) => setSchemas(components.schemas), (error: unknown) => setFailure(describe(error)));
  }, []);
  const put = (side: Side, part: Partial<Given>) => setGiven((before) => ({ ...before, [side]: { ...(before[side] ?? { name: "", mesh: null, ply: null, failure: null }), ...part } }));

  const take = async (side: Side, file: Blob, name: string) => {
    setRefusal(null);
    put(side, { name, mesh: null, ply: null, failure: null });
    try {
      const answer = await call(`v1/meshes?file_name=${encodeURIComponent(ending(name))}`, { method: "POST", body: file, headers: { "content-type": "application/octet-stream" } });
      const mesh = (await answer.json()) as Mesh;
      put(side, { mesh });
      if (mesh.n_bytes > LONGEST_PREVIEW_BYTES) return;
      const shown = await call(`v1/meshes/${mesh.id}/surface`).catch(() => null);
      if (shown) put(side, { ply: await shown.arrayBuffer() });
    } catch (error) {
      put(side, { failure: describe(error) });
    }
  };
  /** Two files dropped at once are the pair, in the order of their names unless these say which is which. */
  const takeAll = (side: Side, files: File[]) => {
    if (files.length < 2) return files.forEach((file) => void take(side, file, file.name));
    const [a, b] = [...files].sort((x, y) => x.name.localeCompare(y.name));
    const isTurned = /target|fixed|reference/i.test(a!.name) || /source|moving/i.test(b!.name);
    void take("source", isTurned ? b! : a!, (isTurned ? b! : a!).name);
    void take("target", isTurned ? a! : b!, (isTurned ? a! : b!).name);
  };
  const takePhantoms = () =>
    SIDES.forEach((side) => {
      const name = `${side}.nii.gz`;
      fetch(address(`phantoms/${name}`)).then(
        async (answer) => void take(side, await answer.blob(), name),
        (error: unknown) => put(side, { failure: describe(error) }),
      );
    });

  const { source, target } = given;
  const isReady = Boolean(source?.mesh && target?.mesh);
  const submit = async (validateOnly: boolean) => {
    setSending(true);
    setFailure(null);
    setFaults([]);
    setRefusal(null);
    try {
      const pairs = labels.split(/[\s,]+/).filter(Boolean).map((entry) => [entry.slice(0, entry.indexOf(":")), entry.slice(entry.indexOf(":") + 1)]);
      const body = {
        source: { mesh_id: source!.mesh!.id },
        target: { mesh_id: target!.mesh!.id },
        parameters: unflatten({ method, ...changed }),
        priority,
        labels: { ...(names === "yes" ? { source_file: label(source!.name), target_file: label(target!.name) } : {}), ...(Object.fromEntries(pairs) as Record<string, string>) },
        ...(reference === "" ? {} : { external_ref: reference }),
      };
      const answer = await send<Job>("POST", `v1/jobs${validateOnly ? "?validate_only=true" : ""}`, body);
      if (validateOnly) setFailure("");
      else go(`jobs/${answer.id}`);
    } catch (error) {
      setFailure(describe(error));
      if (error instanceof ApiError) {
        const { errors, input, detail, title, place_mm } = error.problem;
        setFaults(errors ?? []);
        if (input === "source" || input === "target") setRefusal({ side: input, text: detail ?? title, place: place_mm ?? null });
      }
    } finally {
      setSending(false);
    }
  };
  const chosen = methods.find(({ name }) => name === method);

  return (
    <div class="submit">
      <h1>Submit a pair</h1>
      <p class="tools">
        <span>The source is moved and bent onto the target, which stays.</span>
        <button onClick={takePhantoms}>Take the two built-in phantoms</button>
      </p>
      <div class="pair">
        {SIDES.map((side) => (
          <Drop key={side} side={side} given={given[side]} refusal={refusal?.side === side ? refusal : null} take={(files) => takeAll(side, files)} />
        ))}
      </div>
      <section class="card">
        <h2>Method</h2>
        <div class="tools">
          <label>
            Method{" "}
            <select
              value={method}
              onChange={(e) => {
                setMethod(e.currentTarget.value);
                setChanged({});
              }}
            >
              {methods.map(({ name }) => (
                <option value={name}>{name}</option>
              ))}
            </select>
          </label>
          <label>
            Priority <input type="number" min={-100} max={100} value={priority} onInput={(e) => setPriority(Number(e.currentTarget.value))} />
          </label>
          <label>
            Reference <input value={reference} onInput={(e) => setReference(e.currentTarget.value)} />
          </label>
          <label>
            Labels <input placeholder="study:baseline" value={labels} onInput={(e) => setLabels(e.currentTarget.value)} />
          </label>
        </div>
        <p>
          <Check label="Keep the names of the files with the job" checked={names === "yes"} onChange={(e) => setNames(e.currentTarget.checked ? "yes" : "no")} /> <span class="soft">They tell jobs apart in the list. Not for names that identify people: whoever may read the job reads them.</span>
        </p>
        <p>{chosen?.description}</p>
        {chosen && <Parameters method={chosen} schemas={schemas} changed={changed} change={setChanged} faults={faults} />}
      </section>
      {failure === "" ? (
        <p class="success" role="status">
          These files and parameters are accepted.
        </p>
      ) : (
        <Failure text={failure} />
      )}
      <div class="tools send">
        <button class="primary" disabled={!isReady || isSending} onClick={() => void submit(false)}>
          Match them
        </button>
        <button disabled={!isReady || isSending} onClick={() => void submit(true)}>
          Only check
        </button>
        {!isReady && <span class="hint">Both surfaces are needed.</span>}
      </div>
    </div>
  );
}

/** A file's name as the value of a label: at most 256 bytes of its end, which tells most. */
export function label(name: string): string {
  let text = name;
  while (new TextEncoder().encode(text).length > 256) text = text.slice(1);
  return text;
}

/** What the service may know of a file's name unless its user says otherwise: its ending. */
export const ending = (name: string): string => `file${/(\.[A-Za-z0-9]{1,8}){1,2}$/.exec(name)?.[0] ?? ""}`;

interface DropProps {
  side: Side;
  given: Given | null;
  refusal: { text: string; place: [number, number, number] | null } | null;
  take: (files: File[]) => void;
}

function Drop({ side, given, refusal, take }: DropProps) {
  const [isOver, setOver] = useState(false);
  const mesh = given?.mesh;
  const topology = mesh?.report?.topology ?? mesh?.problem?.topology;
  const fault = refusal?.place ?? mesh?.problem?.place_mm ?? null;
  const said = refusal?.text ?? (mesh?.problem ? (mesh.problem.detail ?? mesh.problem.title) : null);
  return (
    <section
      class={`card drop ${isOver ? "over" : ""}`}
      aria-label={side}
      onDragOver={(e) => {
        e.preventDefault();
        setOver(true);
      }}
      onDragLeave={() => setOver(false)}
      onDrop={(e) => {
        e.preventDefault();
        setOver(false);
        take([...(e.dataTransfer?.files ?? [])]);
      }}
    >
      <h2>{side === "source" ? "Source" : "Target"}</h2>
      <label class="file">
        {given === null ? "Drop a file here, or choose one: " : `${given.name}${mesh ? `, ${bytes(mesh.n_bytes)}` : ""} `}
        <input type="file" aria-label={`File of the ${side}`} onChange={(e) => take([...(e.currentTarget.files ?? [])])} />
      </label>
      {given === null && <p class="hint">Surfaces: GIFTI, FreeSurfer, PLY, STL, VTK, VTP, OBJ, OFF, MZ3. Label volumes: NIfTI, MGZ, NRRD, MetaImage, DICOM SEG.</p>}
      {given !== null && mesh === null && given.failure === null && <p class="loading">Sending and checking …</p>}
      <Failure text={given?.failure ?? null} />
      {said && (
        <p class="failure" role="alert">
          <b>With default parameters it is refused:</b> {said}
          {fault && ". The place is marked."}
        </p>
      )}
      {mesh && !said && (
        <p class="success" role="status">
          ✓ It can be matched.
        </p>
      )}
      {given?.ply && <Preview ply={given.ply} fault={fault} name={side} />}
      {topology && (
        <Facts
          rows={[
            ["Format", mesh?.report?.format ?? "–"],
            ["Vertices", number(topology.n_vertices)],
            ["Faces", number(topology.n_faces)],
            ["Pieces", number(topology.n_components)],
            ["Genus", topology.genus === null ? "open" : number(topology.genus)],
            ["Boundary edges", number(topology.n_boundary_edges)],
            ["Edges with more than two faces", number(topology.n_nonmanifold_edges)],
            ["Area", `${number(topology.area_mm2)} mm²`],
            ["Volume", topology.volume_mm3 === null ? "–" : `${number(topology.volume_mm3)} mm³`],
            ["Repairs", mesh?.report?.repairs.length ? String(mesh.report.repairs.length) : "none"],
          ]}
        />
      )}
    </section>
  );
}

interface Method {
  name: string;
  description: string;
  defaults: Record<string, unknown>;
}

interface Schema {
  $ref?: string;
  description?: string;
  type?: string | string[];
  enum?: (string | number)[];
  const?: string;
  properties?: Record<string, Schema>;
  oneOf?: Schema[];
  anyOf?: Schema[];
  items?: Schema;
  minimum?: number;
  maximum?: number;
  exclusiveMinimum?: number;
  multipleOf?: number;
}

/** A form for every parameter that is a number, a word or a yes and no; lists are entered as JSON. */
function Parameters({ method, schemas, changed, change, faults }: { method: Method; schemas: Record<string, Schema>; changed: Record<string, unknown>; change: (next: Record<string, unknown>) => void; faults: FieldFault[] }) {
  const resolve = (schema: Schema): Schema => {
    const name = schema.$ref?.split("/").at(-1);
    const found = name === undefined ? undefined : schemas[name];
    if (found) return { ...resolve(found), description: schema.description ?? found.description };
    const only = [...(schema.oneOf ?? []), ...(schema.anyOf ?? [])].filter((part) => part.type !== "null");
    if (only.length === 1) return { ...resolve(only[0]!), description: schema.description ?? only[0]!.description, type: [String(resolve(only[0]!).type), "null"] };
    return schema;
  };
  const at = (path: string[]): unknown => path.reduce<unknown>((value, name) => (value === null || typeof value !== "object" ? undefined : (value as Record<string, unknown>)[name]), method.defaults);
  const set = (name: string, value: unknown, usual: unknown) => {
    const next = { ...changed, [name]: value };
    if (JSON.stringify(value) === JSON.stringify(usual)) delete next[name];
    change(next);
  };
  const fields = (schema: Schema, path: string[]): preact.ComponentChildren =>
    Object.entries(resolve(schema).properties ?? {}).map(([name, part]) => {
      const inner = resolve(part);
      const here = [...path, name];
      if (here.join() === "method") return null;
      if (inner.properties) {
        return (
          <fieldset key={name}>
            <legend>{words(name)}</legend>
            {inner.description && <p class="soft">{inner.description}</p>}
            {fields(inner, here)}
          </fieldset>
        );
      }
      const dotted = here.join(".");
      const usual = at(here);
      const value = dotted in changed ? changed[dotted] : usual;
      const fault = faults.find(({ pointer }) => pointer.replace(/^\/parameters/, "") === `/${here.join("/")}`);
      return <Field key={dotted} name={dotted} schema={inner} value={value} isChanged={dotted in changed} fault={fault} set={(next) => set(dotted, next, usual)} />;
    });
  const n = Object.keys(changed).length;
  return (
    <details>
      <summary>
        Parameters{n > 0 && `: ${n} changed`}
      </summary>
      {n > 0 && <button onClick={() => change({})}>All as the method sets them</button>}
      <div class="fields">{fields({ $ref: "PartialParameters" }, [])}</div>
    </details>
  );
}

const UNITS: [RegExp, string][] = [
  [/_mm$/, "mm"],
  [/_deg$/, "°"],
  [/_ms$/, "ms"],
  [/_s$/, "s"],
  [/_bytes$/, "bytes"],
];

function Field({ name, schema, value, isChanged, fault, set }: { name: string; schema: Schema; value: unknown; isChanged: boolean; fault?: FieldFault; set: (value: unknown) => void }) {
  const [text, setText] = useState<string | null>(null);
  const types = [schema.type ?? []].flat();
  const unit = UNITS.find(([end]) => end.test(name))?.[1];
  const isNumber = types.includes("number") || types.includes("integer");
  const options = schema.enum ?? schema.oneOf?.flatMap((part) => part.const ?? part.enum ?? []);
  const label = words(name.split(".").at(-1)!);
  let input;
  if (options && options.length > 0 && !types.includes("array")) {
    input = (
      <select value={value === null ? "null" : String(value)} onChange={(e) => set(e.currentTarget.value === "null" ? null : e.currentTarget.value)}>
        {(types.includes("null") || value === null) && <option value="null">not set</option>}
        {options.map((option) => (
          <option value={String(option)}>{String(option)}</option>
        ))}
      </select>
    );
  } else if (types.includes("boolean")) {
    input = (
      <select value={String(value)} onChange={(e) => set(e.currentTarget.value === "null" ? null : e.currentTarget.value === "true")}>
        {(types.includes("null") || value === null) && <option value="null">not set</option>}
        <option value="true">yes</option>
        <option value="false">no</option>
      </select>
    );
  } else if (isNumber) {
    input = (
      <input
        type="number"
        step={types.includes("integer") ? (schema.multipleOf ?? 1) : "any"}
        min={schema.minimum}
        max={schema.maximum}
        placeholder={types.includes("null") ? "not set" : undefined}
        value={value === null || value === undefined ? "" : String(value)}
        onChange={(e) => set(e.currentTarget.value === "" ? null : Number(e.currentTarget.value))}
      />
    );
  } else {
    input = (
      <input
        value={text ?? JSON.stringify(value ?? null)}
        spellcheck={false}
        onInput={(e) => setText(e.currentTarget.value)}
        onChange={(e) => {
          try {
            set(JSON.parse(e.currentTarget.value));
            setText(null);
          } catch {
            // It stays as it was typed, until it is JSON.
          }
        }}
      />
    );
  }
  const range = [schema.minimum !== undefined && `at least ${number(schema.minimum)}`, schema.maximum !== undefined && `at most ${number(schema.maximum)}`].filter(Boolean).join(", ");
  return (
    <div class={`field ${isChanged ? "changed" : ""}`}>
      <label>
        <span>
          {label} {unit && <span class="soft">({unit})</span>}
        </span>{" "}
        {input}
      </label>
      <p class="soft">
        {schema.description} {range && `(${range})`}
      </p>
      {fault && <Failure text={fault.detail} />}
    </div>
  );
}

/** `{"a.b": 1}` as `{a: {b: 1}}`. */
export function unflatten(values: Record<string, unknown>): Record<string, unknown> {
  const out: Record<string, unknown> = {};
  for (const [name, value] of Object.entries(values)) {
    const path = name.split(".");
    const last = path.pop()!;
    const inner = path.reduce<Record<string, unknown>>((at, part) => (at[part] ??= {}) as Record<string, unknown>, out);
    inner[last] = value;
  }
  return out;
}
