//! The subjects of a study: a table of files with covariates, or the files of a folder.
//!
//! The table is CSV with a header. `file` is required; `id`, `subject` (the person, if one person has several visits),
//! `role`, `side`, `label` and `structure` ([`persons`]) are optional. Every other column, and `side` too, is a covariate:
//! a number if all its values are numbers, otherwise a factor. Empty cells, `NA` and `NaN` are missing values.

pub mod persons;

use homolog_contract::input::BodySide;
use homolog_contract::parameters::LabelChoice;
use persons::{PersonRows, RowIdentity, StructureRow};
use serde::{Deserialize, Serialize};
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

/// Role of a subject.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Role {
    /// Part of the shape model and of the statistics.
    Model,
    /// Only compared with the model: gets scores and a measure of how unusual its shape is.
    Score,
}

/// One surface or label volume of a study.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Subject {
    /// Name in all outputs: letters, digits, `_`, `-` and `.`, not a device name; unique.
    pub id: String,
    /// File, as named in the table.
    pub file: PathBuf,
    /// Person: rows with the same subject are visits of one person. Defaults to the id.
    pub subject: String,
    /// Role.
    pub role: Role,
    /// Side of the body; a subject of another side than the template's is mirrored.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub side: Option<BodySide>,
    /// Labels of its volume that belong to the structure; `None` for those of the settings.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub labels: Option<Vec<LabelChoice>>,
    /// Which structure of which person it is, in a study of several structures.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub structure: Option<StructureRow>,
}

/// A covariate, a value for each subject.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Covariate {
    /// Its name in the header.
    pub name: String,
    /// Its values.
    pub values: Values,
}

/// The values of a covariate; `None` where missing.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Values {
    /// Numbers.
    Numbers(Vec<Option<f64>>),
    /// Levels of a factor, given by their index in `levels`, which are in alphabetical order.
    Factor {
        /// The levels.
        levels: Vec<String>,
        /// The level of each subject.
        of: Vec<Option<usize>>,
    },
}

impl Values {
    /// Whether a subject has a value.
    pub(crate) fn is_stated(&self, subject: usize) -> bool {
        match self {
            Values::Numbers(of) => of[subject].is_some(),
            Values::Factor { of, .. } => of[subject].is_some(),
        }
    }

    /// The values of these subjects, in this order.
    pub(crate) fn of_rows(&self, rows: &[usize]) -> Values {
        match self {
            Values::Numbers(of) => Values::Numbers(rows.iter().map(|&k| of[k]).collect()),
            Values::Factor { levels, of } => {
                Values::Factor { levels: levels.clone(), of: rows.iter().map(|&k| of[k]).collect() }
            }
        }
    }
}

/// The subjects of a study and their covariates.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Cohort {
    /// In the order of the table.
    pub subjects: Vec<Subject>,
    /// In the order of the header.
    pub covariates: Vec<Covariate>,
}

/// Faults of a table. Rows are lines of the file; the header is line 1.
#[derive(Debug, thiserror::Error)]
pub enum CohortError {
    /// It is not CSV.
    #[error("the table is not CSV: {0}; write a header and rows with as many cells, separated by commas, in UTF-8")]
    NotCsv(csv::Error),
    /// A required column is missing.
    #[error("the table has no column {0}; its header names the columns, such as id,file,group,age")]
    NoColumn(&'static str),
    /// Rows of several structures do not say whose they are.
    #[error(
        "the table has a column structure and no column subject, which names the person whose structures belong together"
    )]
    NoSubjects,
    /// Two columns have the same name, or a column has none.
    #[error("column {column} of the table has {fault}; give each column a name of its own")]
    ColumnName {
        /// Its number, from 1.
        column: usize,
        /// The fault.
        fault: &'static str,
    },
    /// A cell is wrong.
    #[error("line {line} of the table, column {column}: {fault}")]
    Cell {
        /// The line of the file.
        line: u64,
        /// The column.
        column: String,
        /// The fault and its remedy.
        fault: String,
    },
    /// Too few subjects.
    #[error("a study needs at least 3 subjects; there are {0}")]
    TooFew(usize),
    /// Too few subjects with a structure.
    #[error("a study needs at least 3 subjects with each structure; {n} have the structure {structure}")]
    TooFewOfStructure {
        /// The structure.
        structure: String,
        /// Rows with it that are part of the model.
        n: usize,
    },
}

/// Extensions of files that accompany data but are not data.
const NOT_DATA: [&str; 9] = ["csv", "tsv", "txt", "md", "json", "html", "log", "pdf", "xlsx"];

impl Cohort {
    /// The subjects of a table; relative files are taken from `folder`.
    ///
    /// # Errors
    /// [`CohortError`], the first fault in the order of lines.
    pub fn from_csv(text: &[u8], folder: &Path) -> Result<Self, CohortError> {
        let text = text.strip_prefix(b"\xef\xbb\xbf").unwrap_or(text);
        let mut reader = csv::ReaderBuilder::new().trim(csv::Trim::All).from_reader(text);
        let header = reader.headers().map_err(CohortError::NotCsv)?.clone();
        let mut seen = BTreeSet::new();
        for (k, name) in header.iter().enumerate() {
            let fault = if name.is_empty() {
                "no name"
            } else if !seen.insert(name) {
                "the name of an earlier one"
            } else {
                continue;
            };
            return Err(CohortError::ColumnName { column: k + 1, fault });
        }
        let place = |name: &str| header.iter().position(|column| column == name);
        let file_at = place("file").ok_or(CohortError::NoColumn("file"))?;
        let [id_at, subject_at, role_at, side_at, label_at, structure_at] =
            ["id", "subject", "role", "side", "label", "structure"].map(place);
        if structure_at.is_some() && subject_at.is_none() {
            return Err(CohortError::NoSubjects);
        }
        let own = [Some(file_at), id_at, subject_at, role_at, label_at, structure_at];
        let is_covariate = |k: &usize| !own.contains(&Some(*k));
        let (visit_at, mut persons) = (place("visit"), PersonRows::default());
        let (mut subjects, mut cells): (Vec<Subject>, Vec<Vec<String>>) = (Vec::new(), vec![Vec::new(); header.len()]);
        let mut ids = BTreeSet::new();
        for row in reader.records() {
            let row = row.map_err(CohortError::NotCsv)?;
            let line = row.position().map_or(0, csv::Position::line);
            let cell = |at: Option<usize>| at.and_then(|k| row.get(k)).filter(|text| !text.is_empty());
            let wrong = |column: &str, fault: String| CohortError::Cell { line, column: column.to_owned(), fault };
            let file =
                cell(Some(file_at)).ok_or_else(|| wrong("file", "is empty; name the subject's file".to_owned()))?;
            let role = match cell(role_at) {
                None | Some("model") => Role::Model,
                Some("score") => Role::Score,
                Some(_) => return Err(wrong("role", "is neither model, score nor empty".to_owned())),
            };
            let side = cell(side_at).filter(|text| is_present(text)).map(|text| {
                let fault =
                    "is neither left (l, lh), right (r, rh) nor empty; a column of another meaning needs another name";
                BodySide::of_name(text).ok_or_else(|| wrong("side", fault.to_owned()))
            });
            let side = side.transpose()?;
            let structure = structure_at.map(|_| {
                let texts =
                    [cell(subject_at), cell(visit_at).filter(|text| is_present(text)), side.map(BodySide::name)];
                let texts = texts.map(Option::unwrap_or_default);
                let cells = (0..header.len()).filter(is_covariate);
                let cells = cells.map(|k| (&header[k], row.get(k).filter(|text| is_present(text)))).collect();
                let identity = RowIdentity { structure: cell(structure_at).unwrap_or_default(), texts, role, cells };
                persons.add(line, &identity).map_err(|(column, fault)| wrong(&column, fault))
            });
            let structure = structure.transpose()?;
            let own_id =
                || structure.as_ref().map_or_else(|| stem(Path::new(file)), |of| format!("{}.{}", of.of, of.name));
            let id = cell(id_at).map_or_else(own_id, str::to_owned);
            let column = if id_at.is_some() { "id" } else { "file" };
            if let Some(fault) = no_file_name(&id) {
                return Err(wrong(column, format!("the id names files{fault}")));
            }
            if !ids.insert(id.to_lowercase()) {
                let fault =
                    "an earlier line has the same id (in upper or lower case); add a column id with different ones";
                return Err(wrong(column, fault.to_owned()));
            }
            let labels = cell(label_at).filter(|text| is_present(text)).map(label_choices).transpose();
            let labels = labels.map_err(|fault| wrong("label", fault.to_owned()))?;
            let subject = cell(subject_at).map_or_else(|| id.clone(), str::to_owned);
            subjects.push(Subject { id, file: folder.join(file), subject, role, side, labels, structure });
            for (k, (column, text)) in cells.iter_mut().zip(row.iter()).enumerate() {
                let side = side.filter(|_| side_at == Some(k));
                column.push(side.map_or_else(|| text.to_owned(), |side| side.name().to_owned()));
            }
        }
        let covariates = (0..header.len()).filter(is_covariate);
        let covariates = covariates.map(|k| covariate(header.get(k).unwrap_or_default(), &cells[k])).collect();
        Cohort { subjects, covariates }.checked()
    }

    /// The subjects of a table of cells, the header first, as read by [`Cohort::from_csv`]; file names are kept
    /// unchanged.
    ///
    /// # Errors
    /// The errors of [`Cohort::from_csv`]; row `k` is line `k + 1` if no cell has a line break.
    pub fn from_rows(rows: impl Iterator<Item = Vec<String>>) -> Result<Self, CohortError> {
        let mut table = csv::Writer::from_writer(Vec::new());
        for row in rows {
            table.write_record(&row).map_err(CohortError::NotCsv)?;
        }
        // A vector buffers nothing that could fail.
        Cohort::from_csv(&table.into_inner().unwrap_or_default(), Path::new(""))
    }

    /// One subject per file, in the order of the file names, without covariates. Tables, texts and hidden files are
    /// left out.
    ///
    /// # Errors
    /// [`CohortError::TooFew`]; [`CohortError::Cell`] if two files have the same stem.
    pub fn from_files(mut files: Vec<PathBuf>) -> Result<Self, CohortError> {
        files.sort();
        files.retain(|file| {
            let name = file.file_name().unwrap_or_default().to_string_lossy();
            let ending = name.rsplit_once('.').map(|(_, ending)| ending.to_lowercase()).unwrap_or_default();
            !name.starts_with('.') && !NOT_DATA.contains(&ending.as_str())
        });
        let whole = |file: &PathBuf| file.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let stems: BTreeSet<_> = files.iter().map(|file| stem(file)).collect();
        let unique = stems.len() == files.len();
        let subjects = files.into_iter().map(|file| {
            let id: String = if unique { stem(&file) } else { whole(&file) };
            let id: String = id.chars().map(|c| if is_plain(c) { c } else { '_' }).collect();
            let id = if id.starts_with('-') || is_device(&id) { format!("_{id}") } else { id };
            Subject { subject: id.clone(), id, file, role: Role::Model, side: None, labels: None, structure: None }
        });
        Cohort { subjects: subjects.collect(), covariates: Vec::new() }.checked()
    }

    fn checked(self) -> Result<Self, CohortError> {
        let n = self.subjects.iter().filter(|subject| subject.role == Role::Model).count();
        if n < 3 {
            return Err(CohortError::TooFew(n));
        }
        for structure in self.structures() {
            let is_of =
                |subject: &&Subject| subject.role == Role::Model && subject.structure_name() == Some(&structure);
            let n = self.subjects.iter().filter(is_of).count();
            if n < 3 {
                return Err(CohortError::TooFewOfStructure { structure, n });
            }
        }
        Ok(self)
    }

    /// The covariate with a given name.
    pub fn covariate(&self, name: &str) -> Option<&Covariate> {
        self.covariates.iter().find(|covariate| covariate.name == name)
    }

    /// Whether a subject has several visits.
    pub fn is_longitudinal(&self) -> bool {
        let people: BTreeSet<_> = self.subjects.iter().map(|subject| &subject.subject).collect();
        people.len() < self.subjects.len()
    }
}

fn is_plain(c: char) -> bool {
    c.is_ascii_alphanumeric() || matches!(c, '_' | '-' | '.')
}

/// Why a text cannot name files, to be read after the words "names files".
fn no_file_name(text: &str) -> Option<&'static str> {
    if text.is_empty() || !text.chars().all(is_plain) || text.starts_with(['.', '-']) {
        return Some(", so it has only letters, digits, _, - and ., and does not begin with . or -");
    }
    is_device(text).then_some(", and Windows takes it for a device; choose another")
}

/// Whether Windows reserves a name, with any extension, for a device, so that no file can have it.
fn is_device(name: &str) -> bool {
    let stem = name.split('.').next().unwrap_or_default().to_ascii_uppercase();
    let port = stem.strip_prefix("COM").or(stem.strip_prefix("LPT"));
    matches!(stem.as_str(), "CON" | "PRN" | "AUX" | "NUL")
        || port.is_some_and(|n| matches!(n.as_bytes(), [b'1'..=b'9']))
}

/// The name of a file up to its first dot.
fn stem(file: &Path) -> String {
    let name = file.file_name().unwrap_or_default().to_string_lossy();
    name.split('.').find(|part| !part.is_empty()).unwrap_or_default().to_owned()
}

fn is_present(text: &str) -> bool {
    !(text.is_empty() || text == "NA" || text.eq_ignore_ascii_case("nan"))
}

/// The labels of a cell: numbers or names, separated by semicolons.
fn label_choices(text: &str) -> Result<Vec<LabelChoice>, &'static str> {
    let choice = |part: &str| match (part, part.parse::<u32>()) {
        ("", _) => Err("has an empty entry; write numbers or names of labels, separated by semicolons"),
        (_, Ok(0)) => Err("names label 0, which is the background; name labels from 1 on"),
        (_, Ok(number)) => Ok(LabelChoice::Number(number)),
        (name, Err(_)) => Ok(LabelChoice::Name(name.to_owned())),
    };
    text.split(';').map(|part| choice(part.trim())).collect()
}

fn covariate(name: &str, cells: &[String]) -> Covariate {
    let present = |text: &&String| is_present(text);
    let number = |text: &String| text.parse::<f64>().ok().filter(|value| value.is_finite());
    let name = name.to_owned();
    if cells.iter().filter(present).all(|text| number(text).is_some()) {
        return Covariate { name, values: Values::Numbers(cells.iter().map(number).collect()) };
    }
    let levels: BTreeSet<&String> = cells.iter().filter(present).collect();
    let levels: Vec<String> = levels.into_iter().cloned().collect();
    let of = cells.iter().map(|text| levels.iter().position(|level| level == text)).collect();
    Covariate { name, values: Values::Factor { levels, of } }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn table(text: &str) -> Result<Cohort, String> {
        Cohort::from_csv(text.as_bytes(), Path::new("data")).map_err(|error| error.to_string())
    }

    #[test]
    fn columns_are_numbers_or_factors() {
        let cohort = table(
            "\u{feff}id,file,group,age,note\r\na,x/a.ply,patient,61.5,\r\nb,b.ply,control,NA,7\r\n\"c\",c.ply,patient,70,x\r\n",
        )
        .unwrap();
        assert_eq!(cohort.subjects[0].file, Path::new("data/x/a.ply"));
        assert_eq!(cohort.subjects[2].subject, "c");
        assert_eq!(cohort.covariate("age").unwrap().values, Values::Numbers(vec![Some(61.5), None, Some(70.0)]));
        let factor = Values::Factor {
            levels: vec!["control".to_owned(), "patient".to_owned()],
            of: vec![Some(1), Some(0), Some(1)],
        };
        assert_eq!(cohort.covariate("group").unwrap().values, factor);
        assert!(
            matches!(&cohort.covariate("note").unwrap().values, Values::Factor { levels, .. } if levels.len() == 2)
        );
        assert!(!cohort.is_longitudinal());
    }

    #[test]
    fn faults_name_line_and_column_and_what_to_do() {
        let rows = "a,a.ply\nb,b.ply\nc,c.ply\n";
        for (text, parts) in [
            ("id,group\na,1\n".to_owned(), vec!["no column file"]),
            (format!("id,id\n{rows}"), vec!["column 2", "name of its own"]),
            (format!("id,file\n{rows}A,d.ply\n"), vec!["line 5", "column id", "same id"]),
            (format!("id,file\n{rows}d,\n"), vec!["line 5", "column file", "is empty"]),
            (format!("id,file\n{rows}a/b,d.ply\n"), vec!["line 5", "column id", "letters"]),
            (format!("id,file\n{rows}-rf,d.ply\n"), vec!["line 5", "column id", "begin with . or -"]),
            (format!("id,file\n{rows}con.1,d.ply\n"), vec!["line 5", "column id", "device"]),
            (format!("file\n{}Com9.ply\n", "x.ply\ny.ply\nz.ply\n"), vec!["line 5", "column file", "device"]),
            ("file,role\na.ply,model\nb.ply,modle\n".to_owned(), vec!["line 3", "column role", "score"]),
            ("id,file\na,a.ply\nb,b.ply\n".to_owned(), vec!["at least 3", "2"]),
            ("id,file\na,a.ply,1\n".to_owned(), vec!["not CSV", "as many cells"]),
        ] {
            let said = table(&text).unwrap_err();
            assert!(parts.iter().all(|part| said.contains(part)), "{said}");
        }
    }

    #[test]
    fn a_side_is_read_in_every_spelling_and_is_a_covariate_too() {
        let cohort = table("file,side\na.ply,L\nb.ply,rh\nc.ply,Right\nd.ply,\n").unwrap();
        let sides: Vec<_> = cohort.subjects.iter().map(|subject| subject.side).collect();
        assert_eq!(sides, [Some(BodySide::Left), Some(BodySide::Right), Some(BodySide::Right), None]);
        let levels = vec!["left".to_owned(), "right".to_owned()];
        let factor = Values::Factor { levels, of: vec![Some(0), Some(1), Some(1), None] };
        assert_eq!(cohort.covariate("side").unwrap().values, factor);
        let said = table("file,side\na.ply,left\nb.ply,lfet\nc.ply,right\n").unwrap_err();
        assert!(said.contains("line 3") && said.contains("column side") && said.contains("left (l, lh)"), "{said}");
    }

    #[test]
    fn rows_of_one_file_use_labels_of_their_own() {
        let cohort =
            table("id,file,label\nl,a.mgz,17\nr,a.mgz, 53\nb,b.mgz,Left-CA1; Left-CA2;1005\nc,c.mgz,\n").unwrap();
        let labels: Vec<_> = cohort.subjects.iter().map(|subject| subject.labels.clone()).collect();
        let name = |name: &str| LabelChoice::Name(name.to_owned());
        let of_b = vec![name("Left-CA1"), name("Left-CA2"), LabelChoice::Number(1005)];
        assert_eq!(
            labels,
            [Some(vec![LabelChoice::Number(17)]), Some(vec![LabelChoice::Number(53)]), Some(of_b), None]
        );
        assert!(cohort.covariates.is_empty(), "a label is no covariate");
        for (cell, part) in [("0", "background"), ("17;;18", "empty entry")] {
            let said = table(&format!("file,label\na.mgz,17\nb.mgz,{cell}\nc.mgz,\n")).unwrap_err();
            assert!(said.contains("line 3") && said.contains("column label") && said.contains(part), "{said}");
        }
    }

    #[test]
    fn a_folder_has_a_subject_for_each_file_of_data() {
        let files = ["b.nii.gz", "a.ply", ".hidden", "notes.txt", "c d.vtk"].map(PathBuf::from).to_vec();
        let ids: Vec<_> = Cohort::from_files(files).unwrap().subjects.into_iter().map(|s| s.id).collect();
        assert_eq!(ids, ["a", "b", "c_d"]);
        let files = ["-rf.ply", "NUL.ply", "comet.ply"].map(PathBuf::from).to_vec();
        let ids: Vec<_> = Cohort::from_files(files).unwrap().subjects.into_iter().map(|s| s.id).collect();
        assert_eq!(ids, ["_-rf", "_NUL", "comet"]);
        let files = ["lh.pial", "lh.white", "rh.pial"].map(PathBuf::from).to_vec();
        let ids: Vec<_> = Cohort::from_files(files).unwrap().subjects.into_iter().map(|s| s.id).collect();
        assert_eq!(ids, ["lh.pial", "lh.white", "rh.pial"]);
    }
}
