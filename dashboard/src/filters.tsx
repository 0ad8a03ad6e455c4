// Filters of the list of jobs that this browser keeps under a name.

import { useState } from "preact/hooks";
import { useKept } from "./parts";
import { go } from "./router";

export const FILTERS = ["state", "method", "tag", "external_ref", "batch", "study", "order"] as const;
export type Filters = Record<(typeof FILTERS)[number], string>;

interface Saved {
  name: string;
  filters: Partial<Filters>;
}

/** What was kept, as far as it can be read. */
function savedIn(text: string): Saved[] {
  try {
    const list: unknown = JSON.parse(text);
    const saved = Array.isArray(list) ? list.filter((entry): entry is Saved => typeof entry?.name === "string" && typeof entry.filters === "object" && entry.filters !== null) : [];
    // Up to 0.1 a tag was kept as a label.
    return saved.map(({ name, filters: { label, ...filters } }: { name: string; filters: Partial<Filters> & { label?: string } }) => ({ name, filters: label ? { ...filters, tag: label } : filters }));
  } catch {
    return [];
  }
}

const isSame = (a: Partial<Filters>, b: Partial<Filters>): boolean => FILTERS.every((name) => (a[name] ?? "") === (b[name] ?? ""));

export function SavedFilters({ filters, isFiltered }: { filters: Filters; isFiltered: boolean }) {
  const [kept, keep] = useKept("filters", "[]");
  const [name, setName] = useState<string | null>(null);
  const all = savedIn(kept);
  const current = all.find((saved) => isSame(saved.filters, filters));
  const save = () => {
    const text = (name ?? "").trim();
    if (text !== "") keep(JSON.stringify([...all.filter((saved) => saved.name !== text), { name: text, filters }]));
    setName(null);
  };
  return (
    <>
      {all.length > 0 && (
        <label>
          Saved filters{" "}
          <select value={current?.name ?? ""} onChange={(e) => go("jobs", all.find((saved) => saved.name === e.currentTarget.value)?.filters ?? {}, true)}>
            <option value="">none</option>
            {all.map((saved) => (
              <option value={saved.name}>{saved.name}</option>
            ))}
          </select>
        </label>
      )}
      {current ? (
        <button type="button" onClick={() => keep(JSON.stringify(all.filter((saved) => saved !== current)))}>
          Forget “{current.name}”
        </button>
      ) : (
        isFiltered &&
        (name === null ? (
          <button type="button" onClick={() => setName("")}>
            Save these filters …
          </button>
        ) : (
          <span class="group">
            <input
              aria-label="Name of these filters"
              placeholder="name"
              value={name}
              onInput={(e) => setName(e.currentTarget.value)}
              onKeyDown={(e) => {
                if (e.key === "Enter") save();
                else if (e.key === "Escape") setName(null);
              }}
            />
            <button type="button" onClick={save}>
              Save
            </button>
          </span>
        ))
      )}
    </>
  );
}
