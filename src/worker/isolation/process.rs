//! One child, as its parent sees it: start, requests, limits, end, and the cause of its death.

use super::limits::{self, Bounds};
use super::messages::{ChildMessage, Confinement, Handshake, KeptSurfaces, Outcome, Request};
use super::protocol::{FrameError, Longest, read_frame, write_frame};
use std::collections::VecDeque;
use std::io::{self, Read, Write};
use std::os::fd::OwnedFd;
use std::os::unix::net::UnixStream;
use std::os::unix::process::{CommandExt as _, ExitStatusExt as _};
use std::path::Path;
use std::process::{Child as Process, ChildStderr, Command, ExitStatus, Stdio};
use std::time::{Duration, Instant};

/// How often a waiting parent checks whether it should stop.
const LOOK: Duration = Duration::from_millis(20);
/// How long a child may take to start.
const START: Duration = Duration::from_secs(20);
/// How long a child that has closed its connection may take to end.
const ENDING: Duration = Duration::from_secs(5);
/// Bytes of a dead child's standard error that are read.
const LAST_WORDS: u64 = 4096;
/// Files that the parent remembers for each child.
const REMEMBERED: usize = 64;
/// Longest head of a frame from a child, bytes: it holds reports on inputs, never surfaces.
const LONGEST_HEAD: u32 = 8 << 20;
/// The name of the hidden command, and the variable with the number of the process that started it.
pub const COMMAND: &str = "compute-child";
/// Signals by which the kernel or the program itself ends a process.
const ABORTED: i32 = 6;
const KILLED: i32 = 9;
const OUT_OF_TIME: i32 = 24;

/// Why a request has no answer.
#[derive(Debug)]
pub(super) enum AskError {
    /// The caller stopped the request.
    Stopped,
    /// The connection ended, or a frame was malformed.
    Lost(FrameError),
}

/// The cause of a child's death.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Death {
    /// An allocation failed.
    Memory,
    /// It used up its processor time.
    Time,
    /// Something outside killed it: an operator, or the kernel to free memory.
    Killed,
    /// A fault of the program, or of an attacker who controls it.
    Crashed {
        /// The signal, if there was one.
        signal: Option<i32>,
    },
}

impl Death {
    /// The label of the cause in metrics.
    pub(super) fn reason(self) -> &'static str {
        match self {
            Death::Memory => "memory",
            Death::Time => "time",
            Death::Killed => "killed",
            Death::Crashed { .. } => "crashed",
        }
    }

    fn of(status: ExitStatus, last_words: &str) -> Self {
        match status.signal() {
            // The text of the standard library. No input can imitate it, because computations print nothing.
            Some(ABORTED) if last_words.contains("memory allocation of ") => Death::Memory,
            Some(OUT_OF_TIME) => Death::Time,
            Some(KILLED) => Death::Killed,
            signal => Death::Crashed { signal },
        }
    }
}

/// Receives what a child sends before its last answer, and may answer through the connection.
pub(super) type Hear<'a> = dyn FnMut(ChildMessage, Vec<u8>, &mut dyn Write) -> io::Result<()> + 'a;

/// A child that waits for requests. Dropping it kills it.
#[derive(Debug)]
pub(super) struct Child {
    process: Process,
    stream: UnixStream,
    stderr: Option<ChildStderr>,
    scratch_bytes: u64,
    resident_at_start: u64,
    /// The confinement of the child.
    pub(super) confinement: Confinement,
    /// The owner for whom it has computed.
    pub(super) owner: Option<String>,
    /// Hashes of the files that it has computed with, the latest last.
    served: VecDeque<[u8; 32]>,
    /// When it was last given back.
    pub(super) rested: Instant,
}

impl Child {
    /// Starts a child, and waits until it takes requests. The calling thread must live as long as the child: the kernel kills
    /// it when that thread ends.
    ///
    /// # Errors
    /// Those of the system; a child of another version of the program.
    pub(super) fn start(program: &Path, beginning: &Handshake, n_threads: usize) -> io::Result<Self> {
        let (ours, theirs) = UnixStream::pair()?;
        let mut process = Command::new(program)
            .arg0("homolog")
            .arg(COMMAND)
            .arg(std::process::id().to_string())
            .env_clear()
            // A child that opens no files cannot see how many cores the container has.
            .env("RAYON_NUM_THREADS", n_threads.to_string())
            .current_dir("/")
            .stdin(Stdio::from(OwnedFd::from(theirs)))
            .stdout(Stdio::null())
            .stderr(Stdio::piped())
            .spawn()?;
        ours.set_read_timeout(Some(LOOK))?;
        ours.set_write_timeout(Some(LOOK))?;
        let stderr = process.stderr.take();
        metrics::counter!("homolog_children_started_total").increment(1);
        let mut child = Child {
            process,
            stream: ours,
            stderr,
            scratch_bytes: 0,
            resident_at_start: 0,
            confinement: Confinement::default(),
            owner: None,
            served: VecDeque::new(),
            rested: Instant::now(),
        };
        let began = Instant::now();
        let late = || began.elapsed() > START;
        let mut patient = Patient { stream: &child.stream, stop: &late };
        let ready = write_frame(&mut patient, beginning, &[]).map_err(FrameError::from);
        let ready = ready.and_then(|()| read_frame(&mut patient, Longest { head: LONGEST_HEAD, body: 0 }));
        match ready {
            Ok((ChildMessage::Ready { confinement, scratch_bytes }, _)) => {
                (child.confinement, child.scratch_bytes) = (confinement, scratch_bytes);
                child.resident_at_start = child.resident();
                Ok(child)
            }
            Ok(_) => Err(io::Error::other("a child spoke out of turn")),
            Err(error) => {
                let death = child.end();
                Err(io::Error::other(format!("a child did not start: {error}, {}", death.reason())))
            }
        }
    }

    /// Sends a request and receives the messages of the child until its last answer. `hear` gets every message in
    /// between, and may answer through its last argument. Frames may have bodies of `longest_body` bytes together.
    ///
    /// # Errors
    /// [`AskError`]; the child cannot be used any more.
    pub(super) fn ask(
        &mut self,
        request: &Request,
        body: &[&[u8]],
        bounds: Bounds,
        stop: &dyn Fn() -> bool,
        hear: &mut Hear<'_>,
    ) -> Result<(Outcome, Vec<u8>, KeptSurfaces), AskError> {
        limits::bound(self.process.id(), bounds, self.scratch_bytes);
        let mut patient = Patient { stream: &self.stream, stop };
        let broken = |error: FrameError| if stop() { AskError::Stopped } else { AskError::Lost(error) };
        write_frame(&mut patient, request, body).map_err(|error| broken(error.into()))?;
        // An answer may take no more memory here than the computation may take in the child.
        let mut left = bounds.memory_bytes;
        loop {
            let longest = Longest { head: LONGEST_HEAD, body: left };
            let (told, body) = read_frame(&mut patient, longest).map_err(broken)?;
            left = left.saturating_sub(body.len() as u64);
            match told {
                ChildMessage::Done { outcome, kept } => return Ok((outcome, body, kept)),
                told => hear(told, body, &mut patient).map_err(|error| broken(error.into()))?,
            }
            if stop() {
                return Err(AskError::Stopped);
            }
        }
    }

    /// Whether the child still runs.
    pub(super) fn is_alive(&mut self) -> bool {
        matches!(self.process.try_wait(), Ok(None))
    }

    /// Remembers that the child has computed with the files of these hashes.
    pub(super) fn serves(&mut self, hashes: &[[u8; 32]]) {
        for hash in hashes {
            self.served.retain(|served| served != hash);
            self.served.push_back(*hash);
        }
        while self.served.len() > REMEMBERED {
            self.served.pop_front();
        }
    }

    /// How many of these files the child has computed with.
    pub(super) fn n_known(&self, hashes: &[[u8; 32]]) -> usize {
        hashes.iter().filter(|hash| self.served.contains(hash)).count()
    }

    /// How much the child has grown since it started, besides the surfaces that it keeps, bytes.
    pub(super) fn growth(&self, kept_bytes: u64) -> u64 {
        self.resident().saturating_sub(self.resident_at_start).saturating_sub(kept_bytes)
    }

    fn resident(&self) -> u64 {
        limits::memory_of(Some(self.process.id())).map_or(0, |memory| memory.resident)
    }

    /// The cause of death of a child whose connection has ended. A child that still runs is killed.
    pub(super) fn end(mut self) -> Death {
        let began = Instant::now();
        let mut status = None;
        while status.is_none() && began.elapsed() < ENDING {
            match self.process.try_wait() {
                Ok(None) => std::thread::sleep(Duration::from_millis(2)),
                Ok(Some(ended)) => status = Some(ended),
                Err(_) => break,
            }
        }
        // A child that has closed its connection but still runs counts as dead.
        let Some(status) = status else { return Death::Crashed { signal: None } };
        let mut words = Vec::new();
        if let Some(stderr) = self.stderr.take() {
            let _ = stderr.take(LAST_WORDS).read_to_end(&mut words);
        }
        Death::of(status, &String::from_utf8_lossy(&words))
    }
}

impl Drop for Child {
    fn drop(&mut self) {
        // The child leads its own group, which cannot contain any other process.
        if let Ok(Some(group)) = i32::try_from(self.process.id()).map(rustix::process::Pid::from_raw)
            && self.is_alive()
        {
            let _ = rustix::process::kill_process_group(group, rustix::process::Signal::KILL);
        }
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}

/// A connection that checks while it waits whether to stop.
struct Patient<'a> {
    stream: &'a UnixStream,
    stop: &'a dyn Fn() -> bool,
}

impl Patient<'_> {
    fn patiently<T>(&mut self, mut work: impl FnMut(&UnixStream) -> io::Result<T>) -> io::Result<T> {
        loop {
            match work(self.stream) {
                Err(error) if matches!(error.kind(), io::ErrorKind::WouldBlock | io::ErrorKind::TimedOut) => {
                    if (self.stop)() {
                        return Err(io::ErrorKind::TimedOut.into());
                    }
                }
                Err(error) if error.kind() == io::ErrorKind::Interrupted => {}
                done => return done,
            }
        }
    }
}

impl Read for Patient<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        self.patiently(|mut stream| stream.read(buffer))
    }
}

impl Write for Patient<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.patiently(|mut stream| stream.write(bytes))
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_death_is_told_by_its_signal_and_the_words_of_the_library() {
        let words = "memory allocation of 123 bytes failed\n";
        for (raw, words, expected) in [
            (ABORTED, words, Death::Memory),
            (ABORTED, "", Death::Crashed { signal: Some(ABORTED) }),
            (KILLED, words, Death::Killed),
            (OUT_OF_TIME, "", Death::Time),
            (11, words, Death::Crashed { signal: Some(11) }),
            (1 << 8, "", Death::Crashed { signal: None }),
        ] {
            assert_eq!(Death::of(ExitStatus::from_raw(raw), words), expected, "{raw}");
        }
    }
}
