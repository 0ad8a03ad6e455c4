//! A group of solids with the symmetries of an ellipsoid but for faint bumps: some matches are sure of their pose, others leave it
//! open, and the group decides these. Matched, not made up.

use crate::solids::{directions, motion, solid, surface};
use homolog_contract::parameters::{Method, preset};
use homolog_formats::ply::write_ply;
use homolog_study::cohort::Cohort;
use homolog_study::findings::find;
use homolog_study::folder::Folder;
use homolog_study::matching::StudyObserver;
use homolog_study::plan::{Records, Study};
use homolog_study::settings::{Analysis, Correspondence, Rivals, Settings, Size, TemplateChoice, Visits};
use homolog_study::storage::Inputs;
use homolog_study::subjects::SubjectOutcome;
use nalgebra::{Matrix3, Point3, Vector3};
use std::collections::BTreeMap;
use std::io;
use std::path::Path;

const SUBJECTS: usize = 32;

struct Quiet;
impl StudyObserver for Quiet {}

#[derive(Debug)]
struct Files;

impl Inputs for Files {
    fn read(&self, file: &Path) -> io::Result<Vec<u8>> {
        let name = file.file_stem().and_then(|name| name.to_str()).unwrap();
        Ok(write_ply(&surface(name.trim_start_matches('s').parse().unwrap())))
    }
    fn hash(&self, file: &Path) -> io::Result<String> {
        Ok(blake3::hash(&self.read(file)?).to_hex().to_string())
    }
}

/// Mean distance of a map of the template from the true one of subject `k` after a half turn of the template.
fn error(k: u64, map: &[[f32; 3]], signs: [f64; 3]) -> f64 {
    let at = |n: &Vector3<f64>| motion(k) * solid(k, &Vector3::new(signs[0] * n.x, signs[1] * n.y, signs[2] * n.z));
    let apart =
        directions(0).iter().zip(map).map(|(n, p)| (at(n) - Point3::from(p.map(f64::from))).norm()).sum::<f64>();
    apart / map.len() as f64
}

/// The half turn whose map is nearest; 0 for the right pose.
fn pose(k: u64, map: &[[f32; 3]]) -> usize {
    let turns = [[1.0, 1.0, 1.0], [1.0, -1.0, -1.0], [-1.0, 1.0, -1.0], [-1.0, -1.0, 1.0]];
    let errors = turns.map(|signs| error(k, map, signs));
    (0..4).fold(0, |best, of| if errors[of] < errors[best] { of } else { best })
}

#[test]
fn the_group_decides_between_poses() {
    let text: String = (1..=SUBJECTS).map(|k| format!("s{k},s{k}.ply\n")).collect();
    let settings = Settings {
        template: TemplateChoice::Given { file: "s0.ply".into() },
        template_side: None,
        size: Size::Kept,
        correspondence: Correspondence::Pairs,
        visits: Visits::default(),
        rivals: Rivals::Decide,
        analysis: Analysis::default(),
        cycle_subjects: 0,
        cycle_ring: Vec::new(),
        parameters: preset(Method::Balanced),
    };
    let folder = Folder::in_memory(BTreeMap::new(), Box::new(Files));
    let cohort = Cohort::from_csv(format!("id,file\n{text}").as_bytes(), Path::new("")).unwrap();
    let mut study = Study::open(cohort, settings, &[], &folder, &Quiet).unwrap();
    let matched = study.match_all(&folder, 2, &Quiet).unwrap();
    let found = find(&study, &matched, &folder, &[], &Quiet).unwrap();
    let map = |key: &String| folder.get(key).unwrap().unwrap();
    let [mut open, mut decided, mut changed] = [0; 3];
    for (row, subject) in found.subjects.iter().enumerate() {
        let k = row as u64 + 1;
        let before = pose(k, &map(&matched.keys[row]).points);
        let after = pose(k, &map(&found.matched.keys[row]).points);
        println!("s{k}: pose {before}, then {after}: {:?} {:?}", subject.place, subject.group);
        let Some(on) = subject.group else {
            assert!(before == 0 && subject.place == SubjectOutcome::Model, "a reliable match has the right pose");
            continue;
        };
        // The poses that matches of others have shown complete those of each.
        let rivals = matched.rivals.iter().find(|of| of.subject == row).unwrap();
        let turned = |(key, rotation): (&String, &[[f64; 3]; 3])| {
            let turn = Matrix3::from_fn(|r, c| rotation[r][c]);
            let back = |p: &[f32; 3]| <[f64; 3]>::from(turn * Vector3::from(p.map(f64::from))).map(|x| x as f32);
            pose(k, &map(key).points.iter().map(back).collect::<Vec<_>>())
        };
        let mut poses: Vec<usize> = rivals.keys.iter().zip(&rivals.rotations).map(turned).chain([before]).collect();
        poses.sort_unstable();
        assert_eq!(poses, [0, 1, 2, 3], "s{k}");
        open += 1;
        if on.decided {
            assert!(after == 0 && subject.place == SubjectOutcome::Model, "s{k}: {on:?}");
            decided += 1;
            changed += usize::from(before != 0);
        } else {
            assert!(before == after && subject.place == SubjectOutcome::Unreliable, "s{k}: {on:?}");
        }
    }
    println!("{open} open, {decided} decided, {changed} of these against their own match");
    assert!(open >= 8 && decided >= 6 && changed >= 2, "{open} {decided} {changed}");
}
