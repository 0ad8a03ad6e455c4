// Files that are sent, and what the service may know of their names.

import { type Mesh, call } from "./api";

/** What the service may know of a file's name unless its user says otherwise: its ending. */
const ending = (name: string): string => `file${/(\.[A-Za-z0-9]{1,8}){1,2}$/.exec(name)?.[0] ?? ""}`;

export async function upload(file: Blob, name: string, signal?: AbortSignal): Promise<Mesh> {
  const answer = await call(`v1/meshes?file_name=${encodeURIComponent(ending(name))}`, { method: "POST", body: file, headers: { "content-type": "application/octet-stream" }, signal });
  return (await answer.json()) as Mesh;
}

/** A name as the value of a tag or as a reference: at most 256 bytes of its end, which tells most. */
export function tagOf(name: string): string {
  let text = name;
  while (new TextEncoder().encode(text).length > 256) text = text.slice(1);
  return text;
}

/** `study:baseline, side:left` as tags. */
export const tagsIn = (text: string): Record<string, string> =>
  Object.fromEntries(text.split(/[\s,]+/).filter(Boolean).map((entry) => [entry.slice(0, entry.indexOf(":")), entry.slice(entry.indexOf(":") + 1)]));

export interface Named {
  file: File;
  /** Its name with those of the folders that it was taken with. */
  path: string;
}

/** Notes and pictures that lie beside surfaces in a folder. */
const BESIDE = /(^|\/)\.|\.(json|txt|csv|tsv|md|log|html?|pdf|png|jpe?g|gif|svg|zip|xml|py|m|sh)$/i;

const sorted = (files: Named[]): Named[] => [...files].sort((a, b) => a.path.localeCompare(b.path, "en", { numeric: true }));

/** The files of an input: all that were chosen, or of a folder those that may be surfaces. */
export function chosen(list: Iterable<File>): Named[] {
  const files = [...list].map((file) => ({ file, path: file.webkitRelativePath || file.name }));
  return sorted(files.filter(({ file, path }) => !file.webkitRelativePath || !BESIDE.test(path)));
}

/** The files of what was dropped, folders with all that is below them. */
export async function dropped(transfer: DataTransfer | null): Promise<Named[]> {
  const entries = [...(transfer?.items ?? [])].flatMap((item) => item.webkitGetAsEntry?.() ?? []);
  // Files that were made by a script have no entry.
  if (entries.length === 0) return chosen(transfer?.files ?? []);
  const found: Named[] = [];
  const walk = async (entry: FileSystemEntry, isInside: boolean): Promise<void> => {
    const path = entry.fullPath.replace(/^\//, "");
    if (entry.isFile) {
      if (isInside && BESIDE.test(path)) return;
      found.push({ file: await new Promise((resolve, reject) => (entry as FileSystemFileEntry).file(resolve, reject)), path });
      return;
    }
    const reader = (entry as FileSystemDirectoryEntry).createReader();
    // A reader answers with about a hundred at a time.
    for (;;) {
      const part: FileSystemEntry[] = await new Promise((resolve, reject) => reader.readEntries(resolve, reject));
      if (part.length === 0) return;
      for (const inner of part) await walk(inner, true);
    }
  };
  for (const entry of entries) await walk(entry, false);
  return sorted(found);
}

/** A name for each file: up to its first dot, with its folders where that names several. */
export function references(paths: string[]): string[] {
  const stem = (path: string) => path.split("/").at(-1)!.split(".").find(Boolean) ?? path;
  const stems = paths.map(stem);
  const inFolders = paths.map((path, k) => [...path.split("/").slice(0, -1), stems[k]!].join("/"));
  // The folder that all are in tells nothing.
  const top = paths.every((path) => path.includes("/") && path.split("/")[0] === paths[0]!.split("/")[0]);
  const short = top ? inFolders.map((name) => name.slice(name.indexOf("/") + 1)) : inFolders;
  for (const names of [stems, short, paths]) if (new Set(names).size === names.length) return names.map(tagOf);
  return paths.map((path, k) => tagOf(`${path} ${k + 1}`));
}
