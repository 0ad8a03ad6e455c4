//! The audit log: who did what, when, from where and with which outcome, one row for each request that changes something or
//! reads a result or an upload. Rows hold ids, never names, labels, references or file names.
//!
//! Rows are numbered and chained: the hash of a row covers that of the row before it ([`AuditRow::hash_after`]), so that no row
//! can be changed, removed or inserted without recomputing all later ones. What no chain can show by itself is that its end is
//! missing: the store therefore also keeps the position and the hash of the last row ([`AuditHead`]), and who notes them
//! elsewhere can tell even if both were changed ([`Verifier::expect`]).

use super::error::JobError;
use super::job::Tenant;
use async_trait::async_trait;
use parking_lot::Mutex;
use ring::digest::{SHA256, digest};
use serde::{Deserialize, Serialize};
use std::fmt::Write as _;
use std::sync::Arc;
use std::time::{Duration, Instant};
use tokio::sync::{Notify, oneshot};

/// Most rows stored in one transaction.
const AT_ONCE: usize = 200;
/// Most requests of nobody in particular that are recorded within [`ANONYMOUS_WINDOW`]: they cost a client nothing, so that the
/// log could be filled with them.
const MAX_ANONYMOUS: u32 = 60;
const ANONYMOUS_WINDOW: Duration = Duration::from_secs(60);

/// The record of a request.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct AuditEvent {
    /// Tenant of the request; `None` if nobody was authenticated.
    pub tenant: Option<Tenant>,
    /// Public part of its API key, if keys are required.
    pub key_id: Option<String>,
    /// Operation of the API, or command.
    pub action: String,
    /// Its kind and id, such as `jobs/019d8a1b-…`; `None` if there is none.
    pub resource: Option<String>,
    /// Network address of the client; `command-line` for commands.
    pub address: Option<String>,
    /// Status of the answer; `None` if the client left before it.
    pub status: Option<u16>,
}

/// A row of the log.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct AuditRow {
    /// 1, 2, 3, … without a gap.
    pub position: u64,
    /// When it was stored, by the clock of the database: RFC 3339, with milliseconds.
    pub at: String,
    /// As in [`AuditEvent`].
    pub tenant: Option<String>,
    /// As in [`AuditEvent`].
    pub key_id: Option<String>,
    /// As in [`AuditEvent`].
    pub action: String,
    /// As in [`AuditEvent`].
    pub resource: Option<String>,
    /// As in [`AuditEvent`].
    pub address: Option<String>,
    /// As in [`AuditEvent`].
    pub status: Option<i64>,
    /// 64 hexadecimal digits: see [`AuditRow::hash_after`].
    pub hash: String,
}

impl AuditRow {
    /// SHA-256 of the previous row's hash and of all other fields in their order, joined by line feeds; absent fields are empty.
    /// No field contains a line feed, so that different rows give different texts.
    pub fn hash_after(&self, previous: &str) -> String {
        let text = |field: &Option<String>| field.clone().unwrap_or_default();
        let fields = [
            previous.to_owned(),
            self.position.to_string(),
            self.at.clone(),
            text(&self.tenant),
            text(&self.key_id),
            self.action.clone(),
            text(&self.resource),
            text(&self.address),
            self.status.map(|status| status.to_string()).unwrap_or_default(),
        ];
        let mut hash = String::with_capacity(64);
        for byte in digest(&SHA256, fields.join("\n").as_bytes()).as_ref() {
            let _ = write!(hash, "{byte:02x}");
        }
        hash
    }
}

/// Action of the row that is recorded when rows are pruned.
const PRUNED: &str = "prune_audit";

impl AuditEvent {
    /// The removal of all rows up to this one.
    pub fn pruned(up_to: &AuditHead) -> Self {
        AuditEvent {
            tenant: None,
            key_id: None,
            action: PRUNED.to_owned(),
            resource: Some(format!("audit/{up_to}")),
            address: Some("command-line".to_owned()),
            status: None,
        }
    }
}

impl AuditRow {
    /// The row up to which the log was pruned, if this row says that it was.
    pub fn pruned(&self) -> Option<AuditHead> {
        AuditHead::parse(self.resource.as_ref().filter(|_| self.action == PRUNED)?.strip_prefix("audit/")?)
    }
}

/// The last row of the log.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct AuditHead {
    /// Its position; 0 if there is no row.
    pub position: u64,
    /// Its hash.
    pub hash: String,
}

impl AuditHead {
    /// Before the first row.
    pub fn start() -> Self {
        AuditHead { position: 0, hash: "0".repeat(64) }
    }

    /// The head in the form `POSITION:HASH`.
    pub fn parse(text: &str) -> Option<Self> {
        let (position, hash) = text.split_once(':')?;
        let is_hash = super::artifact::is_hash(hash);
        Some(AuditHead { position: position.parse().ok()?, hash: is_hash.then(|| hash.to_owned())? })
    }
}

impl std::fmt::Display for AuditHead {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}:{}", self.position, self.hash)
    }
}

/// A fault of a log.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum AuditFault {
    /// The row is not there, but later ones are.
    #[error("row {0} is missing")]
    Missing(u64),
    /// The row, or its hash, is not what was written.
    #[error("row {0} was changed, or the rows before it were replaced")]
    Changed(u64),
    /// The log ends before the row that is known to be its last.
    #[error("row {0} and those after it were cut off: the log had at least {1} rows")]
    Truncated(u64, u64),
    /// No row says that the log was pruned up to where it begins.
    #[error("the log begins after row {0}, and no row says that it was pruned up to there")]
    Unrecorded(u64),
    /// A row has another hash than the one that was noted of it.
    #[error("row {0} has another hash than the one noted: the log was rewritten")]
    Rewritten(u64),
}

/// Checks a log row by row, in the order of positions.
#[derive(Debug, Clone)]
pub struct Verifier {
    last: AuditHead,
    expected: Vec<AuditHead>,
    /// Where the log begins, and whether a row said so.
    anchor: AuditHead,
    is_recorded: bool,
}

impl Default for Verifier {
    fn default() -> Self {
        Verifier::after(AuditHead::start())
    }
}

impl Verifier {
    /// Of a log that was pruned up to a row, and that has to say so in a later one.
    pub fn after(anchor: AuditHead) -> Self {
        Verifier { last: anchor.clone(), expected: Vec::new(), is_recorded: anchor.position == 0, anchor }
    }

    /// The row of this position must have this hash.
    pub fn expect(&mut self, head: AuditHead) {
        self.expected.push(head);
    }

    /// Takes the next row.
    ///
    /// # Errors
    /// The first fault of the log, if it is at this row.
    pub fn add(&mut self, row: &AuditRow) -> Result<(), AuditFault> {
        let position = self.last.position + 1;
        if row.position > position {
            return Err(AuditFault::Missing(position));
        }
        if row.position < position || row.hash != row.hash_after(&self.last.hash) {
            return Err(AuditFault::Changed(row.position));
        }
        if self.expected.iter().any(|head| head.position == position && head.hash != row.hash) {
            return Err(AuditFault::Rewritten(position));
        }
        self.is_recorded |= row.pruned().is_some_and(|pruned| pruned == self.anchor);
        self.last = AuditHead { position, hash: row.hash.clone() };
        Ok(())
    }

    /// Ends the log, and returns its last row.
    ///
    /// # Errors
    /// If rows are missing at its end.
    pub fn end(self) -> Result<AuditHead, AuditFault> {
        let last = self.last.position;
        if !self.is_recorded {
            return Err(AuditFault::Unrecorded(self.anchor.position));
        }
        if self.expected.iter().any(|head| head.position == self.anchor.position && head.hash != self.anchor.hash) {
            return Err(AuditFault::Rewritten(self.anchor.position));
        }
        match self.expected.iter().map(|head| head.position).max() {
            Some(known) if known > last => Err(AuditFault::Truncated(last + 1, known)),
            _ => Ok(self.last),
        }
    }
}

/// Where the log is stored.
#[async_trait]
pub trait AuditStore: Send + Sync {
    /// Appends these rows; when this returns, they survive a loss of power.
    async fn append_audit(&self, events: &[AuditEvent]) -> Result<(), JobError>;

    /// The rows after a position, at most `limit` of them.
    async fn list_audit(&self, after: u64, limit: u32) -> Result<Vec<AuditRow>, JobError>;

    /// The last row, as recorded beside the rows.
    async fn audit_head(&self) -> Result<AuditHead, JobError>;
}

/// Appends to the log. Requests that end while rows are being stored share the next transaction.
pub struct Recorder {
    store: Arc<dyn AuditStore>,
    queue: Mutex<Queue>,
    idle: Notify,
}

#[derive(Default)]
struct Queue {
    waiting: Vec<(AuditEvent, oneshot::Sender<bool>)>,
    is_writing: bool,
    anonymous: Option<(Instant, u32)>,
}

impl Recorder {
    /// A recorder into this store.
    pub fn new(store: Arc<dyn AuditStore>) -> Arc<Self> {
        Arc::new(Recorder { store, queue: Mutex::default(), idle: Notify::new() })
    }

    /// Appends an event, also if the returned future is dropped. Completes with whether the row is stored; an event that
    /// could not be stored is in the log of the process instead.
    pub fn record(self: &Arc<Self>, event: AuditEvent) -> impl Future<Output = bool> + Send + use<> {
        let (done, stored) = oneshot::channel();
        let begins = {
            let mut queue = self.queue.lock();
            if event.tenant.is_none() && !queue.admits_anonymous() {
                metrics::counter!("homolog_audit_rows_total", "row" => "left out").increment(1);
                let _ = done.send(true);
                false
            } else {
                queue.waiting.push((event, done));
                !std::mem::replace(&mut queue.is_writing, true)
            }
        };
        if begins {
            tokio::spawn(Arc::clone(self).write());
        }
        async move { stored.await.unwrap_or(false) }
    }

    async fn write(self: Arc<Self>) {
        loop {
            let batch: Vec<_> = {
                let mut queue = self.queue.lock();
                let n = queue.waiting.len().min(AT_ONCE);
                if n == 0 {
                    queue.is_writing = false;
                    self.idle.notify_waiters();
                    return;
                }
                queue.waiting.drain(..n).collect()
            };
            let (events, waiting): (Vec<_>, Vec<_>) = batch.into_iter().unzip();
            let stored = self.store.append_audit(&events).await;
            if let Err(error) = &stored {
                for event in &events {
                    let AuditEvent { tenant, key_id, action, resource, address, status } = event;
                    let tenant = tenant.as_ref().map(Tenant::name);
                    tracing::error!(
                        %error, tenant, key_id, action, resource, address, status,
                        "a row of the audit log could not be stored"
                    );
                }
            }
            let row = if stored.is_ok() { "written" } else { "lost" };
            metrics::counter!("homolog_audit_rows_total", "row" => row).increment(events.len() as u64);
            for done in waiting {
                let _ = done.send(stored.is_ok());
            }
        }
    }

    /// Returns when nothing waits to be stored.
    pub async fn settled(&self) {
        loop {
            let idle = self.idle.notified();
            let mut idle = std::pin::pin!(idle);
            idle.as_mut().enable();
            if !self.queue.lock().is_writing {
                return;
            }
            idle.await;
        }
    }
}

impl Queue {
    /// Whether one more request of nobody in particular is recorded.
    fn admits_anonymous(&mut self) -> bool {
        let now = Instant::now();
        let (began, n) = self
            .anonymous
            .filter(|(began, _)| now.duration_since(*began) < ANONYMOUS_WINDOW)
            .map_or((now, 0), |(began, n)| (began, n));
        self.anonymous = Some((began, n.saturating_add(1)));
        n < MAX_ANONYMOUS
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn log(n: u64) -> Vec<AuditRow> {
        let mut last = AuditHead::start();
        let row = |position| {
            let mut row = AuditRow {
                position,
                at: "2026-11-22T08:00:00.125Z".to_owned(),
                tenant: Some("clinic-a".to_owned()),
                key_id: None,
                action: "submit_job".to_owned(),
                resource: Some(format!("jobs/{position}")),
                address: Some("192.0.2.7".to_owned()),
                status: Some(202),
                hash: String::new(),
            };
            row.hash = row.hash_after(&last.hash);
            last = AuditHead { position, hash: row.hash.clone() };
            row
        };
        (1..=n).map(row).collect()
    }

    fn verified(rows: &[AuditRow], expected: &[AuditHead]) -> Result<AuditHead, AuditFault> {
        let mut verifier = Verifier::default();
        expected.iter().cloned().for_each(|head| verifier.expect(head));
        rows.iter().try_for_each(|row| verifier.add(row))?;
        verifier.end()
    }

    #[test]
    fn the_first_row_that_was_changed_or_removed_is_named() {
        let rows = log(5);
        let head = AuditHead { position: 5, hash: rows[4].hash.clone() };
        assert_eq!(verified(&rows, &[]), Ok(head.clone()));
        assert_eq!(verified(&[], &[]), Ok(AuditHead::start()));
        assert_eq!(AuditHead::parse(&head.to_string()), Some(head.clone()));

        let changes: [fn(&mut AuditRow); 9] = [
            |row| row.at.replace_range(..4, "2025"),
            |row| row.tenant = Some("clinic-b".to_owned()),
            |row| row.tenant = None,
            |row| row.key_id = Some("3f9a1c07be52".to_owned()),
            |row| row.action = "delete_job".to_owned(),
            |row| row.resource = None,
            |row| (row.address, row.resource) = (row.resource.clone(), row.address.clone()),
            |row| row.status = None,
            |row| row.hash.replace_range(..1, if row.hash.starts_with('0') { "1" } else { "0" }),
        ];
        for change in changes {
            let mut changed = rows.clone();
            change(&mut changed[2]);
            assert_eq!(verified(&changed, &[]), Err(AuditFault::Changed(3)), "{:?}", changed[2]);
        }
        let without = |removed: usize| [&rows[..removed], &rows[removed + 1..]].concat();
        assert_eq!(verified(&without(0), &[]), Err(AuditFault::Missing(1)));
        assert_eq!(verified(&without(2), &[]), Err(AuditFault::Missing(3)));
        let mut twice = rows.clone();
        twice.insert(3, rows[2].clone());
        assert_eq!(verified(&twice, &[]), Err(AuditFault::Changed(3)));
        // Renumbered after a removal.
        let mut closed = without(2);
        closed[2].position = 3;
        closed[3].position = 4;
        assert_eq!(verified(&closed, &[]), Err(AuditFault::Changed(3)));
    }

    #[test]
    fn a_missing_end_and_a_rewritten_log_are_found_with_what_was_noted() {
        let rows = log(5);
        let noted = AuditHead { position: 4, hash: rows[3].hash.clone() };
        assert_eq!(verified(&rows[..3], &[]).unwrap().position, 3, "nothing is missed without a note");
        assert_eq!(verified(&rows[..3], std::slice::from_ref(&noted)), Err(AuditFault::Truncated(4, 4)));
        let mut rewritten = rows;
        let mut last = AuditHead::start();
        for row in &mut rewritten {
            row.tenant = Some("clinic-b".to_owned());
            row.hash = row.hash_after(&last.hash);
            last = AuditHead { position: row.position, hash: row.hash.clone() };
        }
        assert!(verified(&rewritten, &[]).is_ok());
        assert_eq!(verified(&rewritten, &[noted]), Err(AuditFault::Rewritten(4)));
    }

    #[test]
    fn a_pruned_log_begins_where_one_of_its_rows_says() {
        let mut rows = log(5);
        let anchor = AuditHead { position: 3, hash: rows[2].hash.clone() };
        let kept = |rows: &[AuditRow], anchor: &AuditHead| {
            let mut verifier = Verifier::after(anchor.clone());
            rows[3..].iter().try_for_each(|row| verifier.add(row))?;
            verifier.end()
        };
        assert_eq!(kept(&rows, &anchor), Err(AuditFault::Unrecorded(3)));
        let AuditEvent { action, resource, .. } = AuditEvent::pruned(&anchor);
        (rows[4].action, rows[4].resource) = (action, resource);
        rows[4].hash = rows[4].hash_after(&rows[3].hash);
        assert_eq!(kept(&rows, &anchor).unwrap().position, 5);
        assert_eq!(kept(&rows, &AuditHead { position: 3, hash: "0".repeat(64) }), Err(AuditFault::Changed(4)));
        assert_eq!(verified(&rows, &[]).unwrap().position, 5, "nothing was removed yet");
    }

    #[test]
    fn a_hash_can_be_checked_with_other_tools() {
        // printf '%s\n1\n2026-11-22T08:00:00.125Z\nclinic-a\n\nsubmit_job\njobs/1\n192.0.2.7\n202' "$(printf '0%.0s' {1..64})" | sha256sum
        assert_eq!(log(1)[0].hash, "6b90cd5f4c554d776022ecee3d9ef109a3ba4ee8fd4434ae0af0734af60151b4");
    }

    struct Slow(Mutex<Vec<usize>>);

    #[async_trait]
    impl AuditStore for Slow {
        async fn append_audit(&self, events: &[AuditEvent]) -> Result<(), JobError> {
            tokio::time::sleep(Duration::from_millis(20)).await;
            self.0.lock().push(events.len());
            if events.iter().any(|event| event.action == "fail") { Err(JobError::StorageFull) } else { Ok(()) }
        }

        async fn list_audit(&self, _: u64, _: u32) -> Result<Vec<AuditRow>, JobError> {
            Ok(Vec::new())
        }

        async fn audit_head(&self) -> Result<AuditHead, JobError> {
            Ok(AuditHead::start())
        }
    }

    fn event(action: &str, tenant: Option<Tenant>) -> AuditEvent {
        AuditEvent { tenant, key_id: None, action: action.to_owned(), resource: None, address: None, status: None }
    }

    #[tokio::test]
    async fn requests_that_end_together_share_a_transaction() {
        let store = Arc::new(Slow(Mutex::default()));
        let recorder = Recorder::new(Arc::clone(&store) as Arc<dyn AuditStore>);
        let tenant = || Some(Tenant::default());
        assert!(recorder.record(event("one", tenant())).await);
        let all: Vec<_> = (0..50).map(|_| recorder.record(event("many", tenant()))).collect();
        drop(recorder.record(event("not waited for", tenant())));
        for stored in all {
            assert!(stored.await);
        }
        recorder.settled().await;
        let sizes = store.0.lock().clone();
        assert_eq!(sizes.iter().sum::<usize>(), 52);
        assert!(sizes.len() <= 4, "{sizes:?}");
        assert!(!recorder.record(event("fail", tenant())).await, "the failure is reported");
        assert!(recorder.record(event("next", tenant())).await);
    }

    #[tokio::test]
    async fn requests_of_nobody_are_recorded_up_to_a_rate() {
        let store = Arc::new(Slow(Mutex::default()));
        let recorder = Recorder::new(Arc::clone(&store) as Arc<dyn AuditStore>);
        for _ in 0..200 {
            drop(recorder.record(event("refused", None)));
        }
        drop(recorder.record(event("known", Some(Tenant::default()))));
        recorder.settled().await;
        assert_eq!(store.0.lock().iter().sum::<usize>(), 61);
    }
}
