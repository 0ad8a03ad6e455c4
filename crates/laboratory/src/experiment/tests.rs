//! The quick report as a whole: complete, self-contained, reproducible, resumable.

use super::document::{Cell, ReportDocument, ReportProvenance, Table};
use super::*;
use std::collections::BTreeMap;
use std::sync::atomic::{AtomicU64, Ordering};

/// A clock that advances by a millisecond at every reading, so that times are reproducible too.
fn ticking() -> Clock {
    let ticks = AtomicU64::new(0);
    Box::new(move || Duration::from_millis(ticks.fetch_add(1, Ordering::Relaxed)))
}

fn options(out: &Path, sections: &[&str]) -> ExperimentOptions {
    let words = |word: &str| word.to_owned();
    ExperimentOptions {
        data: out.join("absent"),
        out: out.to_owned(),
        quick: true,
        sections: sections.iter().map(|id| words(id)).collect(),
        accuracy: None,
        provenance: ReportProvenance {
            version: words("0.1.0"),
            commit: words("abc"),
            date: words("2026-01-31"),
            machine: words("two cores & more"),
        },
        clock: ticking(),
        memory: Some(Box::new(|source, target, _| Ok(((source.n_vertices() + target.n_vertices()) as u64) << 20))),
    }
}

fn run_quietly(options: &ExperimentOptions) -> ExperimentReport {
    run(options, &mut |_| ()).unwrap()
}

fn read(folder: &Path, name: &str) -> String {
    fs::read_to_string(folder.join(name)).unwrap()
}

/// Sections that are quick enough for several runs.
const FEW: [&str; 2] = ["ransac", "outliers"];

#[test]
fn the_quick_report_is_complete_and_self_contained() {
    let folder = tempfile::tempdir().unwrap();
    let report = run_quietly(&options(folder.path(), &[]));
    assert_eq!(report.document.sections.len(), section_ids().count());
    for section in &report.document.sections {
        assert!(section.finding.contains(char::is_numeric), "{}: {}", section.id, section.finding);
        assert!(section.tables.iter().any(|t| !t.rows.is_empty()), "{} has no table", section.id);
        assert!(!section.plots.is_empty() && !section.pairs.is_empty(), "{}", section.id);
        assert!(section.command.contains(&section.id) && section.command.contains("--quick"));
        for table in section.tables.iter().chain([&report.document.budget]) {
            assert!(table.rows.iter().all(|row| row.len() == table.columns.len()), "{}", table.id);
        }
    }
    let page = read(folder.path(), "report.html");
    for section in &report.document.sections {
        assert_eq!(page.matches(&format!("<section id=\"{}\">", section.id)).count(), 1);
        assert_eq!(page.matches(&format!("href=\"#{}\"", section.id)).count(), 1);
    }
    // The SVG namespace is the only URL, and nothing is fetched from it.
    let addresses = page.replace("http://www.w3.org/2000/svg", "");
    for outside in ["http:", "https:", "//", "src=", "<script", "<link", "@import", "url("] {
        assert!(!addresses.contains(outside), "the page refers to {outside}");
    }
    assert!(!page.contains("NaN") && page.contains("two cores &amp; more"));
    for tag in ["section", "table", "svg", "figure", "p", "dl", "ol", "small", "text", "tr", "td", "th"] {
        let (opened, closed) = (format!("<{tag}"), format!("</{tag}>"));
        let begins = page.match_indices(&opened).filter(|(at, _)| page[at + opened.len()..].starts_with([' ', '>']));
        assert_eq!(begins.count(), page.matches(&closed).count(), "{tag}");
    }
    assert_eq!(serde_json::from_str::<ReportDocument>(&read(folder.path(), "report.json")).unwrap(), report.document);
}

#[test]
fn the_same_program_gives_the_same_numbers() {
    let run_once = || {
        let folder = tempfile::tempdir().unwrap();
        let mut options = options(folder.path(), &FEW);
        options.data = "absent".into();
        run_quietly(&options);
        (read(folder.path(), "report.json"), read(folder.path(), "report.html"))
    };
    assert_eq!(run_once(), run_once());
}

#[test]
fn a_second_run_computes_nothing_and_a_resumed_one_only_the_missing_units() {
    let folder = tempfile::tempdir().unwrap();
    let first = run_quietly(&options(folder.path(), &FEW));
    // The default setting belongs to several series and is computed once.
    let total = first.computed + first.reused;
    assert!(first.computed > 10);
    let json = read(folder.path(), "report.json");
    let mut told = Vec::new();
    let again = run(&options(folder.path(), &FEW), &mut |p| told.push((p.done, p.total))).unwrap();
    assert_eq!((again.computed, again.reused), (0, total));
    assert_eq!(read(folder.path(), "report.json"), json);
    assert!(told.windows(2).all(|w| w[0].0 <= w[1].0) && told.last() == Some(&(total, total)));
    // A program that is killed while it writes leaves a partial line.
    let units = read(folder.path(), "units.jsonl");
    let kept: usize = units.lines().take(5).map(|line| line.len() + 1).sum();
    fs::write(folder.path().join("units.jsonl"), &units[..kept + 20]).unwrap();
    let resumed = run_quietly(&options(folder.path(), &FEW));
    assert_eq!((resumed.computed, resumed.reused), (first.computed - 5, first.reused + 5));
    // Another version of the program computes everything again.
    let mut other = options(folder.path(), &["ransac"]);
    other.provenance.commit = "def".to_owned();
    assert!(run_quietly(&other).computed > 10);
}

/// The numbers of a table as its CSV file should have them.
fn expected_fields(table: &Table) -> Vec<Vec<f64>> {
    let numbers = |cell: &Cell| match cell {
        Cell::Count(n) => vec![*n as f64],
        Cell::Number(value) => vec![*value],
        Cell::Spread(s) => vec![s.n as f64, s.mean, s.sd, s.q1, s.median, s.q3],
        Cell::Text(_) | Cell::Missing(()) => vec![],
    };
    table.rows.iter().map(|row| row.iter().flat_map(numbers).collect()).collect()
}

#[test]
fn the_csv_tables_contain_the_numbers_of_the_json() {
    let folder = tempfile::tempdir().unwrap();
    let report = run_quietly(&options(folder.path(), &FEW));
    let document: ReportDocument = serde_json::from_str(&read(folder.path(), "report.json")).unwrap();
    let mut n_tables = 0;
    for section in &document.sections {
        for table in &section.tables {
            let text = read(folder.path(), &format!("{}-{}.csv", section.id, table.id));
            let rows: Vec<Vec<f64>> = text
                .lines()
                .skip(1)
                // The first field is the name of the setting.
                .map(|line| line.split(',').skip(1).filter_map(|field| field.parse().ok()).collect())
                .collect();
            assert_eq!(rows, expected_fields(table), "{} {}", section.id, table.id);
            n_tables += 1;
        }
    }
    assert_eq!(report.files.len(), n_tables + 3);
}

#[test]
fn one_section_can_be_run_alone_and_an_unknown_one_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let error = run(&options(folder.path(), &["magic"]), &mut |_| ()).unwrap_err();
    assert!(error.to_string().contains("there is no section magic; the sections are thesis, minimizers, products"));
    assert!(fs::read_dir(folder.path()).unwrap().next().is_none());
    let mut ids = BTreeMap::new();
    for id in section_ids() {
        *ids.entry(id).or_insert(0) += 1;
    }
    assert!(ids.values().all(|n| *n == 1));
}
