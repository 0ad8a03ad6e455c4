//! Rows of several structures of one person: which of them belong together, and the persons as subjects.
//!
//! Rows with the same `subject`, `visit` (if there is such a column, which stays a covariate) and `side` belong together
//! and differ in `structure`. Their covariates describe the person: where two rows state one, they state the same.

use super::{Cohort, Covariate, Role, Subject, no_file_name};
use serde::{Deserialize, Serialize};
use std::collections::{BTreeMap, BTreeSet};

/// What a row is in a study of several structures.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub struct StructureRow {
    /// Id of the person in all outputs; with visit and side, where the table states them.
    pub of: String,
    /// Name of the structure: letters, digits, `_`, `-` and `.`.
    pub name: String,
}

/// What tells a row from others.
pub(super) struct RowIdentity<'a> {
    /// Name of the structure.
    pub(super) structure: &'a str,
    /// Subject, visit and side; empty where there is none.
    pub(super) texts: [&'a str; 3],
    /// Role.
    pub(super) role: Role,
    /// Covariates by name; `None` where missing.
    pub(super) cells: Vec<(&'a str, Option<&'a str>)>,
}

/// The first row of a person, with the covariates that the rows before the present one state.
struct Person {
    texts: [String; 3],
    role: Role,
    line: u64,
    cells: Vec<Option<(String, u64)>>,
}

/// The rows of a table so far.
#[derive(Default)]
pub(super) struct PersonRows {
    /// By id in lower case.
    persons: BTreeMap<String, Person>,
    /// The line of each row, by person and structure.
    lines: BTreeMap<(String, String), u64>,
    /// The first spelling of each structure, by its name in lower case.
    spellings: BTreeMap<String, String>,
}

impl PersonRows {
    /// Adds a row.
    ///
    /// # Errors
    /// The column at fault, and the fault with its remedy.
    pub(super) fn add(&mut self, line: u64, row: &RowIdentity<'_>) -> Result<StructureRow, (String, String)> {
        let wrong = |column: &str, fault: String| Err((column.to_owned(), fault));
        let RowIdentity { structure, texts, role, cells } = row;
        if structure.is_empty() {
            return wrong("structure", "is empty; name the structure of the row".to_owned());
        }
        if let Some(fault) = no_file_name(structure) {
            return wrong("structure", format!("the structure names files{fault}"));
        }
        let spelling = self.spellings.entry(structure.to_lowercase()).or_insert_with(|| (*structure).to_owned());
        if spelling != structure {
            return wrong(
                "structure",
                format!("an earlier line spells {structure} as {spelling}; write it in one way"),
            );
        }
        if texts[0].is_empty() {
            return wrong("subject", "is empty; name the person, whose structures have it in common".to_owned());
        }
        let of = texts.iter().filter(|text| !text.is_empty()).copied().collect::<Vec<_>>().join("_");
        if let Some(fault) = no_file_name(&of) {
            return wrong("subject", format!("subject and visit together name files{fault}"));
        }
        let key = of.to_lowercase();
        if let Some(other) = self.lines.insert((key.clone(), (*structure).to_owned()), line) {
            let fault = format!(
                "line {other} has the same structure of the same subject, visit and side; visits of one person are told apart by a \
                 column visit"
            );
            return wrong("structure", fault);
        }
        let new = || Person { texts: texts.map(str::to_owned), role: *role, line, cells: vec![None; cells.len()] };
        let person = self.persons.entry(key).or_insert_with(new);
        if person.texts != *texts {
            let fault = format!("with visit and side it becomes {of}, as line {} does; choose another", person.line);
            return wrong("subject", fault);
        }
        if person.role != *role {
            return wrong(
                "role",
                format!("differs from that of line {}, another structure of the person", person.line),
            );
        }
        for (known, (column, text)) in person.cells.iter_mut().zip(cells) {
            match (&known, text) {
                (Some((known, other)), Some(text)) if !is_same(known, text) => {
                    let fault = format!(
                        "differs from line {other}, another structure of the person; a covariate describes the person and is stated once, \
                         or alike"
                    );
                    return wrong(column, fault);
                }
                (None, Some(text)) => *known = Some(((*text).to_owned(), line)),
                _ => {}
            }
        }
        Ok(StructureRow { of, name: (*structure).to_owned() })
    }
}

fn is_same(a: &str, b: &str) -> bool {
    a == b || matches!((a.parse::<f64>(), b.parse::<f64>()), (Ok(a), Ok(b)) if a == b)
}

impl Subject {
    /// The structure, in a study of several.
    pub fn structure_name(&self) -> Option<&str> {
        self.structure.as_ref().map(|row| row.name.as_str())
    }
}

impl Cohort {
    /// The structures in alphabetical order; empty for a study of one structure whose rows do not name it.
    pub fn structures(&self) -> Vec<String> {
        let names: BTreeSet<&str> = self.subjects.iter().filter_map(Subject::structure_name).collect();
        names.into_iter().map(str::to_owned).collect()
    }

    /// The persons with their covariates, in the order of their ids; the cohort itself if no row names a structure. A
    /// person has the file of its first structure.
    pub fn persons(&self) -> Cohort {
        let rows = self.rows_of_persons();
        if rows.is_empty() {
            return self.clone();
        }
        let person = |(of, rows): (&String, &Vec<usize>)| {
            let first = &self.subjects[rows[0]];
            Subject { id: of.clone(), labels: None, structure: None, ..first.clone() }
        };
        let subjects = rows.iter().map(person).collect();
        let covariates = self.covariates.iter().map(|Covariate { name, values }| {
            // The first row of each person that states a value.
            let first = |rows: &Vec<usize>| rows.iter().copied().find(|&k| values.is_stated(k)).unwrap_or(rows[0]);
            let stated: Vec<usize> = rows.values().map(first).collect();
            Covariate { name: name.clone(), values: values.of_rows(&stated) }
        });
        Cohort { subjects, covariates: covariates.collect() }
    }

    /// The rows of each person, by structure; persons by id.
    pub(crate) fn rows_of_persons(&self) -> BTreeMap<String, Vec<usize>> {
        let mut rows: BTreeMap<String, Vec<usize>> = BTreeMap::new();
        for (k, subject) in self.subjects.iter().enumerate() {
            if let Some(row) = &subject.structure {
                rows.entry(row.of.clone()).or_default().push(k);
            }
        }
        let name = |k: &usize| self.subjects[*k].structure_name().map(str::to_owned);
        rows.values_mut().for_each(|of| of.sort_by_key(name));
        rows
    }

    /// The cohort of these rows, in this order.
    pub(crate) fn of_rows(&self, rows: &[usize]) -> Cohort {
        let of =
            |Covariate { name, values }: &Covariate| Covariate { name: name.clone(), values: values.of_rows(rows) };
        let covariates = self.covariates.iter().map(of);
        Cohort { subjects: rows.iter().map(|&k| self.subjects[k].clone()).collect(), covariates: covariates.collect() }
    }

    /// The subfolder of `folder` for the structure of these rows: `folder` itself if they name none.
    pub(crate) fn subfolder(&self, folder: &str) -> String {
        let structure = self.subjects.first().and_then(Subject::structure_name);
        structure.map_or_else(|| folder.to_owned(), |name| format!("{folder}/{name}"))
    }
}

#[cfg(test)]
mod tests {
    use super::super::Values;
    use super::*;
    use std::path::Path;

    fn table(text: &str) -> Result<Cohort, String> {
        Cohort::from_csv(text.as_bytes(), Path::new("")).map_err(|error| error.to_string())
    }

    const ROWS: &str = "b,hippocampus,b.mgz,17,1,\na,hippocampus,a.mgz,17,1,f\na,amygdala,a.mgz,18,1,\nb,amygdala,b.mgz,18,1,m\n\
                        c,amygdala,c.mgz,18,1,m\nc,hippocampus,c.mgz,17,1,m\na,amygdala,a2.mgz,18,2,f\n";

    #[test]
    fn rows_of_a_person_and_a_visit_belong_together_and_state_covariates_once() {
        let cohort = table(&format!("subject,structure,file,label,visit,sex\n{ROWS}")).unwrap();
        assert_eq!(cohort.structures(), ["amygdala", "hippocampus"]);
        assert_eq!(cohort.subjects[1].id, "a_1.hippocampus", "the volume is named twice");
        let persons = cohort.persons();
        let ids: Vec<_> = persons.subjects.iter().map(|of| (of.id.as_str(), of.subject.as_str())).collect();
        assert_eq!(ids, [("a_1", "a"), ("a_2", "a"), ("b_1", "b"), ("c_1", "c")]);
        let factor = Values::Factor {
            levels: vec!["f".to_owned(), "m".to_owned()],
            of: vec![Some(0), Some(0), Some(1), Some(1)],
        };
        assert_eq!(persons.covariate("sex").unwrap().values, factor);
        assert_eq!(cohort.rows_of_persons()["b_1"], [3, 0], "by structure");
        assert!(persons.is_longitudinal() && persons.structures().is_empty());
        assert_eq!(persons.persons(), persons, "without structures the cohort is its persons");
    }

    #[test]
    fn faults_name_the_line_and_the_structure() {
        let header = "subject,structure,file,label,visit,sex\n";
        for (row, parts) in [
            ("a,amygdala,x.mgz,18,1,f", vec!["line 9", "column structure", "line 4", "column visit"]),
            ("d,,x.mgz,18,1,f", vec!["line 9", "column structure", "is empty"]),
            (",amygdala,x.mgz,18,1,f", vec!["line 9", "column subject", "is empty"]),
            ("d,Amygdala,x.mgz,18,1,f", vec!["line 9", "column structure", "Amygdala as amygdala"]),
            ("d,a/b,x.mgz,18,1,f", vec!["line 9", "column structure", "letters"]),
            ("a b,amygdala,x.mgz,18,1,f", vec!["line 9", "column subject", "letters"]),
            ("a_1,amygdala,x.mgz,18,,f", vec!["line 9", "line 4", "same structure"]),
            ("a,hippocampus,x.mgz,17,2,m", vec!["line 9", "column sex", "line 8"]),
            ("d,thalamus,x.mgz,10,1,f", vec!["at least 3", "1 have the structure thalamus"]),
        ] {
            let said = table(&format!("{header}{ROWS}{row}\n")).unwrap_err();
            assert!(parts.iter().all(|part| said.contains(part)), "{said}");
        }
        let said = table("id,structure,file\na,x,a.ply\n").unwrap_err();
        assert!(said.contains("no column subject"), "{said}");
        let roles = "subject,structure,file,role\na,x,a.ply,model\na,y,b.ply,score\n";
        let said = table(roles).unwrap_err();
        assert!(said.contains("line 3") && said.contains("column role") && said.contains("line 2"), "{said}");
    }
}
