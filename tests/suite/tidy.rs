//! Rules of the source tree that neither the compiler nor a lint checks: which modules of the program may use which, the allowed
//! dependencies of members, and the form of files.
//!
//! Between members the compiler enforces the dependencies: a crate that is not in a member's `Cargo.toml` cannot be
//! used. ARCHITECTURE.md shows both tables below; tests check that they are equal.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// The members on which each member depends, in reading order. A test checks that this table equals the graph in
/// ARCHITECTURE.md and the `Cargo.toml` files.
const MEMBERS: &[(&str, &[&str])] = &[
    ("primitives", &[]),
    ("mesh", &["primitives"]),
    ("mrf", &["primitives"]),
    ("registration", &["primitives"]),
    ("geometry", &["primitives", "mesh", "registration"]),
    ("contract", &["mesh"]),
    ("methods", &["primitives", "mesh", "geometry", "registration"]),
    ("matching", &["primitives", "mesh", "geometry", "mrf", "registration", "methods", "contract"]),
    ("formats", &["mesh", "contract"]),
    ("run", &["primitives", "mesh", "registration", "contract", "formats", "matching"]),
    ("study", &["primitives", "mesh", "mrf", "registration", "contract", "formats", "run"]),
    (
        "laboratory",
        &["primitives", "mesh", "geometry", "mrf", "registration", "contract", "matching", "formats", "run"],
    ),
];

/// Members that only compute: bytes and numbers in, numbers out.
const NUMERICS: &[&str] =
    &["primitives", "mesh", "geometry", "mrf", "registration", "methods", "contract", "matching", "formats"];

/// The lint by which these members use no network, file, clock, environment and terminal: clippy.toml lists what they are. Runtimes
/// and databases are not among their dependencies, which the compiler enforces.
const NUMERICS_LINT: &str = "#![cfg_attr(not(test), warn(clippy::disallowed_methods, clippy::disallowed_types))]";

/// Crates on which no member depends: only the program has a runtime, a database, a network and a terminal.
const NOT_IN_MEMBERS: &[&str] =
    &["tokio", "sqlx", "axum", "hyper", "tower", "reqwest", "ureq", "clap", "indicatif", "tracing", "jiff", "uuid"];

/// The modules and members that each module of the program may use; an entry may name a part. A module may use itself.
const ARROWS: &[(&str, &[&str])] = &[
    ("jobs", &["homolog_contract", "homolog_mesh::topology", "homolog_primitives"]),
    ("tls", &[]),
    ("spans", &["tls"]),
    ("store", &["homolog_primitives", "jobs", "tls"]),
    (
        "worker",
        &[
            "homolog_contract",
            "homolog_formats",
            "homolog_matching::MatchError",
            "homolog_mesh",
            "homolog_primitives",
            "homolog_run",
            "homolog_study",
            "jobs",
            "spans",
            "tls",
        ],
    ),
    ("config", &["homolog_run", "http", "jobs", "spans", "store::sql", "tls", "worker"]),
    ("telemetry", &["config::LogFormat"]),
    ("http", &["jobs", "spans", "tls"]),
    ("app", &["config", "homolog_run", "http", "jobs", "store", "telemetry", "tls", "worker"]),
    (
        "cli",
        &[
            "app",
            "config",
            "homolog_contract",
            "homolog_formats",
            "homolog_laboratory",
            "homolog_mesh",
            "homolog_primitives",
            "homolog_run",
            "homolog_study",
            "http",
            "jobs",
            "spans",
            "store::artifacts",
            "store::backup",
            "store::encryption",
            "store::layout",
            "store::sql",
            "telemetry",
            "worker::isolation",
            "worker::quota",
        ],
    ),
];

/// Crates that a module of the program must not use.
const NOT_IN: &[(&str, &[&str])] = &[
    ("jobs", &["sqlx", "axum", "tower", "tower_http", "http", "nalgebra", "std::fs"]),
    ("http", &["sqlx", "nalgebra"]),
    ("worker", &["sqlx", "axum"]),
];

const MAX_LINES: usize = 700;

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn files_under(folder: &Path, extension: &str, into: &mut Vec<PathBuf>) {
    let Ok(entries) = fs::read_dir(folder) else { return };
    for entry in entries {
        let path = entry.unwrap().path();
        if path.is_dir() {
            files_under(&path, extension, into);
        } else if path.extension().is_some_and(|e| e == extension) {
            into.push(path);
        }
    }
}

struct SourceFile {
    /// Path from the root of the repository.
    name: String,
    /// The member it belongs to; none for the program.
    member: Option<&'static str>,
    /// Module path from the crate root; empty for lib.rs and main.rs.
    module: Vec<String>,
    text: String,
}

/// The sources of the program and of every member.
fn sources() -> Vec<SourceFile> {
    let mut all = sources_under("src", None);
    for &(member, _) in MEMBERS {
        all.extend(sources_under(&format!("crates/{member}/src"), Some(member)));
    }
    all
}

/// The sources of the program alone.
fn program() -> Vec<SourceFile> {
    sources_under("src", None)
}

fn sources_under(folder: &str, member: Option<&'static str>) -> Vec<SourceFile> {
    let folder = root().join(folder);
    let mut paths = Vec::new();
    files_under(&folder, "rs", &mut paths);
    paths.sort();
    assert!(!paths.is_empty(), "no sources under {}", folder.display());
    paths
        .into_iter()
        .map(|path| {
            let relative = path.strip_prefix(&folder).unwrap().with_extension("");
            let mut module: Vec<String> =
                relative.components().map(|c| c.as_os_str().to_str().unwrap().to_owned()).collect();
            if module.last().is_some_and(|last| last == "mod") || module == ["lib"] || module == ["main"] {
                module.pop();
            }
            let name = path.strip_prefix(root()).unwrap().display().to_string();
            SourceFile { name, member, module, text: fs::read_to_string(&path).unwrap() }
        })
        .collect()
}

/// The code without comments, strings and tests, which may use any module. Tests are at the end of a file, or in a file
/// whose name says so.
fn production_code(file: &SourceFile) -> String {
    if file.module.last().is_some_and(|m| m == "tests" || m.ends_with("_tests") || m == "testing") {
        return String::new();
    }
    let mut code = String::new();
    let mut lines = file.text.lines().peekable();
    while let Some(line) = lines.next() {
        if line.trim() == "#[cfg(test)]" {
            // A test module in its own file, or in a block at the end of this one.
            while lines.peek().is_some_and(|l| l.trim().starts_with("#[")) {
                lines.next();
            }
            match lines.next() {
                Some(item) if item.trim_end().ends_with(';') => continue,
                _ => break,
            }
        }
        let line = line.trim_start();
        if !line.starts_with("//") {
            let code_part = without_strings(line);
            code.push_str(code_part.split("//").next().unwrap_or_default());
            code.push('\n');
        }
    }
    code
}

fn without_strings(line: &str) -> String {
    let mut out = String::new();
    let mut inside = false;
    let mut escaped = false;
    for c in line.chars() {
        match (inside, escaped, c) {
            (true, true, _) => escaped = false,
            (true, false, '\\') => escaped = true,
            (_, _, '"') => inside = !inside,
            (false, _, c) => out.push(c),
            _ => {}
        }
    }
    out
}

/// Every path of this crate that `code` names, from the crate root: `crate::a::{b, c::d}` gives `a::b` and `a::c::d`.
fn crate_paths(code: &str, module: &[String]) -> Vec<String> {
    let mut found = Vec::new();
    for start in ["crate::", "homolog::"] {
        for (at, _) in code.match_indices(start) {
            if !code[..at].ends_with(|c: char| c.is_alphanumeric() || c == '_' || c == ':' || c == '$') {
                expand(&code[at + start.len()..], "", &mut found);
            }
        }
    }
    // Members of the workspace, by their whole name.
    for (at, _) in code.match_indices("homolog_") {
        if !code[..at].ends_with(|c: char| c.is_alphanumeric() || c == '_' || c == '"') {
            let end = code[at..].find(|c: char| !(c.is_alphanumeric() || c == '_')).map_or(code.len(), |n| at + n);
            if code[end..].starts_with("::") {
                expand(&code[at..], "", &mut found);
            }
        }
    }
    // Chains of `super` that leave the module's own top-level module.
    for (at, _) in code.match_indices("super::") {
        if code[..at].ends_with("::") || code[..at].ends_with(|c: char| c.is_alphanumeric() || c == '_') {
            continue;
        }
        let mut rest = &code[at..];
        let mut ups = 0;
        while let Some(after) = rest.strip_prefix("super::") {
            ups += 1;
            rest = after;
        }
        if ups == module.len() {
            expand(rest, "", &mut found);
        }
    }
    found
}

/// Reads one path or group at the beginning of `code`; returns what is left.
fn expand<'a>(code: &'a str, prefix: &str, found: &mut Vec<String>) -> &'a str {
    let code = code.trim_start();
    if let Some(mut rest) = code.strip_prefix('{') {
        loop {
            rest = rest.trim_start().trim_start_matches(',').trim_start();
            match rest.strip_prefix('}') {
                Some(after) => return after,
                None if rest.is_empty() => return rest,
                None => {
                    let before = rest.len();
                    rest = expand(rest, prefix, found);
                    if rest.len() == before {
                        return rest;
                    }
                }
            }
        }
    }
    let end = code.find(|c: char| !(c.is_alphanumeric() || c == '_' || c == '*')).unwrap_or(code.len());
    let (word, rest) = code.split_at(end);
    let path = if prefix.is_empty() { word.to_owned() } else { format!("{prefix}::{word}") };
    if let Some(rest) = rest.strip_prefix("::") {
        return expand(rest, &path, found);
    }
    if !word.is_empty() {
        found.push(path);
    }
    // `x as y` inside a group.
    let rest_trimmed = rest.trim_start();
    match rest_trimmed.strip_prefix("as ") {
        Some(after) => &after[after.find([',', '}', ';']).unwrap_or(after.len())..],
        None => rest,
    }
}

/// Whether `code` contains `path` as the beginning of a path or as a whole word.
fn names(code: &str, path: &str) -> bool {
    code.match_indices(path).any(|(at, _)| {
        let before = code[..at].chars().next_back();
        let after = code[at + path.len()..].chars().next();
        let word = |c: Option<char>| c.is_some_and(|c| c.is_alphanumeric() || c == '_');
        let begins = !word(before) && before != Some(':') && before != Some('.');
        // A lone crate name counts only as the head of a path or of a `use`, because a variable may be called `http`.
        let is_type = path.starts_with(char::is_uppercase) || path.contains("::");
        let heads = code[at + path.len()..].starts_with("::") || code[..at].ends_with("use ");
        begins && !word(after) && (is_type || heads)
    })
}

fn allowed(arrows: &[&str], path: &str) -> bool {
    arrows.iter().any(|entry| path == *entry || path.strip_prefix(entry).is_some_and(|rest| rest.starts_with("::")))
}

#[test]
fn modules_use_only_what_the_table_allows() {
    let table: BTreeMap<_, _> = ARROWS.iter().copied().collect();
    let mut faults = Vec::new();
    for file in program() {
        let Some(module) = file.module.first() else { continue };
        let Some(arrows) = table.get(module.as_str()) else {
            faults.push(format!("{}: module {module} is not in the table of arrows", file.name));
            continue;
        };
        for path in crate_paths(&production_code(&file), &file.module) {
            let head = path.split("::").next().unwrap_or_default();
            let known = table.contains_key(head) || head.starts_with("homolog_");
            if head != module && known && !allowed(arrows, &path) {
                faults.push(format!("{}: {module} uses {path}", file.name));
            }
        }
    }
    faults.dedup();
    assert!(faults.is_empty(), "arrows that are not allowed:\n{}", faults.join("\n"));
}

/// Names in a section of a `Cargo.toml`.
fn dependencies(manifest: &str, section: &str) -> BTreeSet<String> {
    let header = format!("[{section}]");
    let lines = manifest.lines().skip_while(|l| *l != header).skip(1).take_while(|l| !l.starts_with('['));
    let name = |line: &str| line.split(['.', ' ', '=']).next().unwrap_or_default().to_owned();
    lines.filter(|l| !l.is_empty() && !l.starts_with('#')).map(name).collect()
}

#[test]
fn members_depend_on_what_the_table_says() {
    let mut faults = Vec::new();
    for &(member, expected) in MEMBERS {
        let manifest = fs::read_to_string(root().join(format!("crates/{member}/Cargo.toml"))).unwrap();
        let all = dependencies(&manifest, "dependencies");
        let members: BTreeSet<_> = all.iter().filter_map(|name| name.strip_prefix("homolog-")).collect();
        if members != expected.iter().copied().collect() {
            faults.push(format!("{member} depends on the members {members:?}"));
        }
        faults.extend(all.iter().filter(|d| NOT_IN_MEMBERS.contains(&d.as_str())).map(|d| format!("{member}: {d}")));
    }
    let folders = fs::read_dir(root().join("crates")).unwrap().count();
    assert_eq!(folders, MEMBERS.len(), "a member is missing in the table");
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn the_numerics_have_the_lint_against_files_and_clocks() {
    for member in NUMERICS {
        let text = fs::read_to_string(root().join(format!("crates/{member}/src/lib.rs"))).unwrap();
        assert!(text.lines().any(|line| line == NUMERICS_LINT), "crates/{member}/src/lib.rs lacks {NUMERICS_LINT}");
    }
}

#[test]
fn modules_of_the_program_name_no_crate_that_belongs_elsewhere() {
    let mut faults = Vec::new();
    for file in program() {
        let code = production_code(&file);
        let further = NOT_IN.iter().filter(|(module, _)| file.module.first().is_some_and(|first| first == module));
        for banned in further.flat_map(|(_, crates)| crates.iter()) {
            if names(&code, banned) {
                faults.push(format!("{}: names {banned}", file.name));
            }
        }
    }
    assert!(faults.is_empty(), "names that do not belong there:\n{}", faults.join("\n"));
}

/// Only the commands that need synthetic subjects or experiments link the laboratory.
#[test]
fn only_demo_phantom_and_experiment_use_the_laboratory() {
    for file in program().iter().filter(|file| names(&production_code(file), "homolog_laboratory")) {
        let command = file.module.get(1).map(String::as_str);
        assert!(matches!(command, Some("demo" | "phantom" | "experiment")), "{} uses the laboratory", file.name);
    }
}

#[test]
fn every_source_file_says_what_it_is_and_is_short() {
    let mut faults = Vec::new();
    let mut others = Vec::new();
    files_under(&root().join("tests"), "rs", &mut others);
    files_under(&root().join("benches"), "rs", &mut others);
    let others = others.into_iter().map(|path| {
        let name = path.strip_prefix(root()).unwrap().display().to_string();
        (name, fs::read_to_string(&path).unwrap())
    });
    for (name, text) in sources().into_iter().map(|f| (f.name, f.text)).chain(others) {
        if !text.starts_with("//! ") && !text.starts_with("#![doc = include_str!(\"../README.md\")]") {
            faults.push(format!("{name}: does not begin with //!"));
        }
        let n_lines = text.lines().count();
        if n_lines > MAX_LINES {
            faults.push(format!("{name}: {n_lines} lines, more than {MAX_LINES}"));
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

/// Lints forbid `println!` and the like; this is the other way to the standard output.
#[test]
fn only_commands_write_to_the_standard_output() {
    for file in sources() {
        let may_print = file.member.is_none() && file.module.first().is_none_or(|m| m == "cli");
        let writes = !may_print && names(&production_code(&file), "std::io::stdout");
        assert!(!writes, "{} writes to the standard output", file.name);
    }
}

#[test]
fn sql_is_in_sql_files() {
    let verbs = ["SELECT ", "INSERT INTO", "UPDATE ", "DELETE FROM", "CREATE TABLE", "BEGIN IMMEDIATE"];
    // Beginning a transaction and locking rows are not queries: there the two databases differ.
    let sessions = ["src/store/sql/database.rs", "src/store/sql/dialect.rs"];
    let mut faults = Vec::new();
    for file in sources().into_iter().filter(|file| !sessions.contains(&file.name.as_str())) {
        for (number, line) in file.text.lines().enumerate() {
            let code = line.trim_start();
            if !code.starts_with("//") && verbs.iter().any(|verb| code.contains(verb)) {
                faults.push(format!("{}:{}: {code}", file.name, number + 1));
            }
        }
    }
    assert!(faults.is_empty(), "SQL outside .sql files:\n{}", faults.join("\n"));
}

/// Asserts that a marked table of ARCHITECTURE.md equals one of the tables above.
fn assert_table_in_architecture(marker: &str, table: &[(&str, &[&str])]) {
    let text = fs::read_to_string(root().join("ARCHITECTURE.md")).unwrap();
    let row = |(module, arrows): &(&str, &[&str])| {
        let list: Vec<_> = arrows.iter().map(|a| format!("`{a}`")).collect();
        format!("| `{module}` | {} |", if list.is_empty() { "nothing".to_owned() } else { list.join(", ") })
    };
    let expected: Vec<String> = table.iter().map(row).collect();
    let section = text.split(marker).nth(1).unwrap_or_else(|| panic!("ARCHITECTURE.md has no {marker}"));
    let found: Vec<&str> =
        section.lines().skip_while(|l| !l.starts_with("| `")).take_while(|l| l.starts_with("| `")).collect();
    assert_eq!(found, expected, "the table in ARCHITECTURE.md should be:\n{}", expected.join("\n"));
}

#[test]
fn the_tables_equal_those_in_architecture_md() {
    assert_table_in_architecture("<!-- members: held equal to tests/suite/tidy.rs -->", MEMBERS);
    assert_table_in_architecture("<!-- arrows: held equal to tests/suite/tidy.rs -->", ARROWS);
}

/// `make help` prints the head of the Makefile: groups of at most eight commands, each of which exists, and all of them.
#[test]
fn help_lists_every_command_in_groups_of_at_most_eight() {
    let makefile = fs::read_to_string(root().join("Makefile")).unwrap();
    let head: Vec<&str> = makefile.lines().map_while(|line| line.strip_prefix('#')).collect();
    let command = |line: &str| {
        let words = line.strip_prefix("   ").filter(|rest| rest.starts_with(char::is_alphabetic))?;
        words.split(' ').next().map(str::to_owned)
    };
    let mut listed = BTreeSet::new();
    for group in head.split(|line| line.trim().is_empty()) {
        let commands: Vec<String> = group.iter().filter_map(|line| command(line)).collect();
        assert!((1..=8).contains(&commands.len()), "{} has {} commands", group[0], commands.len());
        listed.extend(commands);
    }
    let phony = makefile.lines().filter_map(|line| line.strip_prefix(".PHONY: "));
    let mut known: BTreeSet<String> = phony.flat_map(str::split_whitespace).map(str::to_owned).collect();
    // The page itself, and a step of others.
    assert!(known.remove("help") && known.remove("study-env"));
    assert_eq!(listed, known);
}

#[test]
fn every_copy_source_of_the_dockerfile_exists() {
    let text = fs::read_to_string(root().join("Dockerfile")).unwrap();
    let ignored: Vec<String> = fs::read_to_string(root().join(".dockerignore"))
        .unwrap()
        .lines()
        .filter_map(|line| line.strip_prefix('!').map(|kept| kept.trim_end_matches("/**").to_owned()))
        .collect();
    let mut n_sources = 0;
    for line in text.lines().filter(|l| l.starts_with("COPY ") && !l.contains("--from=")) {
        let words: Vec<&str> = line.split_whitespace().skip(1).filter(|w| !w.starts_with("--")).collect();
        for source in &words[..words.len() - 1] {
            assert!(root().join(source).exists(), "{line}: {source} does not exist");
            assert!(ignored.contains(&source.trim_end_matches('/').to_owned()), ".dockerignore keeps {source} out");
            n_sources += 1;
        }
    }
    assert!(n_sources > 0);
}

#[test]
fn included_files_are_copied_into_the_container_build() {
    let docker = fs::read_to_string(root().join("Dockerfile")).unwrap();
    for file in sources() {
        for (at, _) in file.text.match_indices("CARGO_MANIFEST_DIR\"), \"/") {
            let path = &file.text[at + "CARGO_MANIFEST_DIR\"), \"/".len()..];
            let top = path.split(['/', '"']).next().unwrap_or_default();
            let copied = docker.lines().any(|l| l.starts_with("COPY ") && l.split_whitespace().any(|w| w == top));
            assert!(copied, "{} includes {top}/, which the Dockerfile does not copy", file.name);
        }
    }
}

#[test]
fn paths_in_sources_are_parsed() {
    let code = "use crate::a::{self, b, c::{d, e as f}, g};\nlet x = crate::h::i(1); super::super::j::k();";
    let module = ["m".to_owned(), "n".to_owned()];
    let found = crate_paths(code, &module);
    assert_eq!(found, ["a::self", "a::b", "a::c::d", "a::c::e", "a::g", "h::i", "j::k"]);
    assert!(names("use tokio;", "tokio") && names("tokio::spawn(x)", "tokio"));
    assert!(!names("let tokio = 1;", "tokio") && !names("crate::http::x", "http"));
    assert!(allowed(&["a::b"], "a::b::c") && !allowed(&["a::b"], "a::bc") && !allowed(&["a::b"], "a"));
}
