//! `homolog match SOURCE TARGET TARGET …`: one source, such as a template, matched to each of several targets.

use super::companions::with_numbers;
use super::error::CliError;
use super::files::{OutputFolder, read_input};
use super::interrupt::Interrupt;
use super::match_args::MatchArgs;
use super::output::{note, print, print_json};
use super::pair::{Pair, write_page};
use super::words::on_command_line;
use homolog_contract::parameters::MatchParameters;
use homolog_contract::result::ResultDocument;
use homolog_formats::csv_cell::text_cell;
use homolog_run::SurfaceCache;
use serde_json::json;
use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};

/// Memory for prepared surfaces, bytes: the source is prepared once.
const PREPARED_BYTES: u64 = 1 << 30;

/// Matches the source to all targets. A pair that fails does not stop the others.
///
/// # Errors
/// [`CliError`]; also if a pair has failed, at the end.
pub(super) fn run(args: &MatchArgs) -> Result<(), CliError> {
    let parameters = args.parameters.resolve()?;
    if args.html.is_some() {
        let advice = "--html is for one pair; --out DIR writes a report.html for each";
        return Err(CliError::BadInput(advice.to_owned()));
    }
    // Checked before the first computation, which may be long before the last.
    for target in &args.targets {
        std::fs::metadata(target).map_err(|e| CliError::BadInput(format!("cannot read {}: {e}", target.display())))?;
    }
    let source = read_input(&args.source, &args.limits.limits())?;
    let folder = args.out.as_deref().map(OutputFolder::create).transpose()?;
    let (surfaces, interrupt) = (SurfaceCache::new(PREPARED_BYTES), Interrupt::listen());
    let n = args.targets.len();
    let mut rows = Vec::new();
    for (k, (target, name)) in args.targets.iter().zip(names(&args.targets)).enumerate() {
        let title = format!("{} of {n}", k + 1);
        let of = folder.as_ref().map(|folder| folder.path().join(&name));
        let done = one(args, &source, target, of.as_deref(), (&surfaces, &parameters, &interrupt, &title));
        if matches!(done, Err(CliError::Interrupted)) {
            return Err(CliError::Interrupted);
        }
        if args.json {
            print_json(&match &done {
                Ok(document) => json!({"target": target, "result": document}),
                Err(error) => json!({"target": target, "error": error.to_string()}),
            })?;
        } else if let Err(error) = &done {
            note(&format!("{}: {error}", target.display()));
        }
        rows.push(Row { target: target.clone(), name, done: done.map(Box::new).map_err(|error| error.to_string()) });
    }
    if let Some(folder) = &folder {
        folder.write("summary.csv", csv(&rows).as_bytes())?;
    }
    if !args.json {
        print(&table(&rows))?;
        if let Some(folder) = &folder {
            note(&format!("written to {}", folder.path().display()));
        }
    }
    match rows.iter().filter(|row| row.done.is_err()).count() {
        0 => Ok(()),
        failed => Err(CliError::Failed(format!("{failed} of {n} pairs could not be matched, see above"))),
    }
}

/// One pair: read, matched and written.
fn one(
    args: &MatchArgs,
    source: &[u8],
    target: &Path,
    folder: Option<&Path>,
    (surfaces, parameters, interrupt, title): (&SurfaceCache, &MatchParameters, &Interrupt, &str),
) -> Result<ResultDocument, CliError> {
    let limits = args.limits.limits();
    let bytes = read_input(target, &limits)?;
    let pair = Pair { source: (&args.source, source), target: (target, &bytes) };
    let parameters = with_numbers(parameters, [&args.source, target]);
    let (output, trace) = pair.matched(surfaces, (&parameters, &limits), interrupt, Some(title))?;
    if let Some(folder) = folder {
        let folder = OutputFolder::create(folder)?;
        pair.write(&folder, &output, &trace, &args.uids())?;
        write_page(&folder.path().join("report.html"), &output, &trace)?;
    }
    Ok(output.document)
}

/// A target and its outcome.
struct Row {
    target: PathBuf,
    name: String,
    done: Result<Box<ResultDocument>, String>,
}

/// A folder name for each target: its file name without extensions. Where targets of several folders share a file name,
/// the name of the folder precedes it, and where that is not unique either, a number is added.
fn names(targets: &[PathBuf]) -> Vec<String> {
    let stem = |path: &Path| {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        let stem = name.split('.').find(|part| !part.is_empty()).unwrap_or("target");
        stem.to_owned()
    };
    // In names of FreeSurfer the part after the dot carries the meaning.
    let whole = |path: &Path| path.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let with_folder = |path: &Path| match path.parent().and_then(Path::file_name) {
        Some(folder) => format!("{}-{}", folder.to_string_lossy(), stem(path)),
        None => stem(path),
    };
    let are_apart = |names: &[String]| names.iter().collect::<BTreeSet<_>>().len() == names.len();
    let tried: [&dyn Fn(&Path) -> String; 3] = [&stem, &whole, &with_folder];
    for name in tried {
        let names: Vec<String> = targets.iter().map(|path| name(path)).collect();
        if are_apart(&names) {
            return names;
        }
    }
    targets.iter().zip(1..).map(|(path, k)| format!("{k}-{}", stem(path))).collect()
}

/// A verdict in one word.
fn word(document: &ResultDocument) -> &'static str {
    match document.verdict().reliable {
        Some(true) => "reliable",
        Some(false) => "NOT RELIABLE",
        None => "not judged",
    }
}

/// A line for each target.
fn table(rows: &[Row]) -> String {
    let width = rows.iter().map(|row| row.name.chars().count()).max().unwrap_or(0).max("target".len());
    let mut text = format!("{:<width$}  {:<12}  {:>9}  {:>8}  reasons", "target", "verdict", "apart, mm", "inliers");
    for Row { name, done, .. } in rows {
        let _ = match done {
            Ok(document) => {
                let reasons: Vec<_> = document.verdict().reasons.iter().map(|reason| reason.name()).collect();
                let (mm, share) = (document.surface_distance.mean_mm, 100.0 * document.support.ratio);
                let line = format!(
                    "{name:<width$}  {:<12}  {mm:>9.2}  {share:>6.1} %  {}",
                    word(document),
                    reasons.join(", ")
                );
                write!(text, "\n{}", line.trim_end())
            }
            Err(_) => write!(text, "\n{name:<width$}  FAILED"),
        };
    }
    let n_reliable =
        rows.iter().filter_map(|row| row.done.as_ref().ok()).filter(|document| word(document) == "reliable");
    let _ = write!(text, "\n{} of {} reliable", n_reliable.count(), rows.len());
    // Advice, once for each reason.
    let mut explained = Vec::new();
    for reason in rows.iter().filter_map(|row| row.done.as_ref().ok()).flat_map(|document| document.verdict().reasons) {
        if !explained.contains(&reason) {
            explained.push(reason);
            let _ = write!(text, "\n{}: {} {}", reason.name(), reason.meaning(), on_command_line(reason.advice()));
        }
    }
    text
}

/// The table for programs.
fn csv(rows: &[Row]) -> String {
    let mut text = "target,folder,reliable,reasons,mean_mm,p95_mm,max_mm,inliers,error\n".to_owned();
    for Row { target, name, done } in rows {
        let (target, name) = (text_cell(&target.to_string_lossy()), text_cell(name));
        let _ = match done {
            Ok(document) => {
                let verdict = document.verdict();
                let reliable = verdict.reliable.map_or(String::new(), |reliable| reliable.to_string());
                let reasons: Vec<_> = verdict.reasons.iter().map(|reason| reason.name()).collect();
                let d = &document.surface_distance;
                let numbers = format!("{},{},{},{}", d.mean_mm, d.p95_mm, d.max_mm, document.support.ratio);
                writeln!(text, "{target},{name},{reliable},{},{numbers},", reasons.join(" "))
            }
            Err(error) => writeln!(text, "{target},{name},,,,,,,{}", text_cell(error)),
        };
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_files_are_no_formulas_of_the_table() {
        let error = "cannot read =1+1, \"no\"".to_owned();
        let row = Row { target: PathBuf::from("=1+1|x,y.ply"), name: "-rf".to_owned(), done: Err(error) };
        let failed = Row { target: PathBuf::from("b.ply"), name: "b".to_owned(), done: Err("@SUM(A1)".to_owned()) };
        let text = csv(&[row, failed]);
        let mut lines = text.lines().skip(1);
        assert_eq!(lines.next(), Some("\"'=1+1|x,y.ply\",'-rf,,,,,,,\"cannot read =1+1, \"\"no\"\"\""));
        assert_eq!(lines.next(), Some("b.ply,b,,,,,,,'@SUM(A1)"));
    }

    #[test]
    fn every_target_has_a_folder_of_its_own() {
        let names = |paths: &[&str]| names(&paths.iter().map(PathBuf::from).collect::<Vec<_>>());
        assert_eq!(names(&["a/s1.nii.gz", "b/s2.ply"]), ["s1", "s2"]);
        assert_eq!(names(&["lh.pial", "lh.white"]), ["lh.pial", "lh.white"]);
        assert_eq!(names(&["s1/lh.ply", "s2/lh.ply"]), ["s1-lh", "s2-lh"]);
        assert_eq!(names(&["x/s1/lh.ply", "y/s1/lh.ply"]), ["1-lh", "2-lh"]);
        assert_eq!(names(&[".hidden", "b.ply"]), ["hidden", "b"]);
    }
}
