// A batch from files: one template against all of a folder, each file checked as soon as it is there.

import { useRef, useState } from "preact/hooks";
import { ApiError, type Batch, type FieldFault, type Mesh, describe, send } from "./api";
import { type Named, chosen, dropped, tagOf, tagsIn, references, upload } from "./files";
import { bytes, number } from "./format";
import { answered } from "./live";
import { Parameters, unflatten, useMethods } from "./parameters";
import { Badge, Bar, Check, Failure, useKept, useWork } from "./parts";
import { go } from "./router";

interface Given extends Named {
  key: number;
  mesh: Mesh | null;
  failure: string | null;
}

/** Files that are sent at the same time. */
const AT_ONCE = 3;
/** Rows that are shown; what is wrong comes first. */
const SHOWN = 200;

/** Why a file cannot be matched with default parameters. */
const refusalOf = ({ mesh, failure }: Given): string | null => failure ?? (mesh?.problem ? [mesh.problem.title, mesh.problem.detail].filter(Boolean).join(": ") : null);

export function NewBatch() {
  const [template, setTemplate] = useState<Given | null>(null);
  const [subjects, setSubjects] = useState<Given[]>([]);
  const [side, setSide] = useState<"target" | "source">("target");
  const [method, setMethod] = useState("balanced");
  const [changed, setChanged] = useState<Record<string, unknown>>({});
  const [reference, setReference] = useState("");
  const [tags, setTags] = useState("");
  const [faults, setFaults] = useState<FieldFault[]>([]);
  const [failure, setFailure] = useState<string | null>(null);
  const [isSending, setSending] = useState(false);
  const [names, setNames] = useKept("names", "no");
  const { methods, schemas } = useMethods(setFailure);
  /** Files that wait to be sent; those of them that were taken out are not. */
  const queue = useRef<Given[]>([]);
  const kept = useRef(new Set<number>());
  const next = useRef(0);
  const stop = useRef<AbortSignal | null>(null);
  const sending = useRef(0);
  useWork((signal) => void (stop.current = signal), []);

  const put = (key: number, part: Partial<Given>) => {
    const renew = (given: Given) => (given.key === key ? { ...given, ...part } : given);
    setTemplate((before) => before && renew(before));
    setSubjects((before) => before.map(renew));
  };
  const work = async () => {
    if (sending.current >= AT_ONCE) return;
    sending.current++;
    for (let given = queue.current.shift(); given && !stop.current?.aborted; given = queue.current.shift()) {
      const { key, file } = given;
      if (!kept.current.has(key)) continue;
      try {
        put(key, { mesh: await answered(() => upload(file, file.name, stop.current!), stop.current!) });
      } catch (error) {
        put(key, { failure: describe(error) });
      }
    }
    sending.current--;
  };
  const take = (files: Named[]): Given[] => {
    const given = files.map((named) => ({ ...named, key: next.current++, mesh: null, failure: null }));
    given.forEach(({ key }) => kept.current.add(key));
    queue.current.push(...given);
    for (let k = 0; k < AT_ONCE; k++) void work();
    return given;
  };
  const takeTemplate = (files: Named[]) => {
    if (files[0] === undefined) return;
    if (template) kept.current.delete(template.key);
    setTemplate(take([files[0]])[0]!);
  };
  const takeSubjects = (files: Named[]) => {
    const known = new Set(subjects.map(({ path }) => path));
    setSubjects([...subjects, ...take(files.filter(({ path }) => !known.has(path)))]);
  };
  const leaveOut = (key: number | null) => {
    subjects.forEach((given) => (key === null || given.key === key) && kept.current.delete(given.key));
    setSubjects(key === null ? [] : subjects.filter((given) => given.key !== key));
  };

  const called = references(subjects.map(({ path }) => path));
  const refused = subjects.filter((given) => refusalOf(given) !== null).length;
  const ready = subjects.filter((given) => given.mesh !== null && refusalOf(given) === null);
  const waiting = subjects.length - refused - ready.length;
  const isReady = template?.mesh && refusalOf(template) === null && ready.length > 0 && waiting === 0;
  const submit = async () => {
    setSending(true);
    setFailure(null);
    setFaults([]);
    try {
      const batch = await send<Batch>("POST", "v1/batches", {
        template: { mesh_id: template!.mesh!.id },
        template_as: side,
        subjects: ready.map((given, k) => ({
          input: { mesh_id: given.mesh!.id },
          external_ref: names === "yes" ? called[subjects.indexOf(given)]! : `subject ${String(k + 1).padStart(3, "0")}`,
          tags: names === "yes" ? { [side === "target" ? "source_file" : "target_file"]: tagOf(given.path) } : {},
        })),
        parameters: unflatten({ method, ...changed }),
        tags: { ...(names === "yes" ? { [side === "target" ? "target_file" : "source_file"]: tagOf(template!.path) } : {}), ...tagsIn(tags) },
        ...(reference === "" ? {} : { external_ref: reference }),
      });
      go(`batches/${batch.id}`);
    } catch (error) {
      setFailure(describe(error));
      if (error instanceof ApiError) setFaults(error.problem.errors ?? []);
      setSending(false);
    }
  };
  const method_ = methods.find(({ name }) => name === method);
  // What is wrong first: of a thousand files it is looked for.
  const rows = subjects.map((given, k) => ({ given, name: called[k]! })).sort((a, b) => Number(refusalOf(b.given) !== null) - Number(refusalOf(a.given) !== null));
  return (
    <div class="submit">
      <h1>New batch</h1>
      <p>One template is matched with every subject. Files are checked as soon as they are here; those that cannot be matched are left out.</p>
      <div class="pair">
        <Area title="Template" take={takeTemplate} label="File of the template" many={false}>
          {template === null ? <p class="hint">Drop a file here: the surface that all are compared with, such as a mean, an atlas, or one of the subjects.</p> : <p>{template.path} <Told given={template} /></p>}
        </Area>
        <Area title="Subjects" take={takeSubjects} label="Files of the subjects" many>
          <p role="status">
            {subjects.length === 0 ? (
              <span class="hint">Drop a folder or many files here. Notes and pictures in a folder are passed over.</span>
            ) : (
              <>
                <Bar share={(subjects.length - waiting) / subjects.length} label="Files that are checked" /> {number(ready.length)} of {number(subjects.length)} can be matched{refused > 0 && `, ${number(refused)} cannot`}
                {waiting > 0 && `, ${number(waiting)} are being sent`}.{" "}
              </>
            )}
          </p>
          {subjects.length > 0 && <button onClick={() => leaveOut(null)}>Take all out</button>}
        </Area>
      </div>
      {subjects.length > 0 && (
        <div class="scroll files" tabIndex={0} role="region" aria-label="Files of the subjects">
          <table>
            <thead>
              <tr>
                <th scope="col">Subject</th>
                <th scope="col">File</th>
                <th scope="col">State</th>
                <th scope="col" class="numeric">
                  Vertices
                </th>
                <th scope="col" class="numeric">
                  Size
                </th>
                <th scope="col">
                  <span class="quiet">Actions</span>
                </th>
              </tr>
            </thead>
            <tbody>
              {rows.slice(0, SHOWN).map(({ given, name }) => (
                <tr key={given.key}>
                  <td>{name}</td>
                  <td>{given.path}</td>
                  <td class="why">
                    <Told given={given} />
                  </td>
                  <td class="numeric">{number(given.mesh?.n_vertices)}</td>
                  <td class="numeric">{bytes(given.file.size)}</td>
                  <td>
                    <button aria-label={`Take out ${name}`} onClick={() => leaveOut(given.key)}>
                      Take out
                    </button>
                  </td>
                </tr>
              ))}
            </tbody>
          </table>
        </div>
      )}
      {rows.length > SHOWN && <p class="hint">{number(rows.length - SHOWN)} more.</p>}
      <section class="card section">
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
            The template is{" "}
            <select value={side} onChange={(e) => setSide(e.currentTarget.value as "target" | "source")}>
              <option value="target">the target, and stays</option>
              <option value="source">the source, and is moved</option>
            </select>
          </label>
          <label>
            Reference <input value={reference} onInput={(e) => setReference(e.currentTarget.value)} />
          </label>
          <label>
            Tags <input placeholder="study:baseline" value={tags} onInput={(e) => setTags(e.currentTarget.value)} />
          </label>
        </div>
        <p>
          <Check label="Name the jobs by their files" checked={names === "yes"} onChange={(e) => setNames(e.currentTarget.checked ? "yes" : "no")} />{" "}
          <span class="soft">Else they are numbered, in the order of the table. Not for names that identify people: whoever may read the jobs reads them.</span>
        </p>
        <p>{method_?.description}</p>
        {method_ && <Parameters method={method_} schemas={schemas} changed={changed} change={setChanged} faults={faults} />}
      </section>
      <Failure text={failure} />
      <div class="tools send">
        <button class="primary" disabled={!isReady || isSending} onClick={() => void submit()}>
          Match {number(ready.length)} {ready.length === 1 ? "subject" : "subjects"}
        </button>
        {!isReady && <span class="hint">{template === null ? "A template is needed." : waiting > 0 ? "Files are being sent." : "A template and a subject that can be matched are needed."}</span>}
      </div>
    </div>
  );
}

/** What is known of a file. */
function Told({ given }: { given: Given }) {
  const refusal = refusalOf(given);
  return (
    <>
      {refusal !== null ? <Badge tone="bad">cannot be matched</Badge> : given.mesh !== null ? <Badge tone="good">✓ can be matched</Badge> : <Badge tone="wait">being sent</Badge>} {refusal ?? ""}
    </>
  );
}

interface AreaProps {
  title: string;
  label: string;
  many: boolean;
  take: (files: Named[]) => void;
  children: preact.ComponentChildren;
}

/** Where files are dropped or chosen. */
function Area({ title, label, many, take, children }: AreaProps) {
  const [isOver, setOver] = useState(false);
  const input = (name: string, isFolder: boolean) => (
    <label class="button">
      {name}
      <input
        class="quiet"
        type="file"
        multiple={many}
        {...(isFolder ? { webkitdirectory: true } : {})}
        aria-label={`${label}${isFolder ? ", a folder" : ""}`}
        onChange={(e) => {
          take(chosen(e.currentTarget.files ?? []));
          e.currentTarget.value = "";
        }}
      />
    </label>
  );
  return (
    <section
      class={`card drop ${isOver ? "over" : ""}`}
      aria-label={title}
      onDragOver={(e) => {
        e.preventDefault();
        setOver(true);
      }}
      onDragLeave={() => setOver(false)}
      onDrop={(e) => {
        e.preventDefault();
        setOver(false);
        void dropped(e.dataTransfer).then(take);
      }}
    >
      <h2>{title}</h2>
      <p class="tools">
        {input(many ? "Choose files …" : "Choose a file …", false)}
        {many && input("Choose a folder …", true)}
      </p>
      {children}
    </section>
  );
}
