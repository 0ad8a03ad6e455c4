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
    error            TEXT
) STRICT;

CREATE INDEX jobs_queue ON jobs (priority DESC, created_at, id) WHERE state = 'queued';
CREATE INDEX jobs_leases ON jobs (lease_expires_at) WHERE state = 'running';
CREATE INDEX jobs_by_time ON jobs (tenant, created_at, id);

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
    PRIMARY KEY (job_id, kind)
) STRICT, WITHOUT ROWID;

CREATE INDEX job_artifacts_by_hash ON job_artifacts (tenant, hash);

-- Blobs that are being written and not referred to yet.
CREATE TABLE blob_holds (
    holder     TEXT NOT NULL,
    tenant     TEXT NOT NULL,
    hash       TEXT NOT NULL,
    expires_at INTEGER NOT NULL,
    PRIMARY KEY (holder, tenant, hash)
) STRICT, WITHOUT ROWID;

CREATE INDEX blob_holds_by_hash ON blob_holds (tenant, hash);

-- Blobs that may have lost their last reference.
CREATE TABLE blob_candidates (
    tenant TEXT NOT NULL,
    hash   TEXT NOT NULL,
    PRIMARY KEY (tenant, hash)
) STRICT, WITHOUT ROWID;

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
