// The page: its views, the key, light and dark.

import { render } from "preact";
import { useEffect, useState } from "preact/hooks";
import { describe, get, key, onKeyNeeded } from "./api";
import { BatchView, Batches } from "./batches";
import { JobView } from "./job";
import { Jobs } from "./jobs";
import { NewBatch } from "./newbatch";
import { Operations } from "./operations";
import { Failure } from "./parts";
import { usePlace } from "./router";
import { Studies } from "./studies";
import { StudyView } from "./study";
import { Submit } from "./submit";

const VIEWS: [string, string][] = [
  ["jobs", "Jobs"],
  ["submit", "Submit"],
  ["batches", "Batches"],
  ["studies", "Studies"],
  ["operations", "Operations"],
];

const THEME = "homolog-theme";

function useTheme(): [string, (theme: string) => void] {
  const [theme, setTheme] = useState(localStorage.getItem(THEME) ?? "auto");
  useEffect(() => {
    if (theme === "auto") delete document.documentElement.dataset.theme;
    else document.documentElement.dataset.theme = theme;
    localStorage.setItem(THEME, theme);
    window.dispatchEvent(new Event("theme"));
  }, [theme]);
  return [theme, setTheme];
}

function KeyForm({ done }: { done: () => void }) {
  const [text, setText] = useState("");
  const [failure, setFailure] = useState<string | null>(null);
  const enter = async (event: Event) => {
    event.preventDefault();
    key.set(text.trim());
    try {
      await get("v1/jobs?page_size=1");
      done();
    } catch (error) {
      key.set(null);
      setFailure(describe(error));
    }
  };
  return (
    <form class="card key" onSubmit={enter}>
      <h1>This service asks for a key</h1>
      <p>
        Paste an API key of your tenant. It is kept for this tab only, until you close it. Whoever operates the service creates keys with <code>homolog keys create</code>.
      </p>
      <label>
        API key <input type="password" autocomplete="off" spellcheck={false} value={text} onInput={(e) => setText(e.currentTarget.value)} required />
      </label>
      <Failure text={failure} />
      <button class="primary" type="submit">
        Open
      </button>
    </form>
  );
}

function App() {
  const { path, query } = usePlace();
  const [needsKey, setNeedsKey] = useState(false);
  const [version, setVersion] = useState("");
  const [theme, setTheme] = useTheme();
  useEffect(() => onKeyNeeded(() => setNeedsKey(true)), []);
  useEffect(() => {
    get<{ version: string }>("healthz").then(({ version }) => setVersion(version), () => undefined);
  }, []);
  const [view = "jobs", id] = path;
  useEffect(() => {
    const name = VIEWS.find(([word]) => word === view)?.[1] ?? "Dashboard";
    document.title = id === "new" ? "New batch · homolog" : id ? `${{ batches: "Batch", studies: "Study" }[view] ?? "Job"} ${id.slice(-8)} · homolog` : `${name} · homolog`;
  }, [view, id]);

  let shown;
  if (needsKey) shown = <KeyForm done={() => setNeedsKey(false)} />;
  else if (view === "jobs" && id !== undefined) shown = <JobView id={id} key={id} />;
  else if (view === "jobs") shown = <Jobs query={query} />;
  else if (view === "submit") shown = <Submit />;
  else if (view === "batches" && id === "new") shown = <NewBatch />;
  else if (view === "batches" && id !== undefined) shown = <BatchView id={id} key={id} />;
  else if (view === "batches") shown = <Batches />;
  else if (view === "studies" && id !== undefined) shown = <StudyView id={id} key={id} />;
  else if (view === "studies") shown = <Studies />;
  else if (view === "operations") shown = <Operations />;
  else shown = <p class="failure">There is no view of this name. Choose one above.</p>;

  return (
    <>
      <a class="skip" href="#main" onClick={(e) => (e.preventDefault(), document.getElementById("main")?.focus())}>
        Skip to the content
      </a>
      <header>
        <a class="name" href="#/jobs">
          homolog
        </a>
        <nav aria-label="Views">
          {VIEWS.map(([word, name]) => (
            <a href={`#/${word}`} aria-current={word === view ? "page" : undefined}>
              {name}
            </a>
          ))}
        </nav>
        <span class="end">
          <label>
            <span class="quiet">Theme</span>{" "}
            <select value={theme} onChange={(e) => setTheme(e.currentTarget.value)}>
              <option value="auto">auto</option>
              <option value="light">light</option>
              <option value="dark">dark</option>
            </select>
          </label>
          {key.get() !== null && (
            <button
              onClick={() => {
                key.set(null);
                setNeedsKey(true);
              }}
            >
              Forget key
            </button>
          )}
        </span>
      </header>
      <main id="main" tabIndex={-1}>
        {shown}
      </main>
      <footer>
        homolog {version} · <a href={new URL("docs/", document.baseURI.split("#")[0]).href}>API</a> · <a href={new URL("assets/licenses.txt", document.baseURI.split("#")[0]).href}>licenses</a>
      </footer>
    </>
  );
}

render(<App />, document.getElementById("app")!);
