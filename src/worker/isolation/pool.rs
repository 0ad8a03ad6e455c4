//! The children of a process: a spare child that waits for its first request, and children that rest between two jobs.
//!
//! A child that has computed for an owner serves only this owner from then on, so whoever takes control of it through a
//! file sees no other tenant's data. It rests until this owner has a job, preferably one with a file that it has
//! prepared. It is ended after a minute of rest, when more children rest than jobs may run, when it has grown, and
//! after any failure.

use super::messages::{Confinement, Handshake, KeptSurfaces};
use super::process::Child;
use parking_lot::Mutex;
use std::io;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::mpsc::{Receiver, RecvTimeoutError, SyncSender, channel, sync_channel};
use std::time::Duration;

/// How long a child may rest.
const REST: Duration = Duration::from_secs(60);
/// How often the resting children are checked.
const ROUND: Duration = Duration::from_secs(5);
/// How much a child may have grown besides the surfaces that it keeps, bytes; the allocator returns little of what a
/// large job took.
const GROWTH: u64 = 256 << 20;

/// Settings with which children are started.
#[derive(Debug, Clone)]
pub(super) struct ChildSettings {
    /// The program.
    pub(super) program: PathBuf,
    /// The first message to each child.
    pub(super) beginning: Handshake,
    /// Threads of each child for work without dedicated threads.
    pub(super) n_threads: usize,
    /// Most children that rest at the same time.
    pub(super) most_resting: usize,
}

/// The children of a process. They are killed when this is dropped.
#[derive(Debug)]
pub(super) struct Children {
    shared: Arc<Shared>,
    orders: std::sync::mpsc::Sender<Order>,
}

#[derive(Debug)]
struct Shared {
    upbringing: ChildSettings,
    waiting: Mutex<Waiting>,
}

#[derive(Debug, Default)]
struct Waiting {
    /// A child that has not computed yet.
    spare: Option<Child>,
    /// Children that have computed, the one that was given back last at the end.
    resting: Vec<Child>,
}

/// A request to the thread that starts children.
enum Order {
    /// Ensure that there is a spare child.
    Spare,
    /// Start a child for this caller.
    Now(SyncSender<io::Result<Child>>),
}

impl Shared {
    fn start(&self) -> io::Result<Child> {
        let ChildSettings { program, beginning, n_threads, .. } = &self.upbringing;
        Child::start(program, beginning, *n_threads)
    }
}

impl Children {
    /// Starts the first child.
    ///
    /// # Errors
    /// If the child does not start.
    pub(super) fn start(upbringing: ChildSettings) -> io::Result<(Self, Confinement)> {
        let shared = Arc::new(Shared { upbringing, waiting: Mutex::default() });
        let (orders, received) = channel();
        let of_thread = Arc::clone(&shared);
        // The kernel ends a child when the thread that started it ends, so this thread does nothing else and lives as
        // long as the process.
        std::thread::Builder::new().name("children".to_owned()).spawn(move || raise(&of_thread, &received))?;
        let children = Children { shared, orders };
        let first = children.started()?;
        let confinement = first.confinement;
        children.shared.waiting.lock().spare = Some(first);
        Ok((children, confinement))
    }

    /// Waits for a new child to start.
    fn started(&self) -> io::Result<Child> {
        let (sender, receiver) = sync_channel(1);
        self.orders.send(Order::Now(sender)).map_err(io::Error::other)?;
        receiver.recv().map_err(io::Error::other)?
    }

    /// A child for one job of this owner over files of these hashes.
    ///
    /// # Errors
    /// If none can be started.
    pub(super) fn take(&self, owner: &str, hashes: &[[u8; 32]]) -> io::Result<Child> {
        let mut child = match self.rested(owner, hashes) {
            Some(child) => child,
            None => self.take_fresh()?,
        };
        child.owner = Some(owner.to_owned());
        child.serves(hashes);
        Ok(child)
    }

    /// The resting child that knows most of these files; among equals, the one that has rested for the shortest time.
    fn rested(&self, owner: &str, hashes: &[[u8; 32]]) -> Option<Child> {
        loop {
            let mut waiting = self.shared.waiting.lock();
            let of_owner =
                waiting.resting.iter().enumerate().filter(|(_, child)| child.owner.as_deref() == Some(owner));
            let (place, _) = of_owner.max_by_key(|(place, child)| (child.n_known(hashes), *place))?;
            let mut child = waiting.resting.remove(place);
            drop(waiting);
            if child.is_alive() {
                return Some(child);
            }
            ended(child.end().reason());
        }
    }

    /// A child that has computed nothing yet.
    ///
    /// # Errors
    /// If none can be started.
    pub(super) fn take_fresh(&self) -> io::Result<Child> {
        let spare = self.shared.waiting.lock().spare.take();
        let spare = spare.and_then(|mut child| if child.is_alive() { Some(child) } else { None });
        let child = match spare {
            Some(child) => child,
            None => self.started()?,
        };
        // The next spare child starts while this one computes.
        let _ = self.orders.send(Order::Spare);
        Ok(child)
    }

    /// Takes a child back after it has answered a job.
    pub(super) fn give_back(&self, mut child: Child, kept: KeptSurfaces) {
        if child.growth(kept.bytes) > GROWTH {
            return end(child, "grown");
        }
        child.rested = std::time::Instant::now();
        let mut waiting = self.shared.waiting.lock();
        waiting.resting.push(child);
        let over = waiting.resting.len() > self.shared.upbringing.most_resting;
        let oldest = over.then(|| waiting.resting.remove(0));
        drop(waiting);
        if let Some(oldest) = oldest {
            end(oldest, "rested");
        }
    }
}

/// Kills a child and counts the reason.
pub(super) fn end(child: Child, reason: &'static str) {
    drop(child);
    ended(reason);
}

/// Counts the end of a child.
pub(super) fn ended(reason: &'static str) {
    metrics::counter!("homolog_children_ended_total", "reason" => reason).increment(1);
}

/// Starts children on request, and ends those that have rested too long, until the pool is dropped.
fn raise(shared: &Shared, orders: &Receiver<Order>) {
    loop {
        match orders.recv_timeout(ROUND) {
            Ok(Order::Now(caller)) => {
                let _ = caller.send(shared.start());
            }
            Ok(Order::Spare) => {
                let is_missing = shared.waiting.lock().spare.is_none();
                if is_missing {
                    match shared.start() {
                        Ok(child) => shared.waiting.lock().spare = Some(child),
                        // The next caller that needs a child starts it or receives the error.
                        Err(error) => tracing::warn!(%error, "no spare process for computations"),
                    }
                }
            }
            Err(RecvTimeoutError::Timeout) => {}
            Err(RecvTimeoutError::Disconnected) => return,
        }
        let rested: Vec<Child> = {
            let mut waiting = shared.waiting.lock();
            waiting.resting.extract_if(.., |child| child.rested.elapsed() > REST).collect()
        };
        rested.into_iter().for_each(|child| end(child, "rested"));
    }
}
