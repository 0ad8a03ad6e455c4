//! Visits of a real hippocampus by the real matcher: surfaces of one structure, thinned by a known amount and sampled anew,
//! whose changes are seen with less noise through a template of their own than through that of another person.

use crate::fixtures::real_files;
use homolog_contract::parameters::{Method, preset};
use homolog_formats::ply::write_ply;
use homolog_mesh::{ClosestPointIndex, SurfaceMesh};
use homolog_primitives::observe::Silent;
use homolog_study::align::align;
use homolog_study::cohort::Cohort;
use homolog_study::findings::find;
use homolog_study::folder::Folder;
use homolog_study::matching::StudyObserver;
use homolog_study::measures::measured;
use homolog_study::plan::{Records, Study, surface};
use homolog_study::settings::{Analysis, Correspondence, Measure, Rivals, Settings, Size, TemplateChoice, Visits};
use nalgebra::{Point3, Rotation3, Vector3};

/// Thinning from each visit to the next in the middle of the patch, and width of the patch, mm.
const THINNING_MM: f64 = 0.4;
const WIDTH_MM: f64 = 4.0;

struct Quiet;
impl StudyObserver for Quiet {}

/// The surface with vertices elsewhere on it: each moved along a smooth field of a third of an edge, which `seed` names.
fn sampled_anew(mesh: &SurfaceMesh, seed: f64) -> SurfaceMesh {
    let (index, length) = (ClosestPointIndex::new(mesh), 0.33 * mesh.mean_edge_length());
    let at = |p: &Point3<f64>| {
        let d = Vector3::new((1.9 * p.y + seed).sin(), (2.3 * p.z - 2.0 * seed).sin(), (2.1 * p.x + 3.0 * seed).cos());
        index.closest(&(p + length * d)).point
    };
    mesh.with_vertices(mesh.vertices().iter().map(at).collect()).unwrap()
}

#[test]
#[ignore = "needs real data (hippocampus)"]
fn changes_of_a_hippocampus_have_less_noise_through_its_own_template() {
    let files = real_files("hippocampus");
    let read = |k: usize| {
        let bytes = std::fs::read(&files[k]).unwrap();
        surface(&bytes, files[k].file_name().unwrap().to_str(), &preset(Method::Balanced).input.of_target())
            .unwrap()
            .mesh
    };
    let (template, first) = (read(1), read(0));
    let place = tempfile::tempdir().unwrap();
    std::fs::write(place.path().join("template.ply"), write_ply(&template)).unwrap();
    // The patch is in the middle of the body: the vertex nearest to a quarter beside the center.
    let center = first.vertices().iter().map(|p| p.coords).sum::<Vector3<f64>>() / first.n_vertices() as f64;
    let index = ClosestPointIndex::new(&first);
    let patch = index.closest(&Point3::from(center + Vector3::new(20.0, 0.0, 0.0))).point;
    let height = |p: &Point3<f64>| (-(p - patch).norm_squared() / (2.0 * WIDTH_MM * WIDTH_MM)).exp();
    let (mut table, normals) = ("id,file,subject\n".to_owned(), first.vertex_normals());
    for visit in 0..3 {
        let of = f64::from(visit);
        let thinner =
            first.vertices().iter().zip(&normals).map(|(p, n)| p - of * THINNING_MM * height(p) * n).collect();
        let mesh = sampled_anew(&first.with_vertices(thinner).unwrap(), 1.0 + of);
        let pose = Rotation3::from_euler_angles(0.1 * of, -0.2 * of, 0.05 * of);
        let moved = mesh.with_vertices(mesh.vertices().iter().map(|p| pose * p + Vector3::repeat(3.0 * of)).collect());
        std::fs::write(place.path().join(format!("v{visit}.ply")), write_ply(&moved.unwrap())).unwrap();
        table.push_str(&format!("v{visit},v{visit}.ply,p\n"));
    }
    // RMS over vertices without change of the change from the first to the last visit, and the mean change in the patch over
    // what was put there.
    let of = |visits: Visits| -> [f64; 3] {
        let settings = Settings {
            template: TemplateChoice::Given { file: place.path().join("template.ply") },
            template_side: None,
            size: Size::Kept,
            correspondence: Correspondence::Pairs,
            visits,
            rivals: Rivals::default(),
            analysis: Analysis::default(),
            cycle_subjects: 0,
            cycle_ring: Vec::new(),
            parameters: preset(Method::Balanced),
        };
        let folder = Folder::create(&place.path().join(visits.name())).unwrap();
        let cohort = Cohort::from_csv(table.as_bytes(), place.path()).unwrap();
        let mut study = Study::open(cohort, settings, &[], &folder, &Quiet).unwrap();
        let matched = study.match_all(&folder, 2, &Quiet).unwrap();
        let found = find(&study, &matched, &folder, &[], &Quiet).unwrap();
        assert_eq!(found.members.len(), 3, "{:?}", found.subjects);
        let shape = |k: usize| -> Vec<Point3<f64>> {
            let points = folder.get(&found.matched.keys[k]).unwrap().unwrap().points;
            points.iter().map(|p| Point3::from(p.map(f64::from))).collect()
        };
        let value = |k: usize| {
            let moved = shape(k).iter().map(|p| found.alignment.onto_mean[k].apply(p)).collect();
            let own = found.mean.with_vertices(moved).unwrap();
            measured(Measure::NormalDisplacement, &found.mean, &own, &Silent).unwrap().unwrap()
        };
        let (before, after, of_first) = (value(0), value(2), shape(0));
        let change = |v: usize| after[v] - before[v];
        // What exact maps of the later visits would show: the points of the first map, moved as its surface is.
        let exact = |visit: f64| -> Vec<[f32; 3]> {
            let moved = |p: &Point3<f64>| {
                let (near, normals) = (index.closest(p), &normals);
                let thinned = |k: usize| {
                    let q = first.vertices()[k];
                    (q - visit * THINNING_MM * height(&q) * normals[k]).coords
                };
                let to = p.coords + near.blend(thinned) - near.point.coords;
                [to.x, to.y, to.z].map(|x| x as f32)
            };
            of_first.iter().map(moved).collect()
        };
        let exact: Vec<_> = [0.0, 1.0, 2.0].map(exact).to_vec();
        let frame = align(&exact, &template, Size::Kept).unwrap();
        let mean_of_exact = template.with_vertices(frame.mean.clone()).unwrap();
        let value = |k: usize| {
            let moved = exact[k].iter().map(|p| frame.onto_mean[k].apply(&Point3::from(p.map(f64::from)))).collect();
            let own = mean_of_exact.with_vertices(moved).unwrap();
            measured(Measure::NormalDisplacement, &mean_of_exact, &own, &Silent).unwrap().unwrap()
        };
        let (exact_before, exact_after) = (value(0), value(2));
        let mean = |of: Vec<f64>| of.iter().sum::<f64>() / of.len() as f64;
        let (mut still, mut thinned, mut exactly) = (Vec::new(), Vec::new(), Vec::new());
        for (v, p) in of_first.iter().enumerate() {
            match height(p) {
                h if h < 0.005 => still.push(change(v).powi(2)),
                h if h > 0.5 => {
                    thinned.push(change(v) / (-2.0 * THINNING_MM * h));
                    exactly.push((exact_after[v] - exact_before[v]) / (-2.0 * THINNING_MM * h));
                }
                _ => {}
            }
        }
        assert!(still.len() > 100 && thinned.len() > 10, "{} {}", still.len(), thinned.len());
        [mean(still).sqrt(), mean(thinned), mean(exactly)]
    };
    let (own, plain) = (of(Visits::OwnTemplate), of(Visits::GroupTemplate));
    println!("change without change, RMS in mm: {:.4} with and {:.4} without own template", own[0], plain[0]);
    println!(
        "share of the thinning: {:.3} with and {:.3} without own template; by exact maps from the same points {:.3} and {:.3}",
        own[1], plain[1], own[2], plain[2]
    );
    assert!(own[0] < 0.8 * plain[0], "{own:?} {plain:?}");
    // The alignment of the shapes as a whole takes a part of the thinning, of exact maps too.
    assert!((own[1] - own[2]).abs() < 0.12, "{own:?}");
}
