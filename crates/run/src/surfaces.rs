//! A cache of surfaces that are ready to be matched, keyed by the hash of the file they were made from.
//!
//! A study matches a thousand subjects to one template. Everything computed from the template alone (the repaired and
//! renumbered surface, its coarse levels, its search trees of closest points) is the same in each of these matches and
//! is prepared once. Quantities that depend on both surfaces, such as features, whose radius both share, are computed
//! in each match.
//!
//! **Access.** The key contains the hash of the whole file, computed here from the caller's bytes. The decision whether
//! the caller may read the file is made earlier, where the tenant's blobs are read. Two tenants with the same bytes
//! share the prepared surface, which either would have prepared alone. The only information that leaks, through the
//! time taken, is that a file equal to one's own was matched here recently.
//!
//! **Waiting.** Matches that need the same surface at the same time prepare it once. A match claims its two keys in
//! ascending order and prepares after it has both, so no two matches wait for each other. It claims before its threads
//! share any work: otherwise a thread that took over work of another match could wait for a surface that it is itself
//! preparing.

use super::{InputFile, RunError, Side, check_size, content_hash};
use crate::intake::{IntakeError, IntakeLimits, PreparedSurface, prepare_surface};
use homolog_contract::parameters::{InputParameters, MatchParameters};
use homolog_matching::{Levels, MatchError};
use homolog_mesh::SurfaceMesh;
use homolog_primitives::observe::{Cancelled, Observer, Phase};
use quick_cache::sync::{Cache, DefaultLifecycle, GuardResult, PlaceholderGuard};
use quick_cache::{OptionsBuilder, Weighter};
use std::cmp::Ordering;
use std::hash::RandomState;
use std::sync::Arc;
use std::time::Duration;

/// Time that a match waits for another match to prepare a surface before it prepares the surface itself. Preparing
/// takes seconds at most; after this time the other match has been stopped or gets no processor time.
const MAX_WAIT: Duration = Duration::from_secs(30);
/// Share of the bytes for surfaces that were requested again; the rest is for new ones, which are evicted first. A
/// surface larger than this share is not kept.
const SHARE_IN_USE: f64 = 0.75;
/// Bytes of a surface of about 1,000 vertices with its bending-invariant form. Determines the number of keys remembered
/// after their surfaces were evicted.
const TYPICAL_BYTES: u64 = 7 << 20;

/// A surface that is ready to be matched to any other.
pub(crate) struct ReadySurface {
    /// Content address of the file the surface was made from.
    pub hash: String,
    /// The surface in the order of the upload, with its numbering and its report.
    pub prepared: PreparedSurface,
    /// Data for matches: the surface and its coarse levels in canonical numbering.
    pub levels: Levels,
}

impl ReadySurface {
    fn heap_bytes(&self) -> u64 {
        (self.prepared.heap_bytes() + self.levels.heap_bytes()) as u64
    }
}

/// Everything that a ready surface depends on, as text.
#[derive(Debug, Clone, PartialEq, Eq, Hash, PartialOrd, Ord)]
struct Key(String);

/// Weighs a surface by its memory after matches have added everything they compute on demand, so that weights never
/// change.
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

/// Ready surfaces up to a number of bytes, preferring repeatedly requested ones. Shared by all threads.
#[derive(Debug)]
pub struct SurfaceCache {
    kept: Option<Kept>,
}

/// A file whose surface a match needs.
struct Request<'a> {
    file: InputFile<'a>,
    hash: String,
    key: Key,
}

/// The result of claiming a key.
enum Claim<'a> {
    /// The surface was kept.
    Kept(Arc<ReadySurface>),
    /// The match must prepare the surface, and insert it through the guard, if there is one. Dropping the guard passes
    /// this task to one of the waiting matches.
    Missing(Request<'a>, Option<Guard<'a>>),
}

/// A claim whose file was read.
enum Progress<'a> {
    Kept(Arc<ReadySurface>),
    Read(Request<'a>, Box<PreparedSurface>, Option<Guard<'a>>),
}

impl<'a> Request<'a> {
    fn new(
        file: InputFile<'a>,
        (input, mirror): &(InputParameters, bool),
        coarse: Option<u32>,
        limits: &IntakeLimits,
    ) -> Self {
        let hash = content_hash(file.bytes);
        // `Debug` prints every field, including those added later, and prints different numbers differently.
        let key = Key(format!("{hash} {:?} {input:?} {mirror} {coarse:?} {limits:?}", file.name));
        Request { file, hash, key }
    }
}

impl<'a> Claim<'a> {
    fn read(
        self,
        (parameters, mirror): &(InputParameters, bool),
        limits: &IntakeLimits,
    ) -> Result<Progress<'a>, IntakeError> {
        Ok(match self {
            Claim::Kept(surface) => Progress::Kept(surface),
            Claim::Missing(request, guard) => {
                let prepared = prepare_surface(request.file.bytes, request.file.name, parameters, limits)?;
                let prepared = if *mirror { prepared.mirrored()? } else { prepared };
                Progress::Read(request, Box::new(prepared), guard)
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

    fn ready(self, coarse_vertices: Option<u32>, observer: &dyn Observer) -> Result<Arc<ReadySurface>, Cancelled> {
        Ok(match self {
            Progress::Kept(surface) => surface,
            Progress::Read(request, prepared, guard) => {
                let levels = Levels::observed(&prepared.mesh, &prepared.numbering, coarse_vertices, observer)?;
                let surface = Arc::new(ReadySurface { hash: request.hash, prepared: *prepared, levels });
                if let Some(guard) = guard {
                    // Waiting matches get the surface even if it is too large to be kept.
                    let _ = guard.insert(Arc::clone(&surface));
                }
                surface
            }
        })
    }
}

impl SurfaceCache {
    /// A cache of at most `max_bytes`; `0` keeps nothing.
    pub fn new(max_bytes: u64) -> Self {
        let options = OptionsBuilder::new()
            // With several shards each would have only a part of the bytes, too little for a large surface.
            .shards(1)
            .hot_allocation(SHARE_IN_USE)
            .weight_capacity(max_bytes)
            .estimated_items_capacity((max_bytes / TYPICAL_BYTES).max(16) as usize)
            .build();
        let kept = options.ok().filter(|_| max_bytes > 0);
        let kept = kept.map(|o| Cache::with_options(o, ByBytes, RandomState::new(), DefaultLifecycle::default()));
        SurfaceCache { kept }
    }

    /// A cache that keeps nothing: each surface is prepared for its match alone.
    pub fn none() -> Self {
        SurfaceCache { kept: None }
    }

    /// Memory of the kept surfaces, bytes, including everything that matches may add to them.
    pub fn bytes(&self) -> u64 {
        self.kept.as_ref().map_or(0, Cache::weight)
    }

    /// Source and target, each taken from the cache or prepared now, on the threads of the current pool. A refused
    /// input is not kept.
    ///
    /// # Errors
    /// [`RunError::Input`], for the source if both are refused; [`RunError::TooLarge`].
    ///
    /// # Cost
    /// If both are kept, the cost of hashing both files; otherwise plus the cost of [`prepare_surface`] and
    /// [`Levels::numbered`].
    pub(crate) fn ready(
        &self,
        files: [InputFile<'_>; 2],
        parameters: &MatchParameters,
        limits: &IntakeLimits,
        observer: &dyn Observer,
    ) -> Result<[Arc<ReadySurface>; 2], RunError> {
        observer.phase(Phase::Reading);
        let coarse = parameters.inference.coarse_vertices;
        // Each input has its own labels; equal files with equal parameters are prepared once.
        let input = &parameters.input;
        let inputs = [(input.of_source(), input.source.mirror), (input.of_target(), input.target.mirror)];
        let [source, target] = files;
        let (source, target) = self.claims([
            Request::new(source, &inputs[0], coarse, limits),
            Request::new(target, &inputs[1], coarse, limits),
        ]);
        let (source, target) = rayon::join(
            || source.read(&inputs[0], limits),
            || target.map(|target| target.read(&inputs[1], limits)).transpose(),
        );
        let source = source.map_err(|error| RunError::Input { side: Side::Source, error })?;
        let target = target.map_err(|error| RunError::Input { side: Side::Target, error })?;
        let (mesh, labels) = (source.mesh(), target.as_ref().unwrap_or(&source).mesh().n_vertices());
        check_size((mesh.n_vertices(), mesh.n_faces()), labels, parameters, limits)?;
        observer.phase(Phase::Features);
        let (source, target) = rayon::join(
            || source.ready(coarse, observer),
            || target.map(|target| target.ready(coarse, observer)).transpose(),
        );
        let (source, target) = (source.map_err(MatchError::from)?, target.map_err(MatchError::from)?);
        metrics::gauge!("homolog_prepared_surfaces_bytes").set(self.bytes() as f64);
        let target = target.unwrap_or_else(|| Arc::clone(&source));
        Ok([source, target])
    }

    /// Claims both keys in ascending order; a single claim if the keys are equal.
    fn claims<'a>(&'a self, [source, target]: [Request<'a>; 2]) -> (Claim<'a>, Option<Claim<'a>>) {
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

    fn claim<'a>(&'a self, request: Request<'a>) -> Claim<'a> {
        let Some(kept) = &self.kept else { return Claim::Missing(request, None) };
        let found = kept.get_value_or_guard(&request.key, Some(MAX_WAIT));
        let lookup = if matches!(found, GuardResult::Value(_)) { "hit" } else { "miss" };
        metrics::counter!("homolog_prepared_surfaces_total", "lookup" => lookup).increment(1);
        match found {
            GuardResult::Value(surface) => Claim::Kept(surface),
            GuardResult::Guard(guard) => Claim::Missing(request, Some(guard)),
            GuardResult::Timeout => Claim::Missing(request, None),
        }
    }
}
