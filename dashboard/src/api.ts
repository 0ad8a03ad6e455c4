// The HTTP API of the service. Every address is relative to the page, so that a proxy may serve both under any path.

export interface FieldFault {
  pointer: string;
  code: string;
  detail: string;
}

export interface Problem {
  type: string;
  title: string;
  status: number;
  detail?: string;
  input?: string;
  request_id?: string;
  errors?: FieldFault[];
  topology?: Topology;
  place_mm?: [number, number, number];
}

export interface Topology {
  n_vertices: number;
  n_edges: number;
  n_faces: number;
  n_components: number;
  n_boundary_edges: number;
  n_nonmanifold_edges: number;
  n_nonmanifold_vertices: number;
  euler_characteristic: number;
  genus: number | null;
  oriented: boolean;
  area_mm2: number;
  volume_mm3: number | null;
}

export interface InputReport {
  format: string;
  space?: string;
  repairs: unknown[];
  notes?: string[];
  topology: Topology;
  /** Of label volumes alone. */
  sampling?: unknown;
}

export interface JobInput {
  hash: string;
  n_bytes: number;
  n_vertices: number;
  n_faces: number;
  report: InputReport;
}

export type JobState = "queued" | "running" | "succeeded" | "failed" | "cancelled" | "expired" | "dead";
export const STATES: JobState[] = ["queued", "running", "succeeded", "failed", "cancelled", "expired", "dead"];

export interface Job {
  id: string;
  state: JobState;
  method: string;
  method_version: string;
  /** Only if the request asks for them. */
  parameters?: Record<string, unknown>;
  source: JobInput;
  target: JobInput;
  priority: number;
  tags: Record<string, string>;
  external_ref?: string;
  batch_id?: string;
  study_id?: string;
  attempt: number;
  max_attempts: number;
  progress?: { fraction: number; phase: string; message?: string };
  queue_position?: number;
  eta_ms?: number;
  energy_latest?: number;
  created_at: string;
  started_at?: string;
  finished_at?: string;
  cancel_requested: boolean;
  cached: boolean;
  reliable?: boolean | null;
  unreliable_reasons?: string[];
  warnings?: string[];
  surface_distance?: { mean_mm: number; p95_mm: number; max_mm: number };
  retry_of?: string;
  error?: Problem;
  links: Record<string, string>;
}

export interface TracePoint {
  seq: number;
  round: number;
  phase: string;
  iteration: number;
  energy?: number;
  energy_unary?: number;
  energy_pairwise?: number;
  lower_bound?: number;
  support?: number;
  temperature?: number;
  elapsed_ms?: number;
  /** What the energy is of, and where it began: where the service says so. */
  quantity?: string;
  start?: number | string;
  chosen?: boolean;
}

/** What the energy of a point is of: energies of different quantities have different scales. */
export const quantityOf = (point: TracePoint): string => point.quantity ?? (point.phase === "displacement" && point.energy !== undefined ? "field_energy" : "curvature_energy");

/** Points that can be compared: of one quantity, from one start, of one round or fit, and found in one way. */
export const runOf = (point: TracePoint): string => [quantityOf(point), point.start ?? "", point.round, point.phase].join("/");

export interface Batch {
  id: string;
  n_jobs: number;
  counts: Partial<Record<JobState, number>>;
  finished: boolean;
  tags: Record<string, string>;
  external_ref?: string;
  created_at: string;
}

export interface Mesh {
  id: string;
  n_bytes: number;
  created_at: string;
  suitable?: boolean;
  n_vertices?: number;
  n_faces?: number;
  report?: InputReport;
  problem?: Problem;
}

export type StudyState = "queued" | "matching" | "modelling" | "finished" | "failed" | "cancelled";

export interface Study {
  id: string;
  state: StudyState;
  progress: { template_round: number; matches_done: number; matches_total: number };
  n_subjects: number;
  method: string;
  tags: Record<string, string>;
  external_ref?: string;
  created_at: string;
  finished_at?: string;
  error?: Problem;
  subjects?: StudySubject[];
  links: Record<string, string | undefined>;
}

export interface StudySubject {
  id: string;
  role: "model" | "score";
  decision?: "kept" | "dropped";
  reason?: string;
}

export interface StudyResult {
  settings: { analysis?: { effect?: string | null; adjust?: string[]; permutations?: number } };
  found: {
    subjects: Record<"model" | "scored" | "dropped" | "unreliable" | "failed", number>;
    model: { variances_mm2: number[]; compactness: number[] };
    maps: { measure: string; contrast: string; smallest_p: number; significant_share: number }[];
  };
}

export interface Result {
  transform: { matrix: number[][]; rotation_angle_deg: number; translation_mm: number[] };
  support: { inliers: number; ratio: number; rms_mm: number; tolerance_mm: number };
  surface_distance: { mean_mm: number; p95_mm: number; max_mm: number };
  energy?: { initial: number; final: number; unary: number; pairwise: number; broken_edges: number; lower_bound?: number };
  deformation?: { folded_triangles: number; folded_area_share: number; area_ratio: number; area_ratio_p05: number; area_ratio_p95: number; volume_ratio: number | null };
  topology: { consistency: number; coverage: number; flipped_triangles: number; n_triangles: number };
  rounds: { round: number; feedback: string; iterations: number; energy?: number; support?: number; chosen: boolean }[];
  reliability?: {
    reliable: boolean;
    reasons: string[];
    misfit: number;
    runner_up_misfit?: number;
    other_handedness_misfit?: number;
    curvature_agreement: number;
    distortion?: number;
    normal_agreement: number;
    residual_mm: number;
    second_opinion?: { angle_deg: number; agreement: number };
  };
  timings_ms: Record<string, number>;
  provenance: { version: string; commit: string; seed: number; [key: string]: unknown };
  stop_reason: string;
}

/** What went wrong, in the words of the service where it has answered. */
export class ApiError extends Error {
  constructor(readonly problem: Problem) {
    super(problem.detail ?? problem.title);
  }
}

const KEY = "homolog-key";
let listeners: (() => void)[] = [];

/** The key is kept for this tab alone, until it is closed. */
export const key = {
  get: (): string | null => sessionStorage.getItem(KEY),
  set(value: string | null): void {
    if (value === null) sessionStorage.removeItem(KEY);
    else sessionStorage.setItem(KEY, value);
  },
};

/** Calls `listener` whenever the service asks for a key. */
export function onKeyNeeded(listener: () => void): () => void {
  listeners.push(listener);
  return () => {
    listeners = listeners.filter((other) => other !== listener);
  };
}

export const address = (path: string): URL => new URL(path, document.baseURI.split("#")[0]);

export async function call(path: string, init: RequestInit = {}): Promise<Response> {
  const headers = new Headers(init.headers);
  const secret = key.get();
  if (secret !== null) headers.set("authorization", `Bearer ${secret}`);
  const response = await fetch(address(path), { ...init, headers, cache: init.cache ?? "no-cache" });
  if (response.status === 401) listeners.forEach((listener) => listener());
  if (response.ok || response.status === 304) return response;
  let problem: Problem = { type: "about:blank", title: response.statusText, status: response.status };
  try {
    problem = (await response.json()) as Problem;
  } catch {
    // Not from the service: a proxy has answered.
  }
  throw new ApiError(problem);
}

export async function get<T>(path: string, signal?: AbortSignal): Promise<T> {
  return (await call(path, { signal })).json() as Promise<T>;
}

export async function send<T>(method: string, path: string, body?: unknown): Promise<T> {
  const init: RequestInit = { method };
  if (body !== undefined) {
    init.body = JSON.stringify(body);
    init.headers = { "content-type": "application/json" };
  }
  return (await call(path, init)).json() as Promise<T>;
}

/** Opens what `path` answers in a tab or as a file of its own. A link could not carry the key: a ticket for a minute does. */
export async function open(path: string, tab: boolean): Promise<void> {
  // Opened before the answer: a browser opens no tab that nobody has clicked for.
  const opened = tab ? window.open("", "_blank") : null;
  if (opened) opened.opener = null;
  try {
    const { ticket } = key.get() === null ? { ticket: null } : await send<{ ticket: string }>("POST", "v1/tickets", { path: `/${path}` });
    const target = address(`${path}${query({ ticket })}`).href;
    if (opened) opened.location.href = target;
    else location.assign(target);
  } catch (error) {
    opened?.close();
    throw error;
  }
}

/** Saves what `path` answers as a file. A link could not carry the key. */
export async function download(path: string, name: string): Promise<void> {
  save(await (await call(path)).blob(), name);
}

export function save(blob: Blob, name: string): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}

export function query(values: Record<string, string | number | undefined | null>): string {
  const set = Object.entries(values).filter(([, value]) => value !== undefined && value !== null && value !== "");
  const text = new URLSearchParams(set.map(([name, value]) => [name, String(value)])).toString();
  return text === "" ? "" : `?${text}`;
}

export const describe = (error: unknown): string => {
  if (error instanceof ApiError) {
    const faults = error.problem.errors?.map((fault) => `${fault.pointer}: ${fault.detail}`).join("; ");
    return [error.problem.title, error.problem.detail, faults].filter(Boolean).join(": ");
  }
  return error instanceof TypeError ? "The service cannot be reached." : String(error);
};
