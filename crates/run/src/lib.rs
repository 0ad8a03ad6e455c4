#![doc = include_str!("../README.md")]

mod colors;
mod doubts;
pub mod intake;
mod mirror;
mod mirror_plane;
mod next;
#[cfg(test)]
mod numbering_tests;
pub mod page;
pub mod plot;
mod report;
mod scales;
mod surfaces;
#[cfg(test)]
mod surfaces_tests;
mod warped;
mod whole;

pub use colors::{Colors, value_colors};
pub use mirror_plane::MirrorPlane;
pub use next::next_step;
pub use report::{ReportInputs, write_report};
pub use surfaces::SurfaceCache;
pub use warped::{WarpError, WarpedSurface, lta, segment_label, warp};

use mirror::Mirrors;
use surfaces::ReadySurface;

use crate::intake::{IntakeError, IntakeLimits};
use homolog_contract::parameters::MatchParameters;
use homolog_contract::result::{
    Correspondences, InputProvenance, Provenance, ResultDocument, WarpDirection, WarpSpace,
};
use homolog_matching::{MatchError, match_levels};
pub use homolog_matching::{match_memory_bytes, read_caches};
use homolog_mesh::{MeshError, SurfaceMesh};
use homolog_primitives::observe::{Cancelled, Observer, Phase};
use parking_lot::Mutex;
use std::collections::BTreeMap;
use std::time::Instant;

/// One input of a match: the bytes as uploaded.
#[derive(Debug, Clone, Copy)]
pub struct InputFile<'a> {
    /// The whole file.
    pub bytes: &'a [u8],
    /// Its name, if known; used only if the bytes alone do not determine the format.
    pub name: Option<&'a str>,
}

/// One of the two inputs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Side {
    /// The surface that moves.
    Source,
    /// The surface that stays.
    Target,
}

impl Side {
    /// The name used in JSON and in forms.
    pub fn name(self) -> &'static str {
        match self {
            Side::Source => "source",
            Side::Target => "target",
        }
    }
}

/// The result of a finished run.
#[derive(Debug, Clone, PartialEq)]
pub struct RunOutput {
    /// The result document, correspondences included. The program fills in the commit of its provenance, which only the
    /// program knows.
    pub document: ResultDocument,
    /// The source surface to whose vertices the correspondences refer: all vertices of the uploaded mesh, with the
    /// matched faces; or the surface made from the uploaded volume.
    pub source: SurfaceMesh,
    /// The target surface to which the correspondences refer, in the same numbering of the upload.
    pub target: SurfaceMesh,
}

impl RunOutput {
    /// The source surface moved rigidly onto the target, by the transform of the result.
    ///
    /// # Errors
    /// [`MeshError::NonFinite`] if a coordinate overflows.
    pub fn aligned(&self) -> Result<SurfaceMesh, MeshError> {
        self.source.moved(&self.document.transform.matrix)
    }

    /// One surface deformed onto the other, in the space of the other; see [`warp`].
    ///
    /// # Errors
    /// [`WarpError`].
    pub fn warped(&self, direction: WarpDirection) -> Result<WarpedSurface, WarpError> {
        let none = Correspondences::default();
        let correspondences = self.document.correspondences.as_ref().unwrap_or(&none);
        let space = match direction {
            WarpDirection::Forward => WarpSpace::Target,
            WarpDirection::Inverse => WarpSpace::Source,
        };
        let surfaces = [&self.source, &self.target];
        warp(surfaces, correspondences, &self.document.transform.matrix, direction, space)
    }
}

/// Reasons why a run has no result.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum RunError {
    /// An input was refused.
    #[error("{}: {error}", side.name())]
    Input {
        /// The refused input.
        side: Side,
        /// The reason.
        error: IntakeError,
    },
    /// Both surfaces are suitable, but matching them would exceed the allowed memory.
    #[error(
        "matching {source_vertices} to {target_vertices} vertices would take {needed} bytes of memory, but {limit} are \
         allowed; send coarser surfaces, or set inference.coarse_vertices"
    )]
    TooLarge {
        /// Vertices of the source.
        source_vertices: usize,
        /// Vertices of the target.
        target_vertices: usize,
        /// Memory required by the match, bytes.
        needed: u64,
        /// Memory allowed, bytes.
        limit: u64,
    },
    /// The match failed or was cancelled.
    #[error(transparent)]
    Match(#[from] MatchError),
}

/// Refuses a pair whose match would exceed the memory in `limits`. `source` is its number of vertices and of faces.
///
/// # Errors
/// [`RunError::TooLarge`].
pub fn check_size(
    source: (usize, usize),
    target_vertices: usize,
    parameters: &MatchParameters,
    limits: &IntakeLimits,
) -> Result<(), RunError> {
    let (needed, limit) = (match_memory_bytes(source, target_vertices, parameters), limits.max_match_bytes);
    if needed > limit {
        return Err(RunError::TooLarge { source_vertices: source.0, target_vertices, needed, limit });
    }
    Ok(())
}

/// Content address of a file: `blake3:` and 64 hexadecimal digits.
fn content_hash(bytes: &[u8]) -> String {
    format!("blake3:{}", blake3::hash(bytes).to_hex())
}

/// Reads both inputs, matches them, and writes the result document.
///
/// # Errors
/// [`RunError`].
pub fn run_match(
    source: InputFile<'_>,
    target: InputFile<'_>,
    parameters: &MatchParameters,
    limits: &IntakeLimits,
    observer: &dyn Observer,
) -> Result<RunOutput, RunError> {
    run_match_with(&SurfaceCache::none(), source, target, parameters, limits, observer)
}

/// [`run_match`] with surfaces prepared for earlier matches taken from `surfaces`. The result is the same to the bit,
/// except for the timings.
///
/// # Errors
/// [`RunError`].
pub fn run_match_with(
    surfaces: &SurfaceCache,
    source: InputFile<'_>,
    target: InputFile<'_>,
    parameters: &MatchParameters,
    limits: &IntakeLimits,
    observer: &dyn Observer,
) -> Result<RunOutput, RunError> {
    let timed = PhaseTimer::new(observer);
    // In the pool of threads: from outside of it, every parallel loop would wait for another thread.
    let (source, target, mirrors, outcome) = rayon::scope(|_| {
        let [source, target] = surfaces.ready([source, target], parameters, limits, &timed)?;
        let mirrors = Mirrors::of(&source.prepared, &target.prepared);
        let outcome = match_levels(&source.levels, &target.levels, &mirrors.parameters(parameters), &timed)?;
        Ok::<_, RunError>((source, target, mirrors, outcome))
    })?;
    let provenance = Provenance {
        version: env!("CARGO_PKG_VERSION").to_owned(),
        // Filled in by the program, which alone knows it.
        commit: "unknown".to_owned(),
        parameters: parameters.clone(),
        seed: parameters.seed,
        source: input_provenance(&source),
        target: input_provenance(&target),
    };
    let mut document = ResultDocument {
        transform: outcome.transform,
        support: outcome.support,
        surface_distance: outcome.surface_distance,
        energy: outcome.energy,
        topology: outcome.topology,
        deformation: outcome.deformation,
        rounds: outcome.rounds,
        poses: outcome.poses,
        reliability: outcome.reliability,
        warnings: Vec::new(),
        ambiguous_axes: outcome.ambiguous_axes,
        correspondences: Some(whole::of_whole(outcome.correspondences, &source.prepared, &target.prepared)),
        stop_reason: outcome.stop_reason,
        timings_ms: timed.finish(),
        provenance,
    };
    mirrors.state(&mut document);
    document.warn(doubts::pair_warnings(&source.prepared, &target.prepared));
    let (source, target) = (source.prepared.uploaded().clone(), target.prepared.uploaded().clone());
    Ok(RunOutput { document, source, target })
}

fn input_provenance(ReadySurface { hash, prepared, .. }: &ReadySurface) -> InputProvenance {
    InputProvenance {
        hash: hash.clone(),
        n_vertices: prepared.mesh.n_vertices() as u32,
        n_faces: prepared.mesh.n_faces() as u32,
        report: prepared.report.clone(),
    }
}

/// Passes every event on to another observer and adds up the time of each phase.
struct PhaseTimer<'a> {
    observer: &'a dyn Observer,
    clock: Mutex<PhaseClock>,
}

struct PhaseClock {
    started: Instant,
    current: Option<(Phase, Instant)>,
    spent_ms: BTreeMap<String, f64>,
}

impl PhaseClock {
    fn close(&mut self, now: Instant) {
        if let Some((phase, since)) = self.current.take() {
            *self.spent_ms.entry(phase.name().to_owned()).or_default() += milliseconds(now - since);
        }
    }
}

fn milliseconds(duration: std::time::Duration) -> f64 {
    (duration.as_secs_f64() * 1e6).round() / 1e3
}

impl<'a> PhaseTimer<'a> {
    fn new(observer: &'a dyn Observer) -> Self {
        let clock = PhaseClock { started: Instant::now(), current: None, spent_ms: BTreeMap::new() };
        PhaseTimer { observer, clock: Mutex::new(clock) }
    }

    fn finish(self) -> BTreeMap<String, f64> {
        let mut clock = self.clock.into_inner();
        let now = Instant::now();
        clock.close(now);
        clock.spent_ms.insert("total".to_owned(), milliseconds(now - clock.started));
        clock.spent_ms
    }
}

impl Observer for PhaseTimer<'_> {
    fn inner(&self) -> Option<&dyn Observer> {
        Some(self.observer)
    }
    fn phase(&self, phase: Phase) {
        let now = Instant::now();
        let mut clock = self.clock.lock();
        clock.close(now);
        clock.current = Some((phase, now));
        drop(clock);
        self.observer.phase(phase);
    }
}

impl RunError {
    /// Whether the run ended because the observer cancelled it.
    pub fn is_cancelled(&self) -> bool {
        matches!(self, RunError::Match(MatchError::Cancelled(Cancelled)))
    }
}
