//! Subjects of a study that use labels of one volume, through the command and the service.

use super::cli::homolog;
use super::faults::site::{Backend, Site};
use super::study_service::{Service, same};
use serde_json::{Value, json};
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// Two structures side by side in one volume, with labels 17 and 53; returns the voxels of each.
pub(super) fn joined(structures: [PathBuf; 2], to: &Path) -> [usize; 2] {
    use homolog_mesh::volume::LabelVolume;
    let volumes = structures.map(|file| {
        let read = homolog_formats::read(&fs::read(file).unwrap(), None, &homolog_formats::ReadLimits::default());
        let homolog_formats::FileContent::Labels(volume) = read.unwrap().content else { panic!("no volume") };
        volume
    });
    let [a, b] = volumes.each_ref().map(LabelVolume::dims);
    let dims = [a[0] + b[0], a[1].max(b[1]), a[2].max(b[2])];
    let mut labels = vec![0; dims.iter().product()];
    let mut counts = [0; 2];
    for (k, (volume, first)) in volumes.iter().zip([0, a[0]]).enumerate() {
        let own = volume.dims();
        for (at, _) in volume.labels().iter().enumerate().filter(|(_, label)| **label > 0) {
            let [x, y, z] = [at % own[0], at / own[0] % own[1], at / (own[0] * own[1])];
            labels[first + x + dims[0] * (y + dims[1] * z)] = [17, 53][k];
            counts[k] += 1;
        }
    }
    let volume = LabelVolume::new(dims, labels, *volumes[0].affine()).unwrap();
    fs::write(to, homolog_formats::write_nifti_gz(&volume)).unwrap();
    counts
}

/// A subject names the labels of its volume that it uses, by number or name; several subjects share a volume.
#[test]
fn subjects_use_labels_of_one_volume_as_by_the_command() {
    let place = tempfile::tempdir().unwrap();
    let volume = |k: usize| place.path().join(format!("v{k}.nii.gz"));
    let voxels: Vec<usize> = (0..2)
        .flat_map(|file| {
            let structures = [2 * file, 2 * file + 1].map(|k| {
                let out = place.path().join(format!("p{k}"));
                let made = ["phantom", "--spacing", "2", "--subject"];
                let done = homolog().args(made).arg((k + 1).to_string()).arg("--out").arg(&out).output().unwrap();
                assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
                out.join("source.nii.gz")
            });
            joined(structures, &volume(file))
        })
        .collect();
    let labels = ["17", "freesurfer:Right-Hippocampus"];
    let table = |labels: [&str; 2]| {
        let rows = (0..4).map(|k| format!("s{k},v{}.nii.gz,{},{}\n", k / 2, labels[k % 2], ["a", "b"][k % 2]));
        let path = place.path().join("labels.csv");
        fs::write(&path, format!("id,file,label,group\n{}", rows.collect::<String>())).unwrap();
        path
    };
    let out = place.path().join("out");
    let options = ["--effect", "group", "--permutations", "6", "--template-rounds", "1", "--start", "s1"];
    let run = |labels: [&str; 2], out: &Path| {
        let done = homolog().arg("study").arg(table(labels)).args(options).arg("--out").arg(out).output().unwrap();
        assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    };
    run(labels, &out);
    // Each subject has the volume of its own structure (voxels of 2 mm), and the table says of which labels.
    let text = fs::read_to_string(out.join("subjects.csv")).unwrap();
    let mut rows = text.lines().map(|row| row.split(',').collect::<Vec<_>>());
    let header = rows.next().unwrap();
    let column = |name: &str| header.iter().position(|column| *column == name).unwrap();
    for (k, row) in rows.enumerate() {
        let mm3: f64 = row[column("volume_mm3")].parse().unwrap();
        let expected = 8.0 * voxels[k] as f64;
        assert!((mm3 / expected - 1.0).abs() < 0.03, "{k}: {mm3} of {expected}");
        assert_eq!((row[column("label")], row[column("place")]), (labels[k % 2], "model"));
    }

    let site = Site::open(Backend::Sqlite);
    let service = Service::start(&site, &[]);
    let meshes = [0, 1].map(|k| service.upload(&volume(k)));
    let subject = |k: usize, labels: Value| {
        let group = ["a", "b"][k % 2];
        json!({"id": format!("s{k}"), "input": {"mesh_id": meshes[k / 2]}, "labels": labels, "covariates": {"group": group}})
    };
    let asked = |labels: [Value; 2]| {
        let subjects: Vec<Value> = (0..4).map(|k| subject(k, labels[k % 2].clone())).collect();
        json!({"subjects": subjects, "effect": "group", "permutations": 6, "template_rounds": 1, "start": "s1"})
    };
    for (wrong, pointer) in [
        (json!(99), "/subjects/1/input"),
        (json!(0), "/subjects/1/labels"),
        (json!([]), "/subjects/1/labels"),
        (json!({}), "/subjects/1/labels"),
        (json!(1.5), "/subjects/1/labels"),
    ] {
        let answer = service.post("/v1/studies", &asked([json!(17), wrong.clone()]));
        let status = answer.status();
        let said: Value = answer.json().unwrap();
        assert_eq!((status.as_u16(), &said["errors"][0]["pointer"]), (422, &json!(pointer)), "{wrong}: {said}");
    }
    let taken = json!({"id": "s4", "input": {"mesh_id": meshes[0]}, "covariates": {"group": "a", "label": 17}});
    let mut with_covariate = asked([json!(17), json!(53)]);
    with_covariate["subjects"].as_array_mut().unwrap().push(taken);
    let said: Value = service.post("/v1/studies", &with_covariate).json().unwrap();
    assert_eq!(said["errors"][0]["pointer"], "/subjects/4/covariates", "{said}");

    let study: Value = service.post("/v1/studies", &asked([json!([17]), json!(labels[1])])).json().unwrap();
    let path = format!("/v1/studies/{}", study["id"].as_str().unwrap_or_else(|| panic!("{study}")));
    service.finished(&path);
    same(&service.archive(&path), &out);
    let shown = service.get(&path)["subjects"].clone();
    assert_eq!((&shown[0]["labels"], &shown[1]["labels"]), (&json!([17]), &json!([labels[1]])));
    // The matches state their labels, as jobs do.
    let jobs = service.get(&format!("/v1/jobs?study={}&fields=id", study["id"].as_str().unwrap()));
    let of = |job: &Value| {
        let job = service.get(&format!("/v1/jobs/{}?fields=parameters", job["id"].as_str().unwrap()));
        job["parameters"]["input"]["target"]["labels"].to_string()
    };
    let used: BTreeSet<String> = jobs["jobs"].as_array().unwrap().iter().map(of).collect();
    assert_eq!(used, BTreeSet::from(["[17]".to_owned(), format!("[\"{}\"]", labels[1])]));

    // Other labels of the subjects that it was made from are another template.
    let kept = || fs::read_to_string(out.join("template/kept.json")).unwrap();
    let before = kept();
    run(["53", "17"], &out);
    assert!(kept() != before && kept().contains("\"s1\": [\n      17"), "{}", kept());
}
