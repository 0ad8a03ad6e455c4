//! Inputs and measurements shared by the benchmarks of matches and of belief propagation.

use homolog_laboratory::phantom::{PairRecipe, PhantomPair};
use homolog_mesh::SurfaceMesh;

/// Source and target of two phantoms in different poses, with edges of about `edge_mm`.
pub(crate) fn pair(edge_mm: f64) -> (SurfaceMesh, SurfaceMesh) {
    let pair = PhantomPair::new(PairRecipe {
        subject: 1,
        target_subject: 2,
        deform_share: 0.0,
        deform_seed: 0,
        pose_seed: Some(3),
        permute_seed: Some(4),
    })
    .unwrap();
    (pair.source_surface(edge_mm).unwrap().mesh, pair.target_surface(edge_mm).unwrap().0.mesh)
}

/// The result of `work`, run on a pool of `threads` threads.
pub(crate) fn with_threads<T: Send>(threads: usize, work: impl FnOnce() -> T + Send) -> T {
    rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap().install(work)
}

/// The commit of the checkout, or `unknown`.
#[allow(dead_code, reason = "not every benchmark prints it")]
pub(crate) fn commit() -> String {
    let git = std::process::Command::new("git").args(["rev-parse", "--short=12", "HEAD"]).output();
    let hash = git.ok().filter(|done| done.status.success()).and_then(|done| String::from_utf8(done.stdout).ok());
    hash.map_or_else(|| "unknown".to_owned(), |hash| hash.trim().to_owned())
}

/// Peak resident memory of this process, MiB; `None` where the system does not report it.
pub(crate) fn peak_mib() -> Option<f64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|l| l.starts_with("VmHWM:"))?;
    Some(line.split_whitespace().nth(1)?.parse::<f64>().ok()? / 1024.0)
}
