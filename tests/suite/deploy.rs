//! The files of `deploy/`, the Dockerfile, README and `docs/` mention only settings, commands and flags that the program
//! lists in its help, and its actual port, paths and metrics.

use crate::cli::homolog;
use serde_json::{Map, Value};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// How long a process may take to complete open answers after the grace period, as in `src/app.rs`, s.
const LAST_ANSWERS_S: u64 = 5;

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// A file, by its path from the root of the repository.
struct TextFile {
    name: String,
    text: String,
}

impl TextFile {
    fn read(path: &Path) -> Self {
        let name = path.strip_prefix(root()).unwrap().display().to_string();
        TextFile { name, text: fs::read_to_string(path).unwrap() }
    }

    fn is_yaml(&self) -> bool {
        self.name.ends_with(".yaml")
    }

    fn is_markdown(&self) -> bool {
        self.name.ends_with(".md")
    }
}

fn files_under(folder: &Path, into: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            files_under(&path, into);
        } else if path.file_name().is_some_and(|name| name != ".env") {
            into.push(path);
        }
    }
}

/// Everything under `deploy/`, the Dockerfile, README and the documents of `docs/`.
fn files() -> Vec<TextFile> {
    let mut paths: Vec<PathBuf> =
        fs::read_dir(root().join("docs")).unwrap().map(|entry| entry.unwrap().path()).collect();
    paths.retain(|path| path.extension().is_some_and(|e| e == "md"));
    paths.extend([root().join("Dockerfile"), root().join("README.md")]);
    files_under(&root().join("deploy"), &mut paths);
    paths.sort();
    assert!(paths.len() > 10, "few files: {paths:?}");
    paths.iter().map(|path| TextFile::read(path)).collect()
}

/// The documents of every YAML file, with the file's name.
fn documents() -> Vec<(String, Value)> {
    let mut all = Vec::new();
    for file in files().iter().filter(|file| file.is_yaml()) {
        let parsed: Vec<Value> = match serde_saphyr::from_multiple(&file.text) {
            Ok(parsed) => parsed,
            Err(error) => panic!("{} is no YAML: {error}", file.name),
        };
        assert!(!parsed.is_empty(), "{} is empty", file.name);
        all.extend(parsed.into_iter().map(|document| (file.name.clone(), document)));
    }
    all
}

/// `value` if it is an object, and all objects in it.
fn objects(value: &Value) -> Vec<&Map<String, Value>> {
    match value {
        Value::Object(object) => {
            let mut found = vec![object];
            found.extend(object.values().flat_map(objects));
            found
        }
        Value::Array(list) => list.iter().flat_map(objects).collect(),
        _ => Vec::new(),
    }
}

/// The containers of this program, in compose files and in pods.
fn containers(document: &Value) -> Vec<&Map<String, Value>> {
    let is_ours =
        |object: &&Map<String, Value>| text_of(object, "image").is_some_and(|image| image.contains("homolog"));
    objects(document).into_iter().filter(is_ours).collect()
}

fn text_of<'a>(object: &'a Map<String, Value>, key: &str) -> Option<&'a str> {
    object.get(key).and_then(Value::as_str)
}

fn list_of<'a>(object: &'a Map<String, Value>, key: &str) -> &'a [Value] {
    object.get(key).and_then(Value::as_array).map(Vec::as_slice).unwrap_or_default()
}

/// The arguments of the program: `args` in a pod, `command` in a compose file.
fn arguments(container: &Map<String, Value>) -> Vec<&str> {
    let key = if container.contains_key("args") { "args" } else { "command" };
    list_of(container, key).iter().filter_map(Value::as_str).collect()
}

/// The argument after `flag`.
fn value_after<'a>(arguments: &[&'a str], flag: &str) -> Option<&'a str> {
    arguments.iter().position(|argument| *argument == flag).and_then(|at| arguments.get(at + 1).copied())
}

/// The number after the last colon.
fn port_in(address: &str) -> Option<u64> {
    address.rsplit(':').next().and_then(|port| port.parse().ok())
}

/// The settings and commands in the program's help.
#[derive(Default)]
struct Program {
    /// Environment variables of its settings.
    settings: BTreeSet<String>,
    /// Flags of each command, such as `keys create`; the program itself has the empty name.
    flags: BTreeMap<String, BTreeSet<String>>,
}

impl Program {
    fn ask() -> Self {
        let mut program = Program::default();
        program.describe("");
        assert!(program.flags.contains_key("serve"), "no commands were read from the help: {:?}", program.flags);
        assert!(program.settings.contains("HOMOLOG_DATA_DIR"), "no settings were read from the help");
        program
    }

    /// Reads the help of `command` and of its subcommands.
    fn describe(&mut self, command: &str) {
        let done = homolog().args(command.split_whitespace()).arg("--help").output().unwrap();
        assert!(done.status.success(), "homolog {command} --help");
        let help = String::from_utf8(done.stdout).unwrap();
        let mut flags = BTreeSet::new();
        for line in help.lines().map(str::trim_start).filter(|line| line.starts_with('-')) {
            // Flags and their values come before the first wide gap, the description after it.
            let left = line.split("  ").next().unwrap_or_default();
            let words = left.split([' ', ',', '=', '[', '<']).filter(|word| word.starts_with("--"));
            flags.extend(words.map(str::to_owned));
        }
        self.flags.insert(command.to_owned(), flags);
        // A line may be broken anywhere between words.
        let words: Vec<&str> = help.split_whitespace().collect();
        let joined = words.join(" ");
        self.settings.extend(joined.split("[env: ").skip(1).map(|rest| name_at_start(rest).to_owned()));
        let listed = help.lines().skip_while(|line| *line != "Commands:").skip(1).take_while(|line| !line.is_empty());
        for line in listed.filter(|line| line.starts_with("  ") && !line.starts_with("   ")) {
            let name = line.split_whitespace().next().unwrap_or_default();
            if name != "help" {
                self.describe(format!("{command} {name}").trim_start());
            }
        }
    }

    /// The errors in these arguments of the program.
    fn faults_of_call(&self, words: &[&str]) -> Vec<String> {
        let mut command = String::new();
        let mut n_read = 0;
        for word in words {
            let longer = format!("{command} {word}").trim_start().to_owned();
            if !self.flags.contains_key(&longer) {
                break;
            }
            command = longer;
            n_read += 1;
        }
        let below = format!("{command} ");
        let has_commands = n_read == 0 || self.flags.keys().any(|known| known.starts_with(&below));
        if has_commands && let Some(word) = words.get(n_read).filter(|word| is_command_word(word)) {
            return vec![format!("homolog {command} {word}: no such command")];
        }
        let flags = &self.flags[&command];
        let mut faults = Vec::new();
        for word in &words[n_read..] {
            if ["|", "||", "&", "&&", ";", ">"].contains(word) {
                break;
            }
            let flag = word.trim_start_matches(['[', '(', '"', '\'']);
            let flag = flag.split(['=', ']', ')', '"', '\'', ';', ',', '.']).next().unwrap_or_default();
            if flag.starts_with("--") && flag.len() > 2 && !flags.contains(flag) {
                faults.push(format!("homolog {command} {flag}: no such flag"));
            }
        }
        faults
    }

    /// The errors in the calls of the program in one shell command line. In `docker run IMAGE` and `docker compose run
    /// SERVICE`, the name of the image or the service counts as the program.
    fn faults_of_line(&self, line: &str) -> Vec<String> {
        let words: Vec<&str> = line.split_whitespace().take_while(|word| !word.starts_with('#')).collect();
        let mut faults = Vec::new();
        for (at, word) in words.iter().enumerate() {
            let rest = &words[at + 1..];
            let Some(next) = rest.first().filter(|_| *word == "homolog") else { continue };
            if (is_command_word(next) && *next != "homolog") || (at == 0 && next.starts_with("--")) {
                faults.extend(self.faults_of_call(rest));
            }
        }
        // A flag alone, as in prose, may belong to any command.
        if let Some(flag) = words.first().filter(|word| word.starts_with("--") && word.len() > 2) {
            let flag = flag.split('=').next().unwrap_or_default();
            if !self.flags.values().any(|flags| flags.contains(flag)) {
                faults.push(format!("{flag}: no command has it"));
            }
        }
        faults
    }
}

fn is_command_word(word: &str) -> bool {
    !word.is_empty() && !word.starts_with('-') && word.chars().all(|c| c.is_ascii_lowercase() || c == '-')
}

/// The capital letters, digits and underscores that `text` begins with.
fn name_at_start(text: &str) -> &str {
    let end = text.find(|c: char| !(c.is_ascii_uppercase() || c.is_ascii_digit() || c == '_')).unwrap_or(text.len());
    &text[..end]
}

/// The environment variables of this program that a text mentions.
fn settings_named(text: &str) -> BTreeSet<String> {
    let mut names = BTreeSet::new();
    for (at, prefix) in text.match_indices("HOMOLOG_") {
        let is_tail = text[..at].ends_with(|c: char| c.is_ascii_alphanumeric() || c == '_');
        let name = name_at_start(&text[at..]);
        if !is_tail && name != prefix {
            names.insert(name.to_owned());
        }
    }
    names
}

/// The shell lines in a file, and the text between backticks in its prose. In Markdown, shell is in fenced blocks;
/// elsewhere, in comments that are indented by three spaces.
fn snippets(file: &TextFile) -> Vec<String> {
    let mut lines = Vec::new();
    let mut prose = String::new();
    let mut continued = String::new();
    let mut in_fence = false;
    for line in file.text.lines() {
        let (is_shell, line) = if file.is_markdown() {
            if line.trim_start().starts_with("```") {
                in_fence = !in_fence;
                continue;
            }
            (in_fence, line.trim())
        } else {
            let Some(comment) = line.trim_start().strip_prefix('#') else { continue };
            (comment.starts_with("   "), comment.trim())
        };
        if !is_shell {
            prose.push_str(line);
            prose.push(' ');
            continue;
        }
        match line.strip_suffix('\\') {
            Some(part) => continued.push_str(part),
            None => {
                continued.push_str(line);
                lines.push(std::mem::take(&mut continued));
            }
        }
    }
    lines.extend(spans(&prose));
    lines
}

/// The text between backticks.
fn spans(prose: &str) -> impl Iterator<Item = String> {
    prose.split('`').skip(1).step_by(2).map(str::to_owned)
}

/// The sources of the program and of the workspace's members.
fn sources() -> String {
    let mut paths = Vec::new();
    files_under(&root().join("src"), &mut paths);
    files_under(&root().join("crates"), &mut paths);
    let is_rust = |path: &&PathBuf| path.extension().is_some_and(|e| e == "rs");
    paths.iter().filter(is_rust).map(|path| fs::read_to_string(path).unwrap()).collect()
}

/// The last instruction of the Dockerfile that begins with `keyword`, which is the one that takes effect.
fn instruction(keyword: &str) -> String {
    let text = fs::read_to_string(root().join("Dockerfile")).unwrap();
    let found = text.lines().rev().find_map(|line| line.strip_prefix(keyword).and_then(|rest| rest.strip_prefix(' ')));
    found.unwrap_or_else(|| panic!("the Dockerfile has no {keyword}")).to_owned()
}

/// The port that the image serves on.
fn image_port() -> u64 {
    instruction("EXPOSE").trim().parse().unwrap()
}

#[test]
fn every_setting_that_is_mentioned_exists() {
    let mut known = Program::ask().settings;
    // Build arguments of the image, not settings.
    let dockerfile = fs::read_to_string(root().join("Dockerfile")).unwrap();
    known.extend(dockerfile.lines().filter_map(|line| line.strip_prefix("ARG ")).map(|a| name_at_start(a).to_owned()));
    let mut faults = Vec::new();
    for file in files() {
        let unknown = settings_named(&file.text).into_iter().filter(|name| !known.contains(name));
        faults.extend(unknown.map(|name| format!("{}: {name}", file.name)));
    }
    assert!(faults.is_empty(), "no such setting:\n{}", faults.join("\n"));
}

#[test]
fn every_command_and_flag_that_is_mentioned_exists() {
    let program = Program::ask();
    let mut faults = Vec::new();
    for file in files() {
        for line in snippets(&file) {
            faults.extend(program.faults_of_line(&line).into_iter().map(|fault| format!("{}: {fault}", file.name)));
        }
    }
    let mut n_calls = 0;
    for (name, document) in documents() {
        for container in containers(&document) {
            let call = arguments(container);
            n_calls += usize::from(!call.is_empty());
            faults.extend(program.faults_of_call(&call).into_iter().map(|fault| format!("{name}: {fault}")));
        }
    }
    assert!(n_calls > 5, "only {n_calls} containers were found");
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn the_image_requires_keys_and_runs_existing_commands() {
    let program = Program::ask();
    let list = |text: &str| -> Vec<String> { serde_json::from_str(text).unwrap() };
    assert_eq!(list(&instruction("ENTRYPOINT")), ["homolog"]);
    let command = list(&instruction("CMD"));
    let health = instruction("HEALTHCHECK");
    let health = list(health.split("CMD ").nth(1).unwrap());
    assert_eq!(health[0], "homolog");
    for call in [&command[..], &health[1..]] {
        let words: Vec<&str> = call.iter().map(String::as_str).collect();
        assert_eq!(program.faults_of_call(&words), Vec::<String>::new());
    }
    assert!(!command.contains(&"--insecure".to_owned()), "the image must not run without authentication: {command:?}");
    let listen = instruction("ENV");
    let listen = listen.split_whitespace().find_map(|pair| pair.strip_prefix("HOMOLOG_LISTEN=")).unwrap();
    assert_eq!(port_in(listen), Some(image_port()));
}

#[test]
fn every_service_requires_keys() {
    let all = documents();
    let by_environment = all.iter().any(|(_, document)| document["data"]["HOMOLOG_AUTH"] == "keys");
    let mut n_services = 0;
    for (name, document) in &all {
        for container in containers(document) {
            let call = arguments(container);
            assert!(!call.contains(&"--insecure") && !call.contains(&"none"), "{name}: {call:?}");
            if call.first() == Some(&"serve") {
                let is_pod = container.contains_key("args");
                let has_keys = value_after(&call, "--auth") == Some("keys") || (is_pod && by_environment);
                assert!(has_keys, "{name}: {call:?}");
                n_services += 1;
            }
        }
    }
    assert!(n_services >= 3, "only {n_services} were found");
}

#[test]
fn containers_are_neither_root_nor_writable() {
    let mut n_pods = 0;
    for (name, document) in documents() {
        for container in containers(&document) {
            if !container.contains_key("args") {
                assert_eq!(container.get("read_only"), Some(&Value::Bool(true)), "{name}");
                continue;
            }
            let security = &container["securityContext"];
            assert_eq!(security["readOnlyRootFilesystem"], true, "{name}");
            assert_eq!(security["allowPrivilegeEscalation"], false, "{name}");
            assert_eq!(security["capabilities"]["drop"][0], "ALL", "{name}");
        }
        for object in objects(&document).iter().filter(|object| object.contains_key("containers")) {
            assert_eq!(object["securityContext"]["runAsNonRoot"], true, "{name}");
            assert_eq!(object["automountServiceAccountToken"], false, "{name}");
            n_pods += 1;
        }
    }
    assert!(n_pods >= 3, "only {n_pods} pods were found");
    // Both base images can be replaced by the same images with digests, and neither uses the tag `latest`.
    let dockerfile = fs::read_to_string(root().join("Dockerfile")).unwrap();
    let from: Vec<_> = dockerfile.lines().filter_map(|line| line.strip_prefix("FROM ")).collect();
    assert_eq!(from, ["${BUILD_IMAGE} AS build", "${RUN_IMAGE}"]);
    for argument in ["BUILD_IMAGE", "RUN_IMAGE"] {
        let image = dockerfile.lines().find_map(|line| line.strip_prefix(&format!("ARG {argument}="))).unwrap();
        assert!(image.split_once(':').is_some_and(|(_, tag)| !tag.is_empty() && tag != "latest"), "{image}");
    }
    assert_eq!(instruction("USER").split(':').next(), Some("65532"));
}

/// Connections that clients can occupy must not decide whether a supervisor restarts the process.
#[test]
fn network_policies_let_every_pod_reach_a_labeled_collector_and_no_other_address() {
    let documents = documents();
    let policies: Vec<&Value> = documents.iter().map(|(_, d)| d).filter(|d| d["kind"] == "NetworkPolicy").collect();
    let named = |name: &str| *policies.iter().find(|policy| policy["metadata"]["name"] == name).unwrap();
    let collector = named("homolog-to-collector");
    assert_eq!(collector["spec"]["podSelector"], named("homolog-default-deny")["spec"]["podSelector"]);
    let rules = collector["spec"]["egress"].as_array().unwrap();
    assert_eq!(rules.len(), 1);
    // The default port of OTLP over HTTP, as in the documentation of the setting.
    assert_eq!(rules[0]["ports"], serde_json::json!([{"protocol": "TCP", "port": 4318}]));
    for peer in rules[0]["to"].as_array().unwrap() {
        let selectors =
            ["namespaceSelector", "podSelector"].map(|kind| &peer[kind]["matchLabels"]["homolog-collector"]);
        assert!(selectors.iter().any(|label| **label == "true"), "{peer}");
    }
}

#[test]
fn services_answer_probes_apart_from_clients() {
    for (name, document) in documents() {
        for container in containers(&document) {
            let call = arguments(container);
            if call.first() != Some(&"serve") {
                continue;
            }
            let probes = value_after(&call, "--probe-listen").and_then(port_in);
            assert!(probes.is_some_and(|port| port != image_port()), "{name}: {call:?}");
            for probe in ["startupProbe", "livenessProbe", "readinessProbe"] {
                let get = container.get(probe).and_then(|p| p.get("httpGet"));
                assert!(get.is_none_or(|get| get["port"] != "http"), "{name}: {probe}");
            }
        }
    }
}

#[test]
fn ports_and_paths_are_those_of_the_image_and_the_router() {
    let sources = sources();
    let is_route = |path: &str| sources.contains(&format!("\"{path}\""));
    let mut port_names = BTreeSet::new();
    let mut n_probes = 0;
    let all = documents();
    for (name, document) in &all {
        for container in containers(document) {
            let call = arguments(container);
            let mut own_ports: Vec<u64> = value_after(&call, "--probe-listen").and_then(port_in).into_iter().collect();
            if call.first() == Some(&"serve") {
                own_ports.push(value_after(&call, "--listen").map_or(image_port(), |a| port_in(a).unwrap()));
            }
            let mut own_names = BTreeSet::new();
            for port in list_of(container, "ports") {
                // A number in a pod, `host:port:port` in a compose file.
                let number = match port.as_str() {
                    Some(mapping) => port_in(mapping),
                    None => port.get("containerPort").and_then(Value::as_u64),
                };
                assert!(number.is_some_and(|number| own_ports.contains(&number)), "{name}: {port}");
                own_names.extend(port.get("name").and_then(Value::as_str).map(str::to_owned));
            }
            for probe in ["startupProbe", "livenessProbe", "readinessProbe"] {
                let Some(get) = container.get(probe).and_then(|p| p.get("httpGet")).and_then(Value::as_object) else {
                    continue;
                };
                n_probes += 1;
                let (path, port) = (text_of(get, "path").unwrap(), text_of(get, "port").unwrap());
                assert!(is_route(path), "{name}: {probe} requests {path}");
                assert!(own_names.contains(port), "{name}: {probe} uses the port {port}");
            }
            let check: Vec<&str> = container
                .get("healthcheck")
                .and_then(Value::as_object)
                .map(|check| list_of(check, "test").iter().filter_map(Value::as_str).collect())
                .unwrap_or_default();
            if let Some(url) = value_after(&check, "--url") {
                assert!(port_in(url).is_some_and(|port| own_ports.contains(&port)), "{name}: {url}");
            }
            port_names.extend(own_names);
        }
    }
    assert!(n_probes >= 6, "only {n_probes} probes were found");
    for (name, document) in &all {
        for object in objects(document) {
            if let Some(target) = text_of(object, "targetPort") {
                assert!(port_names.contains(target), "{name}: targetPort {target}");
            }
            for endpoint in list_of(object, "podMetricsEndpoints").iter().filter_map(Value::as_object) {
                let (path, port) = (text_of(endpoint, "path").unwrap(), text_of(endpoint, "port").unwrap());
                assert!(is_route(path) && port_names.contains(port), "{name}: {port} {path}");
            }
        }
    }
}

#[test]
fn stop_timeouts_exceed_the_grace_period() {
    let all = documents();
    let grace_s = |settings: &Map<String, Value>| {
        text_of(settings, "HOMOLOG_SHUTDOWN_GRACE_MS").map(|ms| ms.parse::<u64>().unwrap() / 1_000)
    };
    let pods_s = all
        .iter()
        .filter(|(_, document)| document["kind"] == "ConfigMap")
        .find_map(|(_, document)| document["data"].as_object().and_then(grace_s))
        .expect("the ConfigMap sets the grace");
    let mut n_checked = 0;
    for (name, document) in &all {
        for object in objects(document) {
            if let Some(given) = object.get("terminationGracePeriodSeconds").and_then(Value::as_u64) {
                assert!(given > pods_s + LAST_ANSWERS_S, "{name}: {given} s for a grace of {pods_s} s");
                n_checked += 1;
            }
            let own_s = object.get("environment").and_then(Value::as_object).and_then(grace_s);
            if let (Some(own_s), true) = (own_s, object.contains_key("image")) {
                let given = text_of(object, "stop_grace_period").and_then(|text| text.strip_suffix('s')).unwrap();
                let given: u64 = given.parse().unwrap();
                assert!(given > own_s + LAST_ANSWERS_S, "{name}: {given} s for a grace of {own_s} s");
                n_checked += 1;
            }
        }
    }
    assert!(n_checked >= 6, "only {n_checked} were found");
}

#[test]
fn the_metrics_of_the_runbook_exist() {
    let sources = sources();
    let runbook = TextFile::read(&root().join("docs/runbook.md"));
    let named: Vec<String> = snippets(&runbook).into_iter().filter(|span| span.starts_with("homolog_")).collect();
    assert!(!named.is_empty());
    let unknown: Vec<&String> = named.iter().filter(|name| !sources.contains(name.as_str())).collect();
    assert!(unknown.is_empty(), "no such metric: {unknown:?}");
}

#[test]
fn referenced_files_exist() {
    for (name, document) in documents() {
        let folder = root().join(&name).parent().unwrap().to_owned();
        for object in objects(&document) {
            for entry in list_of(object, "resources").iter().chain(list_of(object, "components")) {
                let path = folder.join(entry.as_str().unwrap());
                assert!(path.exists(), "{name}: {}", path.display());
                assert!(path.is_file() || path.join("kustomization.yaml").exists(), "{name}: {}", path.display());
            }
        }
    }
}

#[test]
fn wrong_calls_and_settings_are_detected() {
    let mut program = Program::default();
    let flags = |names: &[&str]| names.iter().map(|name| (*name).to_owned()).collect::<BTreeSet<_>>();
    program.flags.insert(String::new(), flags(&["--version"]));
    program.flags.insert("serve".to_owned(), flags(&["--workers"]));
    program.flags.insert("keys".to_owned(), flags(&[]));
    program.flags.insert("keys create".to_owned(), flags(&["--tenant"]));
    for fine in [
        "homolog",
        "homolog serve --workers 0 | grep --only x",
        "docker compose run --rm homolog keys create --tenant=a",
        "kubectl exec pod -- homolog keys create [--tenant T]",
        "homolog --version",
        "psql --dbname homolog --command x",
        "--workers",
        "grep --nothing",
    ] {
        assert_eq!(program.faults_of_line(fine), Vec::<String>::new(), "{fine}");
    }
    for wrong in [
        "homolog server",
        "homolog serve --worker 0",
        "docker run --rm homolog keys make",
        "homolog keys create --workers 1",
        "homolog --versions",
        "--nothing",
    ] {
        assert_eq!(program.faults_of_line(wrong).len(), 1, "{wrong}");
    }
    let named = settings_named("HOMOLOG_ALPHA_2=1, XHOMOLOG_B, HOMOLOG_*: $HOMOLOG_LOG");
    assert_eq!(named.into_iter().collect::<Vec<_>>(), ["HOMOLOG_ALPHA_2", "HOMOLOG_LOG"]);
}
