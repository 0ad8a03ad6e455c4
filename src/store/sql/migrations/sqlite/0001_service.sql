-- Times are milliseconds since 1970 by the database's own clock.
CREATE TABLE jobs (
    id               TEXT PRIMARY KEY,
    tenant           TEXT NOT NULL,
    state            TEXT NOT NULL
        CHECK (state IN ('queued', 'running', 'succeeded', 'failed', 'cancelled', 'expired', 'dead')),
    method           TEXT NOT NULL,
    method_version   TEXT NOT NULL,
    parameters       TEXT NOT NULL,
    source           TEXT NOT NULL,
    target           TEXT NOT NULL,
    priority         INTEGER NOT NULL,
    labels           TEXT NOT NULL,
    external_ref     TEXT,
    attempt          INTEGER NOT NULL DEFAULT 0,
    max_attempts     INTEGER NOT NULL,
    crashes          INTEGER NOT NULL DEFAULT 0,
    cancel_requested INTEGER NOT NULL DEFAULT 0,
    created_at       INTEGER NOT NULL,
    scheduled_at     INTEGER NOT NULL,
    started_at       INTEGER,
    finished_at      INTEGER,
    expires_at       INTEGER,
    deadline_at      INTEGER,
    lease_epoch      INTEGER NOT NULL DEFAULT 0,
    worker_id        TEXT,
    lease_expires_at INTEGER,
    error            TEXT,
    max_run_ms       INTEGER,
    run_deadline_at  INTEGER,
    retry_of         TEXT,
    batch_id         TEXT,
    cached           INTEGER NOT NULL DEFAULT 0,
    cache_key        TEXT,
    purged_at        INTEGER,
    traceparent      TEXT,
    -- Whether the answer can be relied on, as JSON.
    verdict          TEXT,
    study_id         TEXT,
    -- The key of the record that the job makes for its study.
    study_task       TEXT,
    -- The place in the queue: in order of arrival, whatever the clock says.
    place            INTEGER
) STRICT;

CREATE INDEX jobs_queue ON jobs (priority DESC, created_at, id) WHERE state = 'queued';
CREATE INDEX jobs_leases ON jobs (lease_expires_at) WHERE state = 'running';
CREATE INDEX jobs_by_time ON jobs (tenant, created_at, id);
CREATE INDEX jobs_by_state ON jobs (tenant, state, created_at, id);
CREATE INDEX jobs_by_reference ON jobs (tenant, external_ref, created_at, id) WHERE external_ref IS NOT NULL;
CREATE INDEX jobs_by_study ON jobs (study_id, state) WHERE study_id IS NOT NULL;
CREATE INDEX jobs_by_batch ON jobs (batch_id, state) WHERE batch_id IS NOT NULL;
CREATE INDEX jobs_by_cache_key ON jobs (tenant, cache_key) WHERE state = 'succeeded' AND purged_at IS NULL;
CREATE INDEX jobs_run_deadlines ON jobs (run_deadline_at) WHERE state = 'running';
CREATE INDEX jobs_queue_deadlines ON jobs (deadline_at) WHERE state = 'queued' AND deadline_at IS NOT NULL;
CREATE INDEX jobs_queue_of_tenant ON jobs (tenant, priority DESC, place) WHERE state = 'queued';
CREATE INDEX jobs_to_purge ON jobs (expires_at) WHERE purged_at IS NULL AND expires_at IS NOT NULL;
CREATE INDEX jobs_finished ON jobs (finished_at) WHERE finished_at IS NOT NULL;

CREATE TRIGGER job_placed AFTER INSERT ON jobs
BEGIN
    UPDATE jobs SET place = NEW.rowid WHERE id = NEW.id;
END;

-- Apart from the job's row, because it changes several times a second.
CREATE TABLE job_progress (
    job_id        TEXT PRIMARY KEY REFERENCES jobs (id) ON DELETE CASCADE,
    fraction      REAL NOT NULL,
    phase         TEXT,
    iteration     INTEGER,
    message       TEXT,
    energy_latest REAL
) STRICT;

CREATE TABLE trace_chunks (
    job_id      TEXT NOT NULL REFERENCES jobs (id) ON DELETE CASCADE,
    first_seq   INTEGER NOT NULL,
    last_seq    INTEGER NOT NULL,
    lease_epoch INTEGER NOT NULL,
    points      TEXT NOT NULL,
    PRIMARY KEY (job_id, first_seq)
) STRICT, WITHOUT ROWID;

CREATE TABLE job_artifacts (
    job_id  TEXT NOT NULL REFERENCES jobs (id) ON DELETE CASCADE,
    kind    TEXT NOT NULL,
    tenant  TEXT NOT NULL,
    hash    TEXT NOT NULL,
    n_bytes INTEGER NOT NULL,
    path    TEXT NOT NULL,
    PRIMARY KEY (job_id, kind)
) STRICT, WITHOUT ROWID;

CREATE INDEX job_artifacts_by_path ON job_artifacts (tenant, path);

CREATE TABLE job_labels (
    job_id     TEXT NOT NULL REFERENCES jobs (id) ON DELETE CASCADE,
    tenant     TEXT NOT NULL,
    name       TEXT NOT NULL,
    value      TEXT NOT NULL,
    -- The job's, so that the index below has the jobs of a label in the order of lists.
    created_at INTEGER NOT NULL,
    PRIMARY KEY (job_id, name)
) STRICT, WITHOUT ROWID;

CREATE INDEX job_labels_by_value ON job_labels (tenant, name, value, created_at, job_id);

-- Blobs by their path under the tenant: inputs by content, results by the lease that made them.
CREATE TABLE blobs (
    tenant         TEXT NOT NULL,
    path           TEXT NOT NULL,
    -- May have lost its last reference.
    is_candidate   INTEGER NOT NULL DEFAULT 0,
    -- Is being removed since then: nobody may begin to refer to it.
    removing_since INTEGER,
    PRIMARY KEY (tenant, path)
) STRICT, WITHOUT ROWID;

CREATE INDEX blob_candidates_by_path ON blobs (tenant, path) WHERE is_candidate;

-- Blobs that are being written and not referred to yet.
CREATE TABLE blob_holds (
    holder     TEXT NOT NULL,
    tenant     TEXT NOT NULL,
    path       TEXT NOT NULL,
    expires_at INTEGER NOT NULL,
    PRIMARY KEY (holder, tenant, path)
) STRICT, WITHOUT ROWID;

CREATE INDEX blob_holds_by_path ON blob_holds (tenant, path);
CREATE INDEX blob_holds_by_end ON blob_holds (expires_at);

CREATE TABLE meshes (
    tenant     TEXT NOT NULL,
    hash       TEXT NOT NULL,
    path       TEXT NOT NULL,
    n_bytes    INTEGER NOT NULL,
    name_hint  TEXT,
    created_at INTEGER NOT NULL,
    PRIMARY KEY (tenant, hash)
) STRICT, WITHOUT ROWID;

CREATE INDEX meshes_by_path ON meshes (tenant, path);
CREATE INDEX meshes_by_time ON meshes (tenant, created_at, hash);

-- What checking a mesh found, for each way in which inputs can be prepared.
CREATE TABLE mesh_checks (
    tenant     TEXT NOT NULL,
    hash       TEXT NOT NULL,
    input_key  TEXT NOT NULL,
    outcome    TEXT NOT NULL,
    PRIMARY KEY (tenant, hash, input_key),
    FOREIGN KEY (tenant, hash) REFERENCES meshes (tenant, hash) ON DELETE CASCADE
) STRICT, WITHOUT ROWID;

CREATE TABLE batches (
    id           TEXT PRIMARY KEY,
    tenant       TEXT NOT NULL,
    n_jobs       INTEGER NOT NULL,
    labels       TEXT NOT NULL,
    external_ref TEXT,
    created_at   INTEGER NOT NULL
) STRICT;

CREATE INDEX batches_by_time ON batches (tenant, created_at, id);

CREATE TABLE idempotency_keys (
    tenant      TEXT NOT NULL,
    name        TEXT NOT NULL,
    fingerprint TEXT NOT NULL,
    -- Who works on it; another's writes change nothing.
    token       TEXT NOT NULL,
    -- What was made: 'job:<id>' or 'batch:<id>'; absent while in progress.
    made        TEXT,
    expires_at  INTEGER NOT NULL,
    PRIMARY KEY (tenant, name)
) STRICT, WITHOUT ROWID;

CREATE INDEX idempotency_keys_by_end ON idempotency_keys (expires_at);
CREATE INDEX idempotency_keys_by_made ON idempotency_keys (made);

CREATE TABLE api_keys (
    id         TEXT PRIMARY KEY,
    tenant     TEXT NOT NULL,
    name       TEXT NOT NULL,
    -- BLAKE3 of the secret part, which is random and long: no slow hash is needed.
    hash       TEXT NOT NULL,
    scopes     TEXT NOT NULL,
    created_at INTEGER NOT NULL,
    expires_at INTEGER,
    revoked_at INTEGER
) STRICT;

-- Every change of a job's state, by the triggers below. `seq` counts the changes of all tenants in the order of commits and
-- is given after the commit; `number` counts those of one tenant, which its clients see.
CREATE TABLE changes (
    id       INTEGER PRIMARY KEY AUTOINCREMENT,
    seq      INTEGER UNIQUE,
    tenant   TEXT NOT NULL,
    job_id   TEXT NOT NULL,
    batch_id TEXT,
    state    TEXT NOT NULL,
    at       INTEGER NOT NULL,
    number   INTEGER
) STRICT;

CREATE INDEX changes_by_number ON changes (tenant, number);
CREATE INDEX changes_without_number ON changes (id) WHERE number IS NULL;
CREATE INDEX changes_unnumbered ON changes (id) WHERE seq IS NULL;
CREATE INDEX changes_of_tenant ON changes (tenant, seq);
CREATE INDEX changes_by_time ON changes (at);
CREATE INDEX changes_by_job ON changes (job_id);

CREATE TABLE counters (
    name  TEXT PRIMARY KEY,
    value INTEGER NOT NULL
) STRICT;

INSERT INTO counters (name, value) VALUES ('changes', 0), ('webhooks', 0), ('changes before', 0);

-- Jobs that plan and model a study are hidden, and so are their changes.
CREATE TRIGGER job_inserted AFTER INSERT ON jobs WHEN NEW.method <> 'study'
BEGIN
    INSERT INTO changes (tenant, job_id, batch_id, state, at)
    VALUES (NEW.tenant, NEW.id, NEW.batch_id, NEW.state, CAST(unixepoch('subsec') * 1000 AS INTEGER));
END;

CREATE TRIGGER job_changed AFTER UPDATE OF state ON jobs WHEN OLD.state <> NEW.state AND NEW.method <> 'study'
BEGIN
    INSERT INTO changes (tenant, job_id, batch_id, state, at)
    VALUES (NEW.tenant, NEW.id, NEW.batch_id, NEW.state, CAST(unixepoch('subsec') * 1000 AS INTEGER));
END;

CREATE TABLE webhooks (
    id          TEXT PRIMARY KEY,
    tenant      TEXT NOT NULL,
    url         TEXT NOT NULL,
    -- States that are told, a JSON list; empty for all.
    states      TEXT NOT NULL,
    secret      TEXT NOT NULL,
    is_enabled  INTEGER NOT NULL DEFAULT 1,
    disabled_because TEXT,
    created_at  INTEGER NOT NULL,
    -- No attempt before `next_at`: another process is at it until `busy_until`, or the receiver has failed `failures` times.
    next_at     INTEGER NOT NULL DEFAULT 0,
    busy_until  INTEGER NOT NULL DEFAULT 0,
    served_at   INTEGER NOT NULL DEFAULT 0,
    failures    INTEGER NOT NULL DEFAULT 0,
    -- How long the wait until `next_at` is, so that a clock that is set back makes no wait longer.
    wait_ms     INTEGER NOT NULL DEFAULT 3600000
) STRICT;

CREATE INDEX webhooks_of_tenant ON webhooks (tenant, created_at, id);

CREATE TABLE webhook_deliveries (
    id           TEXT PRIMARY KEY,
    webhook_id   TEXT NOT NULL REFERENCES webhooks (id) ON DELETE CASCADE,
    tenant       TEXT NOT NULL,
    event        TEXT NOT NULL,
    payload      TEXT NOT NULL,
    state        TEXT NOT NULL CHECK (state IN ('pending', 'delivered', 'failed')),
    attempts     INTEGER NOT NULL DEFAULT 0,
    next_at      INTEGER NOT NULL,
    status       INTEGER,
    error        TEXT,
    created_at   INTEGER NOT NULL,
    ended_at     INTEGER,
    traceparent  TEXT,
    -- As `webhooks.wait_ms`.
    wait_ms      INTEGER NOT NULL DEFAULT 43200000
) STRICT;

CREATE INDEX webhook_deliveries_due ON webhook_deliveries (next_at) WHERE state = 'pending';
CREATE INDEX webhook_deliveries_waiting ON webhook_deliveries (webhook_id, next_at) WHERE state = 'pending';
CREATE INDEX webhook_deliveries_of_webhook ON webhook_deliveries (webhook_id, created_at, id);
CREATE INDEX webhook_deliveries_by_time ON webhook_deliveries (created_at);

-- A job with what is read beside it.
CREATE VIEW job_records AS
SELECT
    jobs.*,
    job_progress.fraction,
    job_progress.phase,
    job_progress.iteration,
    job_progress.message,
    job_progress.energy_latest,
    CAST(unixepoch('subsec') * 1000 AS INTEGER) AS read_at
FROM jobs
LEFT JOIN job_progress ON job_progress.job_id = jobs.id;

-- Each claim of a job takes a turn: tenants that wait are served in the order of `due`, and a turn adds to it the less the
-- greater the tenant's weight. `started` is where the tenant's last turn began; the greatest of all is the present.
CREATE TABLE turns (
    tenant  TEXT PRIMARY KEY,
    started INTEGER NOT NULL,
    due     INTEGER NOT NULL
) STRICT, WITHOUT ROWID;

-- The audit log: who did what, when, from where, with which outcome. Ids only. `hash` covers the row and the hash before it.
CREATE TABLE audit (
    position INTEGER PRIMARY KEY,
    at       INTEGER NOT NULL,
    tenant   TEXT,
    key_id   TEXT,
    action   TEXT NOT NULL,
    resource TEXT,
    address  TEXT,
    status   INTEGER,
    hash     TEXT NOT NULL
) STRICT;

-- Its last row, so that a missing end is noticed.
CREATE TABLE audit_head (
    one      INTEGER PRIMARY KEY CHECK (one = 1),
    position INTEGER NOT NULL,
    hash     TEXT NOT NULL
) STRICT;
INSERT INTO audit_head (one, position, hash)
VALUES (1, 0, '0000000000000000000000000000000000000000000000000000000000000000');

CREATE TRIGGER audit_keeps_content BEFORE UPDATE ON audit
BEGIN SELECT RAISE(ABORT, 'the audit log is append-only'); END;
CREATE TRIGGER audit_grows BEFORE UPDATE ON audit_head WHEN NEW.position < OLD.position
BEGIN SELECT RAISE(ABORT, 'the audit log is append-only'); END;

-- Where the audit log begins: the position and hash of the last row that was pruned. Rows up to it may be removed.
CREATE TABLE audit_anchor (
    one      INTEGER PRIMARY KEY CHECK (one = 1),
    position INTEGER NOT NULL,
    hash     TEXT NOT NULL
) STRICT;
INSERT INTO audit_anchor (one, position, hash)
VALUES (1, 0, '0000000000000000000000000000000000000000000000000000000000000000');

CREATE TRIGGER audit_keeps_rows BEFORE DELETE ON audit
WHEN OLD.position > (SELECT position FROM audit_anchor)
BEGIN SELECT RAISE(ABORT, 'the audit log is append-only'); END;
CREATE TRIGGER audit_anchor_advances BEFORE UPDATE ON audit_anchor WHEN NEW.position < OLD.position
BEGIN SELECT RAISE(ABORT, 'the audit log is append-only'); END;
CREATE TRIGGER audit_anchor_stays BEFORE DELETE ON audit_anchor
BEGIN SELECT RAISE(ABORT, 'the audit log is append-only'); END;

-- The id of the key that encrypts blobs; no row if they are not encrypted.
CREATE TABLE encryption (
    one    INTEGER PRIMARY KEY CHECK (one = 1),
    key_id TEXT NOT NULL
) STRICT;

-- Short-lived permissions to read one resource, by the hash of the ticket.
CREATE TABLE tickets (
    hash       TEXT PRIMARY KEY,
    tenant     TEXT NOT NULL,
    key_id     TEXT,
    path       TEXT NOT NULL,
    expires_at INTEGER NOT NULL
) STRICT;
CREATE INDEX tickets_of_tenant ON tickets (tenant, expires_at);
CREATE INDEX tickets_by_time ON tickets (expires_at);

-- Studies: their state is here; who is in them, what is asked and what was found are blobs.
CREATE TABLE studies (
    id             TEXT PRIMARY KEY,
    tenant         TEXT NOT NULL,
    state          TEXT NOT NULL
        CHECK (state IN ('queued', 'matching', 'modelling', 'finished', 'failed', 'cancelled')),
    -- Raised by every change: what was decided from an earlier one is not stored.
    revision       INTEGER NOT NULL DEFAULT 0,
    method         TEXT NOT NULL,
    method_version TEXT NOT NULL,
    n_subjects     INTEGER NOT NULL,
    priority       INTEGER NOT NULL,
    labels         TEXT NOT NULL,
    external_ref   TEXT,
    max_attempts   INTEGER NOT NULL,
    max_queued     INTEGER NOT NULL,
    max_run_ms     INTEGER,
    traceparent    TEXT,
    -- The hidden job that plans or models.
    step_id        TEXT,
    round          INTEGER NOT NULL DEFAULT 0,
    n_before       INTEGER NOT NULL DEFAULT 0,
    n_tasks        INTEGER NOT NULL DEFAULT 0,
    n_made         INTEGER NOT NULL DEFAULT 0,
    error          TEXT,
    created_at     INTEGER NOT NULL,
    finished_at    INTEGER,
    expires_at     INTEGER,
    purged_at      INTEGER
) STRICT;

CREATE INDEX studies_by_time ON studies (tenant, created_at, id);
CREATE INDEX studies_active ON studies (created_at, id) WHERE state IN ('queued', 'matching', 'modelling');
CREATE INDEX studies_finished ON studies (finished_at) WHERE finished_at IS NOT NULL;

-- Blobs to which a study refers: its inputs, its definition, the records of its matches, its template and its results.
CREATE TABLE study_blobs (
    study_id TEXT NOT NULL REFERENCES studies (id) ON DELETE CASCADE,
    name     TEXT NOT NULL,
    tenant   TEXT NOT NULL,
    path     TEXT NOT NULL,
    n_bytes  INTEGER NOT NULL,
    PRIMARY KEY (study_id, name)
) STRICT, WITHOUT ROWID;

CREATE INDEX study_blobs_by_path ON study_blobs (tenant, path);

-- What the service remembers of itself: the last time it saw, and the mark of its blob store.
CREATE TABLE facts (
    name   TEXT PRIMARY KEY,
    number INTEGER,
    text   TEXT
) STRICT;

-- Processes that run jobs, at work or idle, each with when it was last seen; one that is not seen for a minute has ended.
CREATE TABLE workers (
    name TEXT NOT NULL PRIMARY KEY,
    seen_at INTEGER NOT NULL
);
