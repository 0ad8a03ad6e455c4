//! The folder of a study: records of matches, the template that is kept, decisions, and files that are written as a whole.
//!
//! Everything is written beside its place and renamed, so that a process that is killed leaves whole files or none.

use crate::align::Shapes;
use crate::error::StudyError;
use crate::plan::{Making, Records, Round, Template, hash};
use crate::record::{Record, read_points};
use homolog_formats::ReadLimits;
use homolog_formats::ply::read_ply;
use serde::{Deserialize, Serialize};
use std::collections::BTreeSet;
use std::fs;
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};

/// The end of the names of files that are being written.
const UNFINISHED: &str = ".study.tmp";

/// A study's folder.
#[derive(Debug)]
pub struct Folder {
    path: PathBuf,
    /// Keys of records that were read whole and are sound.
    sound: Mutex<BTreeSet<String>>,
    written: AtomicU64,
}

/// The template that is kept, beside its surface.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Kept {
    /// What was asked for when it was made; another template is made for anything else.
    pub asked: String,
    /// Hash of the template's file.
    pub hash: String,
    /// Ids of the subjects that it was made from.
    pub from: Vec<String>,
    /// Ids of the subjects among which consistency is measured.
    pub ring: Vec<String>,
    /// The rounds that made it.
    pub rounds: Vec<Round>,
}

/// What a person decided about a subject.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Decision {
    /// The subject.
    pub id: String,
    /// Whether it stays in the model and the statistics.
    pub decision: Verdict,
    /// Why.
    pub reason: String,
}

/// A decision.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Verdict {
    /// It stays, whatever its match looks like.
    Kept,
    /// It is left out.
    Dropped,
}

pub(crate) fn failed(what: &'static str, path: &Path) -> impl FnOnce(io::Error) -> StudyError {
    let path = path.to_owned();
    move |source| StudyError::File { what, path, source }
}

impl Folder {
    /// The folder, which is created if it does not exist.
    ///
    /// # Errors
    /// [`StudyError::File`] if it cannot be written.
    pub fn create(path: &Path) -> Result<Self, StudyError> {
        for part in ["matches", "template"] {
            let part = path.join(part);
            fs::create_dir_all(&part).map_err(failed("write", &part))?;
        }
        let folder = Folder { path: path.to_owned(), sound: Mutex::default(), written: AtomicU64::new(0) };
        folder.sweep()?;
        Ok(folder)
    }

    /// Removes what a killed process left unfinished.
    fn sweep(&self) -> Result<(), StudyError> {
        for part in ["", "matches", "template", "modes", "maps", "subjects", "labels"] {
            let part = self.path.join(part);
            if !part.is_dir() {
                continue;
            }
            for entry in fs::read_dir(&part).map_err(failed("read", &part))?.flatten() {
                if entry.file_name().to_string_lossy().ends_with(UNFINISHED) {
                    // One that is gone already is no fault.
                    let _ = fs::remove_file(entry.path());
                }
            }
        }
        Ok(())
    }

    /// Where it is.
    pub fn path(&self) -> &Path {
        &self.path
    }

    fn record_path(&self, key: &str) -> PathBuf {
        self.path.join("matches").join(format!("{key}.match"))
    }

    /// Writes a file of the folder as a whole, and the folders above it.
    ///
    /// # Errors
    /// [`StudyError::File`].
    pub fn write(&self, name: &str, bytes: &[u8]) -> Result<(), StudyError> {
        let path = self.path.join(name);
        let number = self.written.fetch_add(1, Ordering::Relaxed);
        let unfinished = path.with_extension(format!("{}-{number}{UNFINISHED}", std::process::id()));
        let written = (|| {
            if let Some(above) = path.parent() {
                fs::create_dir_all(above)?;
            }
            let mut file = fs::File::create(&unfinished)?;
            file.write_all(bytes)?;
            file.sync_data()?;
            fs::rename(&unfinished, &path)
        })();
        written.map_err(|error| {
            // The write has failed already; a leftover is swept later.
            let _ = fs::remove_file(&unfinished);
            failed("write", &path)(error)
        })
    }

    /// A file of the folder; `None` if there is none.
    ///
    /// # Errors
    /// [`StudyError::File`].
    pub fn read(&self, name: &str) -> Result<Option<Vec<u8>>, StudyError> {
        let path = self.path.join(name);
        match fs::read(&path) {
            Ok(bytes) => Ok(Some(bytes)),
            Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(None),
            Err(error) => Err(failed("read", &path)(error)),
        }
    }

    /// Keeps a record.
    ///
    /// # Errors
    /// [`StudyError::File`].
    pub fn keep(&self, key: &str, record: &Record) -> Result<(), StudyError> {
        self.write(&format!("matches/{key}.match"), &record.to_bytes())
    }

    /// The template that is kept, if it was made for what is asked.
    ///
    /// # Errors
    /// [`StudyError::Damaged`]; [`StudyError::File`].
    pub fn kept(&self, asked: &str) -> Result<Option<(Kept, Template)>, StudyError> {
        let Some(text) = self.read("template/kept.json")? else { return Ok(None) };
        let path = self.path.join("template");
        let damaged = |why: &str| StudyError::Damaged {
            path: path.clone(),
            why: format!("{why}; delete this folder, and the template is made again"),
        };
        let kept: Kept = serde_json::from_slice(&text).map_err(|_| damaged("kept.json is not what was written"))?;
        if kept.asked != asked {
            return Ok(None);
        }
        let ply = self.read("template/template.ply")?.ok_or_else(|| damaged("template.ply is missing"))?;
        if hash(&ply) != kept.hash {
            return Err(damaged("template.ply has changed"));
        }
        let mesh = read_ply(&ply, &ReadLimits::default()).map_err(|_| damaged("template.ply is no surface"))?.mesh;
        Ok(Some((kept.clone(), Template { mesh, hash: kept.hash, ply })))
    }

    /// Keeps a template: first the surface, then what names it.
    ///
    /// # Errors
    /// [`StudyError::File`].
    pub fn keep_template(&self, kept: &Kept, making: &Making) -> Result<(), StudyError> {
        self.write("template/template.ply", &making.template.ply)?;
        self.write("template/kept.json", &json(kept))
    }

    /// The shapes of records, read from their files in parts.
    pub(crate) fn shapes(&self, keys: Vec<(String, String)>, n_vertices: usize) -> RecordedShapes<'_> {
        RecordedShapes { folder: self, keys, n_vertices }
    }

    /// Removes the files of a folder of outputs that are not among these names.
    pub(crate) fn keep_only(&self, part: &str, names: &BTreeSet<String>) {
        for entry in fs::read_dir(self.path.join(part)).into_iter().flatten().flatten() {
            if !names.contains(&*entry.file_name().to_string_lossy()) {
                // An old output that cannot be removed does no harm.
                let _ = fs::remove_file(entry.path());
            }
        }
    }
}

/// JSON for people, with a line end.
pub(crate) fn json(value: &impl Serialize) -> Vec<u8> {
    let mut text = serde_json::to_vec_pretty(value).unwrap_or_default();
    text.push(b'\n');
    text
}

impl Records for Folder {
    fn get(&self, key: &str) -> Result<Option<Record>, StudyError> {
        let path = self.record_path(key);
        let Some(bytes) = self.read(&format!("matches/{key}.match"))? else { return Ok(None) };
        match Record::from_bytes(&bytes) {
            Ok(record) => Ok(Some(record)),
            Err(error) => Err(StudyError::Damaged { path, why: error.to_string() }),
        }
    }

    /// Whether a sound record is there. One that is damaged, as by a full disk or a torn write below the file system, is
    /// removed and computed again.
    fn has(&self, key: &str) -> bool {
        let mut sound = self.sound.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        if sound.contains(key) {
            return true;
        }
        match self.get(key) {
            Ok(Some(_)) => sound.insert(key.to_owned()),
            Ok(None) => false,
            Err(_) => {
                // What cannot be removed is replaced.
                let _ = fs::remove_file(self.record_path(key));
                false
            }
        }
    }
}

/// Shapes of records.
pub(crate) struct RecordedShapes<'a> {
    folder: &'a Folder,
    /// The key of each, and its id.
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
        let path = self.folder.record_path(&self.keys[shape].0);
        let mut bytes = vec![0; 12 * vertices.len()];
        let read = (|| {
            let mut file = fs::File::open(&path)?;
            file.seek(SeekFrom::Start(Record::POINTS_AT + 12 * vertices.start as u64))?;
            file.read_exact(&mut bytes)
        })();
        read.map_err(failed("read", &path))?;
        Ok(read_points(&bytes))
    }
    fn name(&self, shape: usize) -> String {
        self.keys[shape].1.clone()
    }
}

/// Decisions from CSV: `id`, `decision` (`kept` or `dropped`) and `reason`.
///
/// # Errors
/// What is wrong, with its line.
pub fn read_decisions(text: &[u8], ids: &BTreeSet<&str>) -> Result<Vec<Decision>, String> {
    let mut reader = csv::ReaderBuilder::new().trim(csv::Trim::All).from_reader(text);
    let mut decisions: Vec<Decision> = Vec::new();
    for row in reader.deserialize() {
        let decision: Decision = row.map_err(|error| {
            format!("the decisions are not a table of id, decision (kept or dropped) and reason: {error}")
        })?;
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

    #[test]
    fn decisions_are_about_subjects_of_the_study() {
        let ids = BTreeSet::from(["a", "b"]);
        let read = |text: &str| read_decisions(text.as_bytes(), &ids);
        let found = read("id,decision,reason\na,dropped,\"motion, see scan\"\n").unwrap();
        assert_eq!((found[0].decision, found[0].reason.as_str()), (Verdict::Dropped, "motion, see scan"));
        assert!(read("id,decision,reason\nx,dropped,\n").unwrap_err().contains("no subject"));
        assert!(read("id,decision,reason\na,drop,\n").unwrap_err().contains("kept or dropped"));
        assert!(read("id,decision,reason\na,kept,\na,dropped,\n").unwrap_err().contains("twice"));
    }
}
