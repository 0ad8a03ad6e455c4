//! The children of a process: a spare one that waits for its first request, and those that rest between two jobs.
//!
//! A child that has computed serves the same owner only from then on: whoever took control of it through a file sees no other
//! tenant's. It rests until there is a job of this owner, preferably with a file that it has prepared, and is ended after a
//! minute, when there are more of its kind than jobs that may run, when it has grown, and after any failure.

use super::messages::{Beginning, Confinement, KeptSurfaces};
use super::process::Child;
use std::io;
use std::path::PathBuf;
use std::sync::mpsc::{Receiver, RecvTimeoutError, SyncSender, channel, sync_channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

/// How long a child may rest.
const REST: Duration = Duration::from_secs(60);
/// How often resting children are looked at.
const ROUND: Duration = Duration::from_secs(5);
/// By how much a child may have grown besides the surfaces that it keeps, bytes; the allocator gives back little of what a
/// large job took.
const GROWTH: u64 = 256 << 20;

/// What children are started with.
#[derive(Debug, Clone)]
pub(super) struct Upbringing {
    /// The program.
    pub(super) program: PathBuf,
    /// What each is told first.
    pub(super) beginning: Beginning,
    /// Threads of each for what has no threads of its own.
    pub(super) n_threads: usize,
    /// Most children that rest.
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
    upbringing: Upbringing,
    waiting: Mutex<Waiting>,
}

#[derive(Debug, Default)]
struct Waiting {
    /// Has not computed yet.
    spare: Option<Child>,
    /// Have computed; the one that was given back last is the last.
    resting: Vec<Child>,
}

/// What the thread is asked that starts children.
enum Order {
    /// To see to it that there is a spare one.
    Spare,
    /// To start one for this caller.
    Now(SyncSender<io::Result<Child>>),
}

impl Shared {
    fn lock(&self) -> std::sync::MutexGuard<'_, Waiting> {
        self.waiting.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn start(&self) -> io::Result<Child> {
        let Upbringing { program, beginning, n_threads, .. } = &self.upbringing;
        Child::start(program, beginning, *n_threads)
    }
}

impl Children {
    /// Starts the first child.
    ///
    /// # Errors
    /// If it does not start.
    pub(super) fn start(upbringing: Upbringing) -> io::Result<(Self, Confinement)> {
        let shared = Arc::new(Shared { upbringing, waiting: Mutex::default() });
        let (orders, received) = channel();
        let of_thread = Arc::clone(&shared);
        // The kernel ends a child with the thread that has started it, so this one does nothing else, as long as the process lives.
        std::thread::Builder::new().name("children".to_owned()).spawn(move || raise(&of_thread, &received))?;
        let children = Children { shared, orders };
        let first = children.started()?;
        let confinement = first.confinement;
        children.shared.lock().spare = Some(first);
        Ok((children, confinement))
    }

    /// Waits for a child that is started now.
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

    /// The resting child that knows most of these files; the one that rested least if several do.
    fn rested(&self, owner: &str, hashes: &[[u8; 32]]) -> Option<Child> {
        loop {
            let mut waiting = self.shared.lock();
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
        let spare = self.shared.lock().spare.take();
        let spare = spare.and_then(|mut child| if child.is_alive() { Some(child) } else { None });
        let child = match spare {
            Some(child) => child,
            None => self.started()?,
        };
        // Its successor starts while it computes.
        let _ = self.orders.send(Order::Spare);
        Ok(child)
    }

    /// Takes a child back after a job that it has answered.
    pub(super) fn give_back(&self, mut child: Child, kept: KeptSurfaces) {
        if child.growth(kept.bytes) > GROWTH {
            return end(child, "grown");
        }
        child.rested = std::time::Instant::now();
        let mut waiting = self.shared.lock();
        waiting.resting.push(child);
        let over = waiting.resting.len() > self.shared.upbringing.most_resting;
        let oldest = over.then(|| waiting.resting.remove(0));
        drop(waiting);
        if let Some(oldest) = oldest {
            end(oldest, "rested");
        }
    }
}

/// Kills a child, for this reason.
pub(super) fn end(child: Child, reason: &'static str) {
    drop(child);
    ended(reason);
}

/// Counts the end of a child.
pub(super) fn ended(reason: &'static str) {
    metrics::counter!("homolog_children_ended_total", "reason" => reason).increment(1);
}

/// Starts children on order, and ends those that have rested long, until nobody orders any more.
fn raise(shared: &Shared, orders: &Receiver<Order>) {
    loop {
        match orders.recv_timeout(ROUND) {
            Ok(Order::Now(caller)) => {
                let _ = caller.send(shared.start());
            }
            Ok(Order::Spare) => {
                let is_missing = shared.lock().spare.is_none();
                if is_missing {
                    match shared.start() {
                        Ok(child) => shared.lock().spare = Some(child),
                        // The next one who needs it starts it, or hears why that fails.
                        Err(error) => tracing::warn!(%error, "no spare process for computations"),
                    }
                }
            }
            Err(RecvTimeoutError::Timeout) => {}
            Err(RecvTimeoutError::Disconnected) => return,
        }
        let rested: Vec<Child> = {
            let mut waiting = shared.lock();
            waiting.resting.extract_if(.., |child| child.rested.elapsed() > REST).collect()
        };
        rested.into_iter().for_each(|child| end(child, "rested"));
    }
}
