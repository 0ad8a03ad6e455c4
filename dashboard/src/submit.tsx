// Submit a pair: see each surface at once, choose a method, send.

import { useState } from "preact/hooks";
import { ApiError, type FieldFault, type Job, type Mesh, address, call, describe, send } from "./api";
import { tagOf, tagsIn, upload } from "./files";
import { bytes, number } from "./format";
import { Parameters, unflatten, useMethods } from "./parameters";
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
  const [method, setMethod] = useState("balanced");
  const [changed, setChanged] = useState<Record<string, unknown>>({});
  const [priority, setPriority] = useState(0);
  const [reference, setReference] = useState("");
  const [tags, setTags] = useState("");
  const [faults, setFaults] = useState<FieldFault[]>([]);
  const [failure, setFailure] = useState<string | null>(null);
  const [refusal, setRefusal] = useState<{ side: Side; text: string; place: [number, number, number] | null } | null>(null);
  const [isSending, setSending] = useState(false);
  const [names, setNames] = useKept("names", "no");
  const { methods, schemas } = useMethods(setFailure);

  const put = (side: Side, part: Partial<Given>) => setGiven((before) => ({ ...before, [side]: { ...(before[side] ?? { name: "", mesh: null, ply: null, failure: null }), ...part } }));

  const take = async (side: Side, file: Blob, name: string) => {
    setRefusal(null);
    put(side, { name, mesh: null, ply: null, failure: null });
    try {
      const mesh = await upload(file, name);
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
      const body = {
        source: { mesh_id: source!.mesh!.id },
        target: { mesh_id: target!.mesh!.id },
        parameters: unflatten({ method, ...changed }),
        priority,
        tags: { ...(names === "yes" ? { source_file: tagOf(source!.name), target_file: tagOf(target!.name) } : {}), ...tagsIn(tags) },
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
        <span>The source is moved and deformed onto the target, which stays.</span>
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
            Tags <input placeholder="study:baseline" value={tags} onInput={(e) => setTags(e.currentTarget.value)} />
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
      <p class="tools file">
        {given !== null && <span>{`${given.name}${mesh ? `, ${bytes(mesh.n_bytes)}` : ""}`}</span>}
        <label class="button">
          {given === null ? "Choose a file …" : "Another file …"}
          <input class="quiet" type="file" aria-label={`File of the ${side}`} onChange={(e) => take([...(e.currentTarget.files ?? [])])} />
        </label>
        {given === null && <span class="hint">or drop one here.</span>}
      </p>
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
