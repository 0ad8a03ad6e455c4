// A form for the method of a match and its parameters, made from the schema of the service.

import { useEffect, useState } from "preact/hooks";
import { type FieldFault, describe, get } from "./api";
import { number, words } from "./format";
import { Failure } from "./parts";

export interface Method {
  name: string;
  description: string;
  defaults: Record<string, unknown>;
}

export interface Schema {
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
export function Parameters({ method, schemas, changed, change, faults }: { method: Method; schemas: Record<string, Schema>; changed: Record<string, unknown>; change: (next: Record<string, unknown>) => void; faults: FieldFault[] }) {
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

/** The methods of the service, and the schemas of its parameters. */
export function useMethods(failed: (text: string) => void): { methods: Method[]; schemas: Record<string, Schema> } {
  const [methods, setMethods] = useState<Method[]>([]);
  const [schemas, setSchemas] = useState<Record<string, Schema>>({});
  useEffect(() => {
    get<{ methods: Method[] }>("v1/methods").then(({ methods }) => setMethods(methods), (error: unknown) => failed(describe(error)));
    get<{ components: { schemas: Record<string, Schema> } }>("openapi.json").then(({ components }) => setSchemas(components.schemas), (error: unknown) => failed(describe(error)));
  }, []);
  return { methods, schemas };
}
