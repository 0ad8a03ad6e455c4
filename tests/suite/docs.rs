//! The page at `/docs` is served with all files that it loads, and the documents of the repository agree with the
//! program and with each other.

use super::cli::homolog;
use super::jobs_support::{TestService, problem};
use std::fs;
use std::path::{Path, PathBuf};

/// Values of `src` and `href` in a page.
fn references(page: &str) -> Vec<String> {
    let begins = ["src=\"", "href=\""].into_iter().flat_map(|name| page.match_indices(name));
    begins.map(|(at, name)| page[at + name.len()..].split('"').next().unwrap().to_owned()).collect()
}

#[tokio::test]
async fn the_api_page_loads_only_files_of_the_service() {
    let service = TestService::start(&["--workers", "0"]).await;
    let client = reqwest::Client::builder().redirect(reqwest::redirect::Policy::none()).build().unwrap();
    let redirect = client.get(format!("{}/docs", service.base)).send().await.unwrap();
    assert_eq!((redirect.status().as_u16(), &redirect.headers()["location"]), (308, &"/docs/".parse().unwrap()));
    let page = service.get("/docs").await;
    assert_eq!(page.headers()["content-type"], "text/html; charset=utf-8");
    let policy = page.headers()["content-security-policy"].to_str().unwrap().to_owned();
    assert!(policy.starts_with("default-src 'none'") && !policy.contains("http"), "{policy}");
    let page = page.text().await.unwrap();
    assert!(!page.contains("<script>"), "the policy allows no script within the page");
    let references = references(&page);
    assert!(references.len() >= 5, "{references:?}");
    for reference in references {
        assert!(!reference.contains("//") && !reference.starts_with("data:"), "{reference} refers to another host");
        let file = service.get(&format!("/docs/{reference}")).await;
        assert_eq!(file.status(), 200, "{reference}");
        let media_type = file.headers()["content-type"].to_str().unwrap().to_owned();
        let expected = [("css", "text/css"), ("js", "text/javascript"), ("png", "image/png")];
        let ending = reference.rsplit('.').next().unwrap();
        assert!(expected.iter().any(|(e, t)| *e == ending && media_type.starts_with(t)), "{reference}: {media_type}");
        assert!(!file.bytes().await.unwrap().is_empty());
    }
    let start = service.get("/docs/swagger-initializer.js").await.text().await.unwrap();
    assert!(start.contains("/openapi.json") && !start.contains("http:") && !start.contains("https:"), "{start}");
    let style = service.get("/docs/swagger-ui.css").await.text().await.unwrap();
    assert!(!style.contains("@import") && !style.contains("url(http") && !style.contains("url(//"));
    problem(service.get("/docs/nothing.js").await, 404, "route-not-found").await;
    problem(service.get("/docs/../Cargo.toml").await, 404, "route-not-found").await;
    problem(service.get("/docs/%2e%2e/Cargo.toml").await, 404, "route-not-found").await;
    service.end().await;
}

#[test]
fn the_table_of_parameters_is_up_to_date() {
    let done = homolog().arg("parameters").output().unwrap();
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    let committed = fs::read(root().join("docs/parameters.md")).unwrap();
    assert!(committed == done.stdout, "docs/parameters.md is not what the program prints; run `make api`");
}

/// A constant, or a member of the default of a settings struct, as the code writes it.
fn value_in_code(code: &str, name: &str) -> Option<f64> {
    let number = |text: &str| text.trim().trim_end_matches([';', ',', '}']).trim().replace('_', "").parse().ok();
    let lines = || code.lines().map(str::trim);
    let constant =
        lines().find_map(|line| line.split_once(&format!("const {name}: "))?.1.split_once(" = ")).map(|at| at.1);
    let member = || {
        let of_line = |line: &'_ str| {
            let begin = format!("{name}: ");
            let at = line
                .match_indices(&begin)
                .find(|(at, _)| !line[..*at].ends_with(|c: char| c.is_alphanumeric() || c == '_'))?
                .0;
            line[at + begin.len()..].split([',', '}']).next().map(str::to_owned)
        };
        lines().filter_map(of_line).find(|value| number(value).is_some())
    };
    constant.map(str::to_owned).or_else(member).and_then(|value| number(&value))
}

/// Most fitted numbers that may decide anything.
const MOST_FITTED: usize = 15;

#[test]
fn the_ledger_has_the_values_of_the_code() {
    let ledger: toml::Table = fs::read_to_string(root().join("benches/thresholds.toml")).unwrap().parse().unwrap();
    let thresholds = ledger["threshold"].as_array().unwrap();
    let mut wrong = Vec::new();
    let mut names = std::collections::BTreeSet::new();
    let mut n_fitted = 0;
    for threshold in thresholds {
        let text = |key: &str| threshold[key].as_str().unwrap().to_owned();
        let (name, file) = (text("name"), text("file"));
        let stated =
            threshold["value"].as_float().or_else(|| threshold["value"].as_integer().map(|value| value as f64));
        let found = value_in_code(&fs::read_to_string(root().join(&file)).unwrap_or_default(), &name);
        if found.is_none() || found != stated {
            wrong.push(format!("{file}: {name} is {found:?}, the ledger has {stated:?}"));
        }
        assert!(text("decides").len() > 10, "{name}");
        let is_fitted = threshold.get("fitted_on").is_some();
        assert!(is_fitted != threshold.get("chosen").is_some(), "{name} has one of fitted_on and chosen");
        n_fitted += usize::from(is_fitted);
        assert!(names.insert((file, name)), "listed twice");
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
    assert!(n_fitted <= MOST_FITTED, "{n_fitted} numbers are fitted");
    // Every threshold of the route and of the verdict is in the ledger.
    let settings = fs::read_to_string(root().join("crates/matching/src/field/settings.rs")).unwrap();
    let defaults = settings.split_once("impl Default for RouteSettings {").unwrap().1;
    let defaults = defaults.split_once("        RouteSettings {").unwrap().1.split_once('}').unwrap().0;
    let members: Vec<&str> =
        defaults.split(',').filter_map(|member| member.trim().split_once(": ")).map(|m| m.0).collect();
    assert!(members.contains(&"straight"), "{members:?}");
    for member in members {
        assert!(names.iter().any(|(_, name)| name == member), "{member} is not in the ledger");
    }
    let verdict = fs::read_to_string(root().join("crates/matching/src/answer/reliability.rs")).unwrap();
    for name in verdict.lines().filter_map(|line| line.strip_prefix("const ")?.split_once(": f64")).map(|found| found.0)
    {
        assert!(
            name.starts_with("AWAY_") || names.iter().any(|(_, listed)| listed == name),
            "{name} is not in the ledger"
        );
    }
}

#[test]
fn values_are_read_as_the_code_writes_them() {
    let code = "const MOST: f64 = 1_000.5;\nS { noise: 0.136, noise_power: 6.0 }\npub noise: f64,\n    bent: 0.15,\n";
    let of = |name: &str| value_in_code(code, name);
    assert_eq!(
        [of("MOST"), of("noise"), of("noise_power"), of("bent")],
        [Some(1000.5), Some(0.136), Some(6.0), Some(0.15)]
    );
    assert_eq!([of("power"), of("none")], [None, None]);
}

#[test]
fn links_between_documents_resolve() {
    let mut n_links = 0;
    let mut broken = Vec::new();
    for path in documents() {
        let text = fs::read_to_string(&path).unwrap();
        for link in links(&text).into_iter().filter(|link| !link.contains("://")) {
            n_links += 1;
            let (file, anchor) = link.split_once('#').unwrap_or((link.as_str(), ""));
            let target = if file.is_empty() { path.clone() } else { path.parent().unwrap().join(file) };
            let is_there = target.exists()
                && (anchor.is_empty() || anchors(&fs::read_to_string(&target).unwrap()).iter().any(|a| a == anchor));
            if !is_there {
                broken.push(format!("{}: {link}", path.display()));
            }
        }
    }
    assert!(n_links > 40, "only {n_links} links were found");
    assert!(broken.is_empty(), "broken links:\n{}", broken.join("\n"));
}

#[test]
fn links_and_anchors_are_parsed() {
    let text = "# A title: *with* `code`/marks\n```sh\n# no [heading](here)\n```\nSee ![x](a.png), [y](b.md#a-b) and <http://c>.";
    assert_eq!(links(text), ["a.png", "b.md#a-b"]);
    assert_eq!(anchors(text), ["a-title-with-codemarks"]);
}

#[test]
fn the_log_lines_of_the_runbook_exist() {
    let runbook = fs::read_to_string(root().join("docs/runbook.md")).unwrap();
    let table = runbook.lines().skip_while(|line| !line.starts_with("| log line ")).skip(2);
    let messages: Vec<&str> = table
        .take_while(|row| row.starts_with('|'))
        .flat_map(|row| row.split('|').nth(1).unwrap().split('`').skip(1).step_by(2))
        .collect();
    assert!(messages.len() > 4, "{messages:?}");
    let sources = sources_under(&root().join("src")) + &sources_under(&root().join("crates"));
    for message in messages {
        assert!(sources.contains(&format!("\"{message}\"")), "nothing logs \"{message}\"");
    }
}

#[test]
fn the_tests_of_the_threat_model_exist() {
    let model = fs::read_to_string(root().join("docs/threat-model.md")).unwrap();
    let rows = model.lines().filter(|line| line.starts_with("| ") && !line.starts_with("| threat "));
    let mut n_tests = 0;
    for row in rows {
        let tests = row.trim_end_matches('|').rsplit('|').next().unwrap();
        let named: Vec<&str> = tests.split('`').skip(1).step_by(2).collect();
        assert!(!named.is_empty(), "no test: {row}");
        for test in named {
            let (place, function) = test.rsplit_once("::").unwrap();
            let file = match place.strip_suffix(".rs") {
                Some(_) => root().join(place),
                None => root().join("tests/suite").join(place.replace("::", "/")).with_extension("rs"),
            };
            let source = fs::read_to_string(&file).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
            assert!(source.contains(&format!("fn {function}(")), "there is no {test}");
            n_tests += 1;
        }
    }
    assert!(n_tests > 35, "{n_tests}");
    assert!(model.lines().count() < 130, "short enough to be read");
}

#[test]
fn each_fault_that_attacks_have_found_names_its_tests() {
    let model = fs::read_to_string(root().join("docs/threat-model.md")).unwrap();
    let found = model.split("## Faults that attacks have found").nth(1).unwrap().split("\n## ").next().unwrap();
    // The existence of these tests is checked above, as for every other row.
    let mut numbers: Vec<u32> =
        found.lines().filter_map(|line| line.strip_prefix("| ")?.split_once(". ")?.0.parse().ok()).collect();
    // The last number has several rows, one for each small fault.
    numbers.dedup();
    assert_eq!(numbers, (1..=14).collect::<Vec<u32>>());
}

/// All Rust files below a folder, one after another.
fn sources_under(folder: &Path) -> String {
    let paths = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let text = |path: PathBuf| match path.extension() {
        Some(extension) if extension == "rs" => fs::read_to_string(&path).unwrap(),
        _ if path.is_dir() => sources_under(&path),
        _ => String::new(),
    };
    paths.map(text).collect()
}

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The Markdown documents, except records of measurements, which are not updated.
fn documents() -> Vec<PathBuf> {
    let folders = [
        "",
        "docs",
        "docs/experiments",
        "docs/methods",
        "deploy",
        "benches/accuracy",
        "crates/laboratory/benches/pgmax",
    ];
    let entries = folders.iter().flat_map(|folder| fs::read_dir(root().join(folder)).unwrap());
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.unwrap().path()).collect();
    paths.retain(|path| path.extension().is_some_and(|e| e == "md"));
    paths.sort();
    paths
}

/// The lines of a document outside its blocks of code.
fn prose(text: &str) -> impl Iterator<Item = &str> {
    let mut in_code = false;
    text.lines().filter(move |line| {
        let is_fence = line.trim_start().starts_with("```");
        in_code ^= is_fence;
        !in_code && !is_fence
    })
}

/// Targets of `[text](target)`.
fn links(text: &str) -> Vec<String> {
    let after = prose(text).flat_map(|line| line.split("](").skip(1));
    after.filter_map(|rest| rest.split_once(')')).map(|(target, _)| target.to_owned()).collect()
}

/// The anchors that GitHub gives to headings.
fn anchors(text: &str) -> Vec<String> {
    let headings = prose(text).filter(|line| line.starts_with('#')).map(|line| line.trim_start_matches('#').trim());
    let slug = |heading: &str| {
        let kept = heading.to_lowercase().replace(' ', "-");
        kept.chars().filter(|c| c.is_alphanumeric() || ['-', '_'].contains(c)).collect()
    };
    headings.map(slug).collect()
}
