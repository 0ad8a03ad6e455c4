//! Surfaces as matches take them, each prepared once: kept by the hash of the bytes that it is made of.
//!
//! A study matches one template to a thousand subjects. What is made of the template alone (read, repaired, judged,
//! renumbered, its coarse levels, its trees of closest points) is the same in each of these matches. What depends on both
//! surfaces, as features do through the radius that both share, is made in each match anew.
//!
//! **Who sees what.** The key holds the hash of the whole file, taken here of bytes that the caller has. Who may not read a
//! file has no bytes to ask with: that is decided before, where the tenant's blobs are read. Two tenants with the same
//! bytes share what is made of them, which either would have made alone; all that one learns, by the time it takes, is
//! that a file of its own was matched here lately.
//!
//! **Waiting.** Matches that need the same surface at the same time prepare it once. A match claims its two keys in
//! ascending order and prepares when it has both, so that no two matches wait for each other. It claims before its threads
//! share any work, so that none of them, helping out, comes to wait for what itself prepares.

use super::{InputFile, RunError, Side, check_size, content_hash};
use crate::intake::{IntakeError, IntakeLimits, PreparedSurface, prepare_surface};
use homolog_contract::parameters::{InputParameters, MatchParameters};
use homolog_matching::Levels;
use homolog_mesh::SurfaceMesh;
use homolog_primitives::observe::{Observer, Phase};
use quick_cache::sync::{Cache, DefaultLifecycle, GuardResult, PlaceholderGuard};
use quick_cache::{OptionsBuilder, Weighter};
use std::cmp::Ordering;
use std::hash::RandomState;
use std::sync::Arc;
use std::time::Duration;

/// How long a match waits for another that prepares the surface it needs, and then prepares it itself. That takes seconds
/// at most, so the other was stopped or is starved.
const PATIENCE: Duration = Duration::from_secs(30);
/// Share of the bytes that surfaces in use may take; the rest is for newcomers, which leave first if nobody asks again.
/// A surface beyond this share is not kept.
const SHARE_IN_USE: f64 = 0.75;
/// Bytes of a surface of some 1,000 vertices: from them follows how many keys are remembered after their surfaces left.
const TYPICAL_BYTES: u64 = 1 << 20;

/// A surface that is ready to be matched with any other.
pub struct ReadySurface {
    /// Content address of the file that it is made of.
    pub hash: String,
    /// As it came.
    pub prepared: PreparedSurface,
    /// On its levels.
    pub levels: Levels,
}

impl ReadySurface {
    fn heap_bytes(&self) -> u64 {
        let uploaded = self.prepared.uploaded.as_ref();
        let uploaded = uploaded.map_or(0, |u| size_of_val(u.vertex.as_slice()) + u.surface.heap_bytes());
        (self.prepared.mesh.heap_bytes() + uploaded + self.levels.heap_bytes()) as u64
    }
}

/// All that a ready surface depends on, as a text.
#[derive(Debug, Clone, PartialEq, Eq, Hash, PartialOrd, Ord)]
struct Key(String);

/// A surface weighs from the beginning what it takes once all is made that matches make of it: weights never change.
#[derive(Debug, Clone)]
struct ByBytes;

impl Weighter<Key, Arc<ReadySurface>> for ByBytes {
    fn weight(&self, key: &Key, surface: &Arc<ReadySurface>) -> u64 {
        surface.heap_bytes() + key.0.len() as u64
    }
}

type Kept = Cache<Key, Arc<ReadySurface>, ByBytes, RandomState>;
type Guard<'a> =
    PlaceholderGuard<'a, Key, Arc<ReadySurface>, ByBytes, RandomState, DefaultLifecycle<Key, Arc<ReadySurface>>>;

/// Ready surfaces, at most so many bytes of them, those that are asked for again before others. For all threads.
#[derive(Debug)]
pub struct SurfaceCache {
    kept: Option<Kept>,
}

/// A file of which a surface is wanted.
struct Wanted<'a> {
    file: InputFile<'a>,
    hash: String,
    key: Key,
}

/// What a match has of a file that it claimed.
enum Claim<'a> {
    /// The surface.
    Kept(Arc<ReadySurface>),
    /// The task to prepare it, and where it is to be kept, if anywhere. Dropping that hands the task to one of those who
    /// wait.
    Missing(Wanted<'a>, Option<Guard<'a>>),
}

/// What it has of the file after reading it.
enum Progress<'a> {
    Kept(Arc<ReadySurface>),
    Read(Wanted<'a>, Box<PreparedSurface>, Option<Guard<'a>>),
}

impl<'a> Wanted<'a> {
    fn new(file: InputFile<'a>, parameters: &MatchParameters, limits: &IntakeLimits) -> Self {
        let hash = content_hash(file.bytes);
        let (input, coarse) = (&parameters.input, parameters.inference.coarse_vertices);
        // `Debug` shows every field, those that are added later too, and tells all numbers apart.
        let key = Key(format!("{hash} {:?} {input:?} {coarse:?} {limits:?}", file.name));
        Wanted { file, hash, key }
    }
}

impl<'a> Claim<'a> {
    fn read(self, parameters: &InputParameters, limits: &IntakeLimits) -> Result<Progress<'a>, IntakeError> {
        Ok(match self {
            Claim::Kept(surface) => Progress::Kept(surface),
            Claim::Missing(wanted, guard) => {
                let prepared = prepare_surface(wanted.file.bytes, wanted.file.name, parameters, limits)?;
                Progress::Read(wanted, Box::new(prepared), guard)
            }
        })
    }
}

impl Progress<'_> {
    fn mesh(&self) -> &SurfaceMesh {
        match self {
            Progress::Kept(surface) => &surface.prepared.mesh,
            Progress::Read(_, prepared, _) => &prepared.mesh,
        }
    }

    fn ready(self, coarse_vertices: Option<u32>) -> Arc<ReadySurface> {
        match self {
            Progress::Kept(surface) => surface,
            Progress::Read(wanted, prepared, guard) => {
                let levels = Levels::new(&prepared.mesh, coarse_vertices);
                let surface = Arc::new(ReadySurface { hash: wanted.hash, prepared: *prepared, levels });
                if let Some(guard) = guard {
                    // Those who wait get it even where it is too large to be kept.
                    let _ = guard.insert(Arc::clone(&surface));
                }
                surface
            }
        }
    }
}

impl SurfaceCache {
    /// Keeps surfaces of at most `max_bytes` together; `0` keeps none.
    pub fn new(max_bytes: u64) -> Self {
        let options = OptionsBuilder::new()
            // One: each of several would have a part of the bytes, too little for a large surface.
            .shards(1)
            .hot_allocation(SHARE_IN_USE)
            .weight_capacity(max_bytes)
            .estimated_items_capacity((max_bytes / TYPICAL_BYTES).max(16) as usize)
            .build();
        let kept = options.ok().filter(|_| max_bytes > 0);
        let kept = kept.map(|o| Cache::with_options(o, ByBytes, RandomState::new(), DefaultLifecycle::default()));
        SurfaceCache { kept }
    }

    /// Keeps nothing: each surface is prepared for its match alone.
    pub fn none() -> Self {
        SurfaceCache { kept: None }
    }

    /// Bytes of what is kept, counted with all that matches may add to it.
    pub fn bytes(&self) -> u64 {
        self.kept.as_ref().map_or(0, Cache::weight)
    }

    /// Source and target, each from here or prepared now, on the threads of the current pool. What is refused is not kept.
    ///
    /// # Errors
    /// [`RunError::Input`], the source's first; [`RunError::TooLarge`].
    ///
    /// # Cost
    /// Where both are kept, that of hashing both files; else that of [`prepare_surface`] and [`Levels::new`].
    pub fn ready(
        &self,
        files: [InputFile<'_>; 2],
        parameters: &MatchParameters,
        limits: &IntakeLimits,
        observer: &dyn Observer,
    ) -> Result<[Arc<ReadySurface>; 2], RunError> {
        observer.phase(Phase::Reading);
        let (source, target) = self.claims(files.map(|file| Wanted::new(file, parameters, limits)));
        let (source, target) = rayon::join(
            || source.read(&parameters.input, limits),
            || target.map(|target| target.read(&parameters.input, limits)).transpose(),
        );
        let source = source.map_err(|error| RunError::Input { side: Side::Source, error })?;
        let target = target.map_err(|error| RunError::Input { side: Side::Target, error })?;
        let (mesh, labels) = (source.mesh(), target.as_ref().unwrap_or(&source).mesh().n_vertices());
        check_size((mesh.n_vertices(), mesh.n_faces()), labels, parameters, limits)?;
        observer.phase(Phase::Features);
        let coarse = parameters.inference.coarse_vertices;
        let (source, target) = rayon::join(|| source.ready(coarse), || target.map(|target| target.ready(coarse)));
        metrics::gauge!("homolog_prepared_surfaces_bytes").set(self.bytes() as f64);
        let target = target.unwrap_or_else(|| Arc::clone(&source));
        Ok([source, target])
    }

    /// Claims both in the order of their keys; only the first where they are one file.
    fn claims<'a>(&'a self, [source, target]: [Wanted<'a>; 2]) -> (Claim<'a>, Option<Claim<'a>>) {
        match source.key.cmp(&target.key) {
            Ordering::Equal => (self.claim(source), None),
            Ordering::Less => {
                let source = self.claim(source);
                (source, Some(self.claim(target)))
            }
            Ordering::Greater => {
                let target = self.claim(target);
                (self.claim(source), Some(target))
            }
        }
    }

    fn claim<'a>(&'a self, wanted: Wanted<'a>) -> Claim<'a> {
        let Some(kept) = &self.kept else { return Claim::Missing(wanted, None) };
        let found = kept.get_value_or_guard(&wanted.key, Some(PATIENCE));
        let end = if matches!(found, GuardResult::Value(_)) { "hit" } else { "miss" };
        metrics::counter!("homolog_prepared_surfaces_total", "lookup" => end).increment(1);
        match found {
            GuardResult::Value(surface) => Claim::Kept(surface),
            GuardResult::Guard(guard) => Claim::Missing(wanted, Some(guard)),
            GuardResult::Timeout => Claim::Missing(wanted, None),
        }
    }
}
