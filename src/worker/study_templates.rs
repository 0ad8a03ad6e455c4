//! The templates of several structures, in the one blob that a study keeps of its template.
//!
//! Their files are in subfolders of `template`; the blob of `template/kept.json` then holds all of them.

use crate::jobs::study::blob;
use base64::Engine as _;
use base64::engine::general_purpose::STANDARD as BASE64;
use homolog_study::StudyError;
use homolog_study::folder::Folder;
use serde::{Deserialize, Serialize};
use std::collections::{BTreeMap, BTreeSet};

/// The names of the files of a template.
const FILES: [&str; 2] = ["template.ply", "kept.json"];

/// Files of templates.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Packed {
    /// By name in the folder of the study; the content in base64.
    files_of_structures: BTreeMap<String, String>,
}

/// The kept templates of these structures as one blob; `None` if there are none yet.
///
/// # Errors
/// Those of the folder.
pub(super) fn packed(folder: &Folder, structures: &BTreeSet<&str>) -> Result<Option<Vec<u8>>, StudyError> {
    let mut files = BTreeMap::new();
    for structure in structures {
        for file in FILES {
            let name = format!("template/{structure}/{file}");
            if let Some(bytes) = folder.read(&name)? {
                files.insert(name, BASE64.encode(bytes));
            }
        }
    }
    if files.is_empty() {
        return Ok(None);
    }
    let bytes = serde_json::to_vec(&Packed { files_of_structures: files });
    bytes.map(Some).map_err(|error| StudyError::Internal(format!("templates cannot be written: {error}")))
}

/// Puts the templates of several structures in their places. The files of a study of one structure stay as they are.
pub(super) fn unpack(files: &mut BTreeMap<String, Vec<u8>>) {
    let read = |bytes: &Vec<u8>| serde_json::from_slice::<Packed>(bytes).ok();
    let Some(packed) = files.get(blob::KEPT).and_then(read) else { return };
    // The template beside it is that of the last matches.
    files.remove(blob::KEPT);
    files.remove(blob::TEMPLATE);
    for (name, text) in packed.files_of_structures {
        // What cannot be read is made again.
        files.extend(BASE64.decode(text).ok().map(|bytes| (name, bytes)));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use homolog_study::storage::Inputs;
    use std::io;
    use std::path::Path;

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
    fn templates_of_structures_are_what_they_were_and_that_of_one_structure_is_untouched() {
        let file = |name: &str, bytes: &[u8]| (name.to_owned(), bytes.to_vec());
        let own = BTreeMap::from([
            file("template/a/kept.json", b"{}"),
            file("template/a/template.ply", &[0, 255, 10]),
            file("template/b/kept.json", b"{\"ring\":[]}"),
        ]);
        let folder = Folder::in_memory(own.clone(), Box::new(Nothing));
        let blob = packed(&folder, &BTreeSet::from(["a", "b", "c"])).unwrap().unwrap();
        let mut files = BTreeMap::from([(blob::KEPT.to_owned(), blob), file(blob::TEMPLATE, b"of b")]);
        unpack(&mut files);
        assert_eq!(files, own);
        assert!(packed(&folder, &BTreeSet::from(["c"])).unwrap().is_none());
        let mut one = BTreeMap::from([file(blob::KEPT, b"{\"asked\":\"x\"}"), file(blob::TEMPLATE, b"ply")]);
        let before = one.clone();
        unpack(&mut one);
        assert_eq!(one, before);
    }
}
