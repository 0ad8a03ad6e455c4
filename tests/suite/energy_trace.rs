//! The energy trace of real matches against its contract, the table of docs/api.md.

use super::cli::{homolog, read_json};
use homolog_primitives::observe::Quantity;
use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

/// A row of the table: quantities, phases, and how the points change within a series.
struct Row {
    quantities: Vec<String>,
    phases: Vec<String>,
    within: String,
}

fn contract() -> Vec<Row> {
    let page = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/api.md")).unwrap();
    let section = page.split_once("\n## The energy trace\n").unwrap().1.split("\n## ").next().unwrap().to_owned();
    let names = |cell: &str| cell.split('`').skip(1).step_by(2).map(str::to_owned).collect::<Vec<_>>();
    let is_row = |line: &&str| line.starts_with("| `") && !line.contains("| phases |");
    let rows = section.lines().filter(is_row).map(|row| {
        let cells: Vec<&str> = row.trim_matches('|').split('|').map(str::trim).collect();
        Row { quantities: names(cells[0]), phases: names(cells[1]), within: cells[3].to_owned() }
    });
    rows.collect()
}

/// Result and trace of a pair of small surfaces.
fn matched(folder: &Path, options: &[&str]) -> (Value, Vec<Value>) {
    let out = folder.join("out");
    let _ = fs::remove_dir_all(&out);
    let mut run = homolog();
    run.arg("match")
        .args(["source.ply", "target.ply"].map(|name| folder.join(name)))
        .args(options)
        .arg("--out")
        .arg(&out);
    let done = run.output().unwrap();
    assert!(done.status.success(), "{options:?}: {}", String::from_utf8_lossy(&done.stderr));
    let trace = fs::read_to_string(out.join("trace.jsonl")).unwrap();
    (read_json(&out.join("result.json")), trace.lines().map(|line| serde_json::from_str(line).unwrap()).collect())
}

#[test]
fn real_traces_keep_the_contract_in_the_documentation() {
    let contract = contract();
    let stated: BTreeSet<&str> = contract.iter().flat_map(|row| row.quantities.iter().map(String::as_str)).collect();
    assert_eq!(stated, Quantity::ALL.into_iter().map(Quantity::name).collect(), "every quantity has a row");
    let ends = ["may rise", "falls", "one point"];
    assert!(contract.iter().all(|row| ends.contains(&row.within.as_str())));

    let folder = tempfile::tempdir().unwrap();
    let made = homolog()
        .args(["phantom", "--kind", "surface", "--edge", "2.2", "--rotate-seed", "4", "--out"])
        .arg(folder.path())
        .output()
        .unwrap();
    assert!(made.status.success());
    let bounded = ["--method", "thesis", "--set", "inference.lower_bound_iterations=20"];
    let (mut n_fallen, mut n_bounds) = (0, 0);
    let mut seen = BTreeSet::new();
    for options in
        [&[][..], &bounded, &["--method", "metropolis", "--set", "inference.max_iterations=30"], &["--method", "rigid"]]
    {
        let (result, points) = matched(folder.path(), options);
        let mut series: BTreeMap<String, f64> = BTreeMap::new();
        let mut bound = f64::NEG_INFINITY;
        for (place, point) in points.iter().enumerate() {
            let Some(energy) = point["energy"].as_f64() else {
                assert!(point.get("quantity").is_none(), "{point}");
                continue;
            };
            let (quantity, phase) = (point["quantity"].as_str().unwrap(), point["phase"].as_str().unwrap());
            let is_of =
                |row: &&Row| row.quantities.iter().any(|of| of == quantity) && row.phases.iter().any(|of| of == phase);
            let row = contract.iter().find(is_of).unwrap_or_else(|| panic!("no row of {quantity} in {phase}"));
            seen.insert((quantity.to_owned(), phase.to_owned()));
            let key = format!("{quantity} {} {}", point["round"], point["start"]);
            let before = series.insert(key, energy);
            if row.within == "falls" {
                assert!(before.is_some_and(|before| energy <= before), "{options:?}: {before:?} before {point}");
                n_fallen += 1;
            }
            let parts = [&point["energy_unary"], &point["energy_pairwise"]].map(Value::as_f64);
            if let [Some(unary), Some(pairwise)] = parts {
                assert!((unary + pairwise - energy).abs() <= 1e-9 * energy.abs().max(1.0), "{point}");
            }
            if let Some(known) = point["lower_bound"].as_f64() {
                assert!(known >= bound && energy >= known - 1e-6 * energy.abs(), "{bound} before {point}");
                (bound, n_bounds) = (known, n_bounds + 1);
            }
            let is_last = place + 1 == points.len();
            assert_eq!(point["chosen"], is_last && phase == "reporting", "{point}");
        }
        match result["energy"]["final"].as_f64() {
            Some(of_answer) => {
                let last = points.last().unwrap();
                assert!(last["chosen"] == true && last["energy"].as_f64() == Some(of_answer), "{last}");
            }
            None => assert!(points.iter().all(|point| point["chosen"] == false)),
        }
        let numbers: Vec<u64> = points.iter().map(|point| point["seq"].as_u64().unwrap()).collect();
        assert_eq!(numbers, (1..=points.len() as u64).collect::<Vec<_>>());
    }
    assert!(n_fallen > 0 && n_bounds > 1, "{n_fallen} {n_bounds}");
    for (quantity, phase) in [
        ("isometry_energy", "inference"),
        ("isometry_energy", "registration"),
        ("isometry_energy", "reporting"),
        ("curvature_energy", "bounding"),
        ("curvature_energy", "inference"),
        ("curvature_energy", "reporting"),
        ("field_energy", "displacement"),
    ] {
        assert!(seen.contains(&(quantity.to_owned(), phase.to_owned())), "no {quantity} in {phase}: {seen:?}");
    }
}
