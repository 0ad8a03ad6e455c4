//! The group: surfaces as files, their matches with one template in one folder, and studies over parts of them.

use crate::planted::Plant;
use homolog_contract::parameters::{MatchParameters, Method, resolve};
use homolog_formats::ply::write_ply;
use homolog_mesh::SurfaceMesh;
use homolog_run::intake::{IntakeLimits, prepare_surface};
use homolog_study::cohort::Cohort;
use homolog_study::findings::{Findings, find};
use homolog_study::folder::{Folder, record_name};
use homolog_study::matching::StudyObserver;
use homolog_study::plan::{Matched, Records, Step, Study};
use homolog_study::record::Record;
use homolog_study::settings::{
    Analysis, Correspondence, MadeTemplate, Measure, Rivals, Settings, Size, TemplateChoice, Visits,
};
use homolog_study::storage::Inputs;
use nalgebra::Point3;
use rand_core::Rng;
use rand_xoshiro::Xoshiro256PlusPlus;
use rand_xoshiro::rand_core::SeedableRng;
use std::collections::BTreeMap;
use std::error::Error;
use std::io;
use std::path::{Path, PathBuf};

pub(crate) struct Quiet;
impl StudyObserver for Quiet {}

/// Origin of the maps of a study.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Maps {
    /// Those of the subjects as they were, moved by the deformation.
    Oracle,
    /// Those of the deformed surfaces.
    Matched(Correspondence),
    /// Those of the deformed surfaces by another method, onto the same template.
    Other(Method),
}

impl Maps {
    pub(crate) fn name(self) -> &'static str {
        match self {
            Maps::Oracle => "oracle",
            Maps::Matched(how) => how.name(),
            Maps::Other(method) => method.name(),
        }
    }
}

/// The group and its folder.
pub(crate) struct Bench {
    out: PathBuf,
    ids: Vec<String>,
    meshes: Vec<SurfaceMesh>,
    parameters: MatchParameters,
    permutations: usize,
}

/// Files on the disk, for a folder in memory.
#[derive(Debug)]
struct Disk;

impl Inputs for Disk {
    fn read(&self, file: &Path) -> io::Result<Vec<u8>> {
        std::fs::read(file)
    }
    fn hash(&self, file: &Path) -> io::Result<String> {
        Ok(homolog_study::plan::hash(&std::fs::read(file)?))
    }
}

impl Bench {
    /// The surfaces of `n` label volumes, spread over those in `data`.
    pub(crate) fn open(data: &Path, out: &Path, n: usize, permutations: usize) -> Result<Self, Box<dyn Error>> {
        std::fs::create_dir_all(out.join("surfaces"))?;
        let out = std::path::absolute(out)?;
        let parameters = resolve(&serde_json::json!({})).map_err(|faults| format!("{faults:?}"))?;
        let entries = std::fs::read_dir(data.join("hippocampus"))?.collect::<Result<Vec<_>, _>>()?;
        let mut files: Vec<PathBuf> = entries.into_iter().map(|entry| entry.path()).collect();
        files.sort();
        let n = n.min(files.len());
        let chosen = (0..n).map(|k| &files[k * files.len() / n]);
        let (mut ids, mut meshes) = (Vec::new(), Vec::new());
        for file in chosen {
            let name = file.file_name().and_then(|name| name.to_str()).unwrap_or_default();
            let read = prepare_surface(&std::fs::read(file)?, Some(name), &parameters.input, &IntakeLimits::default());
            let mesh = read.map_err(|error| error.for_command_line())?.uploaded().clone();
            let id = name.split('.').next().unwrap_or_default().to_owned();
            write_if_new(&out.join("surfaces").join(format!("{id}.ply")), &mesh)?;
            ids.push(id);
            meshes.push(mesh);
        }
        Ok(Bench { out, ids, meshes, parameters, permutations })
    }

    pub(crate) fn n_vertices(&self) -> Result<usize, Box<dyn Error>> {
        let (_, matched, _) = self.matched(&self.original(&self.chosen(self.ids.len(), 0)), Correspondence::Pairs)?;
        Ok(matched.making.template.mesh.n_vertices())
    }

    /// `n` subjects, spread over the group in pairs of which the first is deformed. Draw 0 keeps the order of the files; in all
    /// others a fair coin decides in each pair which comes first.
    pub(crate) fn chosen(&self, n: usize, draw: u64) -> Vec<usize> {
        let all = self.ids.len() / 2;
        let pairs = (n / 2).min(all);
        let mut random = Xoshiro256PlusPlus::seed_from_u64(draw);
        let mut is_swapped = || draw > 0 && random.next_u64() >> 63 == 1;
        let ordered = (0..pairs).map(|k| 2 * (k * all / pairs.max(1)));
        ordered.flat_map(|k| if is_swapped() { [k + 1, k] } else { [k, k + 1] }).collect()
    }

    /// Files of these subjects as they are.
    pub(crate) fn original(&self, of: &[usize]) -> Vec<PathBuf> {
        of.iter().map(|&k| self.out.join("surfaces").join(format!("{}.ply", self.ids[k]))).collect()
    }

    /// Files of these subjects, every first of a pair deformed.
    fn deformed(&self, plant: &Plant, of: &[usize]) -> io::Result<Vec<PathBuf>> {
        let folder = self.out.join(format!("deformed-{}-{}-{}", plant.radius_mm, plant.height_mm, plant.share));
        std::fs::create_dir_all(&folder)?;
        let mut files = self.original(of);
        for (file, &k) in files.iter_mut().zip(of).step_by(2) {
            *file = folder.join(format!("{}.ply", self.ids[k]));
            let moved = self.meshes[k].with_vertices(plant.planted(&self.meshes[k]));
            write_if_new(file, &moved.map_err(io::Error::other)?)?;
        }
        Ok(files)
    }

    fn cohort(&self, files: &[PathBuf]) -> Result<Cohort, Box<dyn Error>> {
        let mut table = "id,file,group\n".to_owned();
        for (k, file) in files.iter().enumerate() {
            let id = file.file_stem().and_then(|stem| stem.to_str()).unwrap_or_default();
            table.push_str(&format!("{id},{},{}\n", file.display(), ["patient", "control"][k % 2]));
        }
        Ok(Cohort::from_csv(table.as_bytes(), Path::new(""))?)
    }

    fn settings(&self, correspondence: Correspondence) -> Settings {
        Settings {
            template: TemplateChoice::Made(MadeTemplate::default()),
            template_side: None,
            size: Size::Kept,
            correspondence,
            visits: Visits::default(),
            rivals: Rivals::default(),
            analysis: Analysis {
                effect: Some("group".to_owned()),
                reference: vec![("group".to_owned(), "control".to_owned())],
                measures: vec![Measure::NormalDisplacement],
                permutations: self.permutations,
                ..Analysis::default()
            },
            cycle_subjects: 0,
            cycle_ring: Vec::new(),
            parameters: self.parameters.clone(),
        }
    }

    /// The study of these files in the folder of the group, whose template it takes once there is one.
    pub(crate) fn matched(
        &self,
        files: &[PathBuf],
        how: Correspondence,
    ) -> Result<(Study, Matched, Folder), Box<dyn Error>> {
        let folder = Folder::create(&self.out)?;
        let mut study = Study::open(self.cohort(files)?, self.settings(how), &[], &folder, &Quiet)?;
        let matched = study.match_all(&folder, rayon::current_num_threads(), &Quiet)?;
        Ok((study, matched, folder))
    }

    /// What a study of `n` subjects finds of a deformation, in one draw of those that are deformed.
    pub(crate) fn found(&self, plant: &Plant, (n, draw): (usize, u64), maps: Maps) -> Result<Findings, Box<dyn Error>> {
        let chosen = self.chosen(n, draw);
        let files = self.deformed(plant, &chosen)?;
        match maps {
            Maps::Matched(how) => {
                let (study, matched, folder) = self.matched(&files, how)?;
                Ok(find(&study, &matched, &folder, &[], &Quiet)?)
            }
            Maps::Oracle => self.oracle(plant, &chosen, &files),
            Maps::Other(method) => self.by_other_method(method, &files),
        }
    }

    /// What a study of these files finds with the maps of another method, in a folder of its own.
    fn by_other_method(&self, method: Method, files: &[PathBuf]) -> Result<Findings, Box<dyn Error>> {
        let parameters = resolve(&serde_json::json!({"method": method.name()}));
        let settings = Settings {
            template: TemplateChoice::Given { file: self.out.join("template/template.ply") },
            parameters: parameters.map_err(|faults| format!("{faults:?}"))?,
            ..self.settings(Correspondence::Pairs)
        };
        let folder = Folder::create(&self.out.join(method.name()))?;
        let mut study = Study::open(self.cohort(files)?, settings, &[], &folder, &Quiet)?;
        let matched = study.match_all(&folder, rayon::current_num_threads(), &Quiet)?;
        Ok(find(&study, &matched, &folder, &[], &Quiet)?)
    }

    fn oracle(&self, plant: &Plant, chosen: &[usize], files: &[PathBuf]) -> Result<Findings, Box<dyn Error>> {
        let (_, known, records) = self.matched(&self.original(chosen), Correspondence::Pairs)?;
        let mut made = BTreeMap::new();
        for name in ["template/kept.json", "template/template.ply"] {
            made.insert(name.to_owned(), records.read(name)?.ok_or("there is no template")?);
        }
        let open = |made: &BTreeMap<String, Vec<u8>>| -> Result<(Study, Folder), Box<dyn Error>> {
            let folder = Folder::in_memory(made.clone(), Box::new(Disk));
            let settings = self.settings(Correspondence::Pairs);
            Ok((Study::open(self.cohort(files)?, settings, &[], &folder, &Quiet)?, folder))
        };
        let (mut study, folder) = open(&made)?;
        if let Step::Match { tasks, .. } = study.advance(&folder, &Quiet)? {
            for task in tasks {
                let row = task.target.ok_or("a match without a subject")?;
                let Record { facts, points } = records.get(&known.keys[row])?.ok_or("a match is missing")?;
                let mut map: Vec<Point3<f64>> = points.iter().map(|p| Point3::from(p.map(f64::from))).collect();
                if row.is_multiple_of(2) {
                    map = plant.carried(&self.meshes[chosen[row]], &map);
                }
                let points = map.iter().map(|p| <[f64; 3]>::from(p.coords).map(|x| x as f32)).collect();
                made.insert(record_name(&task.key), Record { facts, points }.to_bytes());
            }
        }
        let (mut study, folder) = open(&made)?;
        let Step::Matched(matched) = study.advance(&folder, &Quiet)? else { return Err("a match is missing".into()) };
        Ok(find(&study, &matched, &folder, &[], &Quiet)?)
    }
}

fn write_if_new(path: &Path, mesh: &SurfaceMesh) -> io::Result<()> {
    if path.exists() { Ok(()) } else { std::fs::write(path, write_ply(mesh)) }
}
