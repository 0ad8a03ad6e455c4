//! The folder of a study: records of matches, the kept template, decisions, and files that are written as a whole.
//!
//! It is on disk or in memory ([`crate::storage`]).

use crate::align::Shapes;
use crate::error::StudyError;
use crate::plan::{PoseEvidence, Records, Round, Template, TemplateHistory, hash};
use crate::record::{Record, read_points};
use crate::storage::{Inputs, Storage};
use homolog_contract::parameters::LabelChoice;
use homolog_formats::ReadLimits;
use homolog_formats::csv_cell::{text_cell, text_of_cell};
use homolog_formats::ply::read_ply;
use parking_lot::Mutex;
use serde::{Deserialize, Serialize};
use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::fs;
use std::io;
use std::ops::Range;
use std::path::Path;
use std::sync::atomic::AtomicU64;

/// Subfolders; the first is the folder itself, of which only files are looked at.
const PARTS: [&str; 7] = ["", "matches", "template", "modes", "maps", "subjects", "labels"];

/// A study's folder.
#[derive(Debug)]
pub struct Folder {
    place: Storage,
    /// Keys of records that were read completely and are intact.
    sound: Mutex<BTreeSet<String>>,
    /// What records say about poses, by their keys.
    poses: Mutex<HashMap<String, PoseEvidence>>,
}

/// The kept template, apart from its surface.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Kept {
    /// Settings it was made for; other settings require another template.
    pub asked: String,
    /// Hash of the template's file.
    pub hash: String,
    /// Ids of the subjects it was made from.
    pub from: Vec<String>,
    /// The labels that these subjects state for their volumes, by id.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub labels: BTreeMap<String, Vec<LabelChoice>>,
    /// Ids of the subjects used to measure consistency.
    pub ring: Vec<String>,
    /// The rounds that made it.
    pub rounds: Vec<Round>,
}

/// A person's decision on a subject.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Decision {
    /// The subject.
    pub id: String,
    /// Whether the subject stays in the model and the statistics.
    pub decision: Verdict,
    /// Reason.
    pub reason: String,
}

/// A decision.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Verdict {
    /// The subject stays, regardless of its match.
    Kept,
    /// The subject is left out.
    Dropped,
}

pub(crate) fn failed(what: &'static str, path: &Path) -> impl FnOnce(io::Error) -> StudyError {
    let path = path.to_owned();
    move |source| StudyError::File { what, path, source }
}

impl Folder {
    /// Opens the folder, creating it if it does not exist.
    ///
    /// # Errors
    /// [`StudyError::File`] if it cannot be written.
    pub fn create(path: &Path) -> Result<Self, StudyError> {
        for part in ["matches", "template"] {
            let part = path.join(part);
            fs::create_dir_all(&part).map_err(failed("write", &part))?;
        }
        let place = Storage::Disk(path.to_owned(), AtomicU64::new(0));
        place.sweep(&PARTS).map_err(|(part, error)| failed("read", &part)(error))?;
        Ok(Folder { place, sound: Mutex::default(), poses: Mutex::default() })
    }

    /// A folder in memory with these files, by name, for subjects whose files are elsewhere.
    pub fn in_memory(files: BTreeMap<String, Vec<u8>>, inputs: Box<dyn Inputs>) -> Self {
        Folder { place: Storage::Memory(Mutex::new(files), inputs), sound: Mutex::default(), poses: Mutex::default() }
    }

    /// The files of a folder in memory, by name; empty for a folder on disk.
    pub fn into_files(self) -> BTreeMap<String, Vec<u8>> {
        match self.place {
            Storage::Disk(..) => BTreeMap::new(),
            Storage::Memory(files, _) => files.into_inner(),
        }
    }

    /// The content of a subject's file.
    ///
    /// # Errors
    /// [`StudyError::File`].
    pub fn input(&self, file: &Path) -> Result<Vec<u8>, StudyError> {
        self.place.input(file).map_err(failed("read", file))
    }

    /// The hash of a subject's file.
    ///
    /// # Errors
    /// [`StudyError::File`].
    pub(crate) fn input_hash(&self, file: &Path) -> Result<String, StudyError> {
        self.place.input_hash(file).map_err(failed("read", file))
    }

    /// Writes a file of the folder as a whole, creating its parent folders.
    ///
    /// # Errors
    /// [`StudyError::File`].
    pub fn write(&self, name: &str, bytes: &[u8]) -> Result<(), StudyError> {
        self.place.write(name, bytes).map_err(|error| failed("write", &self.place.path(name))(error))
    }

    /// A file of the folder; `None` if there is none.
    ///
    /// # Errors
    /// [`StudyError::File`].
    pub fn read(&self, name: &str) -> Result<Option<Vec<u8>>, StudyError> {
        self.place.read(name).map_err(|error| failed("read", &self.place.path(name))(error))
    }

    /// Keeps a record.
    ///
    /// # Errors
    /// [`StudyError::File`].
    pub fn keep(&self, key: &str, record: &Record) -> Result<(), StudyError> {
        self.write(&record_name(key), &record.to_bytes())
    }

    /// The template kept in a subfolder, if it was made for these settings.
    ///
    /// # Errors
    /// [`StudyError::Damaged`]; [`StudyError::File`].
    pub fn kept(&self, part: &str, asked: &str) -> Result<Option<(Kept, Template)>, StudyError> {
        let Some(text) = self.read(&format!("{part}/kept.json"))? else { return Ok(None) };
        let path = self.place.path(part);
        let damaged = |why: &str| StudyError::Damaged {
            path: path.clone(),
            why: format!("{why}; delete this folder, and the template is made again"),
        };
        let kept: Kept = serde_json::from_slice(&text).map_err(|_| damaged("kept.json is not what was written"))?;
        if kept.asked != asked {
            return Ok(None);
        }
        let ply = self.read(&format!("{part}/template.ply"))?.ok_or_else(|| damaged("template.ply is missing"))?;
        if hash(&ply) != kept.hash {
            return Err(damaged("template.ply has changed"));
        }
        let mesh = read_ply(&ply, &ReadLimits::default()).map_err(|_| damaged("template.ply is no surface"))?.mesh;
        Ok(Some((kept.clone(), Template { mesh, hash: kept.hash, ply })))
    }

    /// Stores a template in a subfolder: first the surface, then the file that names it.
    ///
    /// # Errors
    /// [`StudyError::File`].
    pub fn keep_template(&self, part: &str, kept: &Kept, making: &TemplateHistory) -> Result<(), StudyError> {
        self.write(&format!("{part}/template.ply"), &making.template.ply)?;
        self.write(&format!("{part}/kept.json"), &json(kept))
    }

    /// The shapes of records, read from their files in parts.
    pub(crate) fn shapes(&self, keys: Vec<(String, String)>, n_vertices: usize) -> RecordedShapes<'_> {
        RecordedShapes { folder: self, keys, n_vertices }
    }

    /// Removes the records of a subfolder of those of matches that are not among these, and its other files except `others`.
    pub(crate) fn keep_records(&self, part: &str, keys: &[String], others: &[&str]) {
        let file = |key: &String| Some(format!("{}.match", key.strip_prefix(part)?.strip_prefix('/')?));
        let mut names: BTreeSet<String> = keys.iter().filter_map(file).collect();
        names.extend(others.iter().map(|name| (*name).to_owned()));
        self.keep_only(&format!("matches/{part}"), &names);
    }

    /// Removes the files of a folder of outputs that are not among these names.
    pub(crate) fn keep_only(&self, part: &str, names: &BTreeSet<String>) {
        self.place.keep_only(part, names);
    }
}

/// The file of a record.
pub fn record_name(key: &str) -> String {
    format!("matches/{key}.match")
}

/// Formatted JSON with a final line end.
pub(crate) fn json(value: &impl Serialize) -> Vec<u8> {
    let mut text = serde_json::to_vec_pretty(value).unwrap_or_default();
    text.push(b'\n');
    text
}

impl Records for Folder {
    fn get(&self, key: &str) -> Result<Option<Record>, StudyError> {
        let Some(bytes) = self.read(&record_name(key))? else { return Ok(None) };
        match Record::from_bytes(&bytes) {
            Ok(record) => Ok(Some(record)),
            Err(error) => {
                let path = self.place.path(&record_name(key));
                Err(StudyError::Damaged { path, why: error.to_string() })
            }
        }
    }

    /// Whether an intact record exists. A damaged record, for example after a full disk or a torn write, is removed and
    /// computed again.
    fn has(&self, key: &str) -> bool {
        let mut sound = self.sound.lock();
        if sound.contains(key) {
            return true;
        }
        match self.get(key) {
            Ok(Some(_)) => sound.insert(key.to_owned()),
            Ok(None) => false,
            Err(_) => {
                self.place.remove(&record_name(key));
                false
            }
        }
    }

    /// Reads each record once.
    fn pose(&self, key: &str, read: &dyn Fn(&Record) -> PoseEvidence) -> Result<Option<PoseEvidence>, StudyError> {
        if let Some(known) = self.poses.lock().get(key) {
            return Ok(Some(known.clone()));
        }
        let Some(record) = self.get(key)? else { return Ok(None) };
        let said = read(&record);
        self.poses.lock().insert(key.to_owned(), said.clone());
        Ok(Some(said))
    }
}

/// Shapes of records.
pub(crate) struct RecordedShapes<'a> {
    folder: &'a Folder,
    /// Key and id of each record.
    keys: Vec<(String, String)>,
    n_vertices: usize,
}

impl Shapes for RecordedShapes<'_> {
    fn len(&self) -> usize {
        self.keys.len()
    }
    fn n_vertices(&self) -> usize {
        self.n_vertices
    }
    fn read(&self, shape: usize, vertices: Range<usize>) -> Result<Vec<[f32; 3]>, StudyError> {
        let name = record_name(&self.keys[shape].0);
        let at = |vertex: usize| Record::POINTS_AT + 12 * vertex as u64;
        let place = &self.folder.place;
        let bytes = place
            .read_part(&name, at(vertices.start)..at(vertices.end))
            .map_err(|error| failed("read", &place.path(&name))(error))?;
        Ok(read_points(&bytes))
    }
    fn name(&self, shape: usize) -> String {
        self.keys[shape].1.clone()
    }
}

/// Decisions from CSV: `id`, `decision` (`kept` or `dropped`) and `reason`.
///
/// # Errors
/// The fault, with its line.
pub fn read_decisions(text: &[u8], ids: &BTreeSet<&str>) -> Result<Vec<Decision>, String> {
    let mut reader = csv::ReaderBuilder::new().trim(csv::Trim::All).from_reader(text);
    let mut decisions: Vec<Decision> = Vec::new();
    for row in reader.deserialize() {
        let mut decision: Decision = row.map_err(|error| {
            format!("the decisions are not a table of id, decision (kept or dropped) and reason: {error}")
        })?;
        for text in [&mut decision.id, &mut decision.reason] {
            *text = text_of_cell(text).to_owned();
        }
        if !ids.contains(decision.id.as_str()) {
            return Err(format!("the decisions name {}, which is no subject of the study", decision.id));
        }
        if decisions.iter().any(|other| other.id == decision.id) {
            return Err(format!("the decisions name {} twice; leave one of them", decision.id));
        }
        decisions.push(decision);
    }
    Ok(decisions)
}

/// The decisions as a CSV table, readable by [`read_decisions`].
pub fn decisions_table(decisions: &[Decision]) -> String {
    let mut text = "id,decision,reason\n".to_owned();
    for Decision { id, decision, reason } in decisions {
        let word = match decision {
            Verdict::Kept => "kept",
            Verdict::Dropped => "dropped",
        };
        text.push_str(&format!("{},{word},{}\n", text_cell(id), text_cell(reason)));
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::record::Facts;

    #[test]
    fn a_damaged_record_is_computed_again() {
        let place = tempfile::tempdir().unwrap();
        let record = Record { facts: Facts::default(), points: vec![[1.0, 2.0, 3.0]; 5] };
        let folder = Folder::create(place.path()).unwrap();
        folder.keep("ab", &record).unwrap();
        assert!(folder.has("ab") && !folder.has("cd"));
        let path = place.path().join("matches/ab.match");
        let bytes = fs::read(&path).unwrap();
        fs::write(&path, &bytes[..20]).unwrap();
        fs::write(place.path().join("matches/cd.1-2.study.tmp"), "half").unwrap();
        fs::write(place.path().join("report.1-3.study.tmp"), "half").unwrap();
        let folder = Folder::create(place.path()).unwrap();
        assert!(!place.path().join("report.1-3.study.tmp").exists());
        assert!(!folder.has("ab") && !path.exists(), "removed, to be computed again");
        assert_eq!(fs::read_dir(place.path().join("matches")).unwrap().count(), 0);
        folder.keep("ab", &record).unwrap();
        assert_eq!(folder.get("ab").unwrap(), Some(record.clone()));
        let shapes = folder.shapes(vec![("ab".to_owned(), "s".to_owned())], 5);
        assert_eq!(shapes.read(0, 2..4).unwrap(), record.points[2..4]);
    }

    #[derive(Debug)]
    struct Nothing;

    impl Inputs for Nothing {
        fn read(&self, _: &Path) -> io::Result<Vec<u8>> {
            Err(io::ErrorKind::NotFound.into())
        }
        fn hash(&self, _: &Path) -> io::Result<String> {
            Err(io::ErrorKind::NotFound.into())
        }
    }

    #[test]
    fn a_folder_in_memory_does_what_one_on_disk_does() {
        let record = Record { facts: Facts::default(), points: vec![[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]] };
        let damaged = BTreeMap::from([(record_name("cd"), b"half".to_vec())]);
        let folder = Folder::in_memory(damaged, Box::new(Nothing));
        assert!(!folder.has("cd") && folder.read(&record_name("cd")).unwrap().is_none(), "removed");
        folder.keep("ab", &record).unwrap();
        assert!(folder.has("ab"));
        assert_eq!(folder.get("ab").unwrap(), Some(record.clone()));
        let shapes = folder.shapes(vec![("ab".to_owned(), "s".to_owned())], 2);
        assert_eq!(shapes.read(0, 1..2).unwrap(), record.points[1..]);
        assert!(shapes.read(0, 1..9000).is_err(), "beyond its points");
        for name in ["maps/a.vtk", "maps/b.vtk", "mapsb.vtk"] {
            folder.write(name, b"x").unwrap();
        }
        folder.keep_only("maps", &BTreeSet::from(["b.vtk".to_owned()]));
        assert!(matches!(folder.input(Path::new("s.ply")), Err(StudyError::File { what: "read", .. })));
        let names: Vec<String> = folder.into_files().into_keys().collect();
        assert_eq!(names, ["maps/b.vtk", "mapsb.vtk", "matches/ab.match"]);
    }

    #[test]
    fn decisions_are_about_subjects_of_the_study() {
        let ids = BTreeSet::from(["a", "b"]);
        let read = |text: &str| read_decisions(text.as_bytes(), &ids);
        let found = read("id,decision,reason\na,dropped,\"motion, see scan\"\n").unwrap();
        assert_eq!((found[0].decision, found[0].reason.as_str()), (Verdict::Dropped, "motion, see scan"));
        assert_eq!(read(&decisions_table(&found)).unwrap(), found);
        // Reasons that a spreadsheet would compute are stored as text and read back unchanged.
        for reason in ["=HYPERLINK(\"//x\",\"y\")", "+1", "@SUM(A1)", "'=1", "-1"] {
            let made = [Decision { id: "b".to_owned(), decision: Verdict::Kept, reason: reason.to_owned() }];
            assert_eq!(decisions_table(&made).contains('\''), reason != "-1", "{reason}");
            assert_eq!(read(&decisions_table(&made)).unwrap(), made);
        }
        assert!(read("id,decision,reason\nx,dropped,\n").unwrap_err().contains("no subject"));
        assert!(read("id,decision,reason\na,drop,\n").unwrap_err().contains("kept or dropped"));
        assert!(read("id,decision,reason\na,kept,\na,dropped,\n").unwrap_err().contains("twice"));
    }
}
