-- What a service for many users keeps besides jobs.

ALTER TABLE jobs ADD COLUMN max_run_ms INTEGER;
ALTER TABLE jobs ADD COLUMN run_deadline_at INTEGER;
ALTER TABLE jobs ADD COLUMN retry_of TEXT;
ALTER TABLE jobs ADD COLUMN batch_id TEXT;
ALTER TABLE jobs ADD COLUMN cached INTEGER NOT NULL DEFAULT 0;
ALTER TABLE jobs ADD COLUMN cache_key TEXT;
ALTER TABLE jobs ADD COLUMN purged_at INTEGER;
ALTER TABLE jobs ADD COLUMN traceparent TEXT;

DROP INDEX jobs_by_time;
CREATE INDEX jobs_by_time ON jobs (tenant, created_at, id);
CREATE INDEX jobs_by_state ON jobs (tenant, state, created_at, id);
CREATE INDEX jobs_by_reference ON jobs (tenant, external_ref, created_at, id) WHERE external_ref IS NOT NULL;
CREATE INDEX jobs_by_batch ON jobs (batch_id, state) WHERE batch_id IS NOT NULL;
CREATE INDEX jobs_by_cache_key ON jobs (tenant, cache_key) WHERE state = 'succeeded' AND purged_at IS NULL;
CREATE INDEX jobs_run_deadlines ON jobs (run_deadline_at) WHERE state = 'running';
CREATE INDEX jobs_queue_deadlines ON jobs (deadline_at) WHERE state = 'queued' AND deadline_at IS NOT NULL;
CREATE INDEX jobs_queue_of_tenant ON jobs (tenant) WHERE state = 'queued';
CREATE INDEX jobs_to_purge ON jobs (expires_at) WHERE purged_at IS NULL AND expires_at IS NOT NULL;
CREATE INDEX jobs_finished ON jobs (finished_at) WHERE finished_at IS NOT NULL;

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

INSERT INTO job_labels (job_id, tenant, name, value, created_at)
SELECT jobs.id, jobs.tenant, label.key, label.value, jobs.created_at FROM jobs, json_each(jobs.labels) AS label;

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

ALTER TABLE job_artifacts ADD COLUMN path TEXT NOT NULL DEFAULT '';
UPDATE job_artifacts SET path = substr(hash, 1, 2) || '/' || substr(hash, 3, 2) || '/' || hash;
DROP INDEX job_artifacts_by_hash;
CREATE INDEX job_artifacts_by_path ON job_artifacts (tenant, path);

INSERT INTO blobs (tenant, path) SELECT DISTINCT tenant, path FROM job_artifacts;
INSERT INTO blobs (tenant, path, is_candidate)
SELECT tenant, substr(hash, 1, 2) || '/' || substr(hash, 3, 2) || '/' || hash, 1 FROM blob_candidates WHERE TRUE
ON CONFLICT DO UPDATE SET is_candidate = 1;
INSERT INTO blobs (tenant, path, is_candidate)
SELECT tenant, substr(hash, 1, 2) || '/' || substr(hash, 3, 2) || '/' || hash, 1 FROM blob_holds WHERE TRUE
ON CONFLICT DO UPDATE SET is_candidate = 1;

DROP TABLE blob_candidates;
DROP TABLE blob_holds;

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

-- Every change of a job's state, by the triggers below; `seq` is given after the commit, in the order of commits.
CREATE TABLE changes (
    id       INTEGER PRIMARY KEY AUTOINCREMENT,
    seq      INTEGER UNIQUE,
    tenant   TEXT NOT NULL,
    job_id   TEXT NOT NULL,
    batch_id TEXT,
    state    TEXT NOT NULL,
    at       INTEGER NOT NULL
) STRICT;

CREATE INDEX changes_unnumbered ON changes (id) WHERE seq IS NULL;
CREATE INDEX changes_of_tenant ON changes (tenant, seq);
CREATE INDEX changes_by_time ON changes (at);
CREATE INDEX changes_by_job ON changes (job_id);

CREATE TABLE counters (
    name  TEXT PRIMARY KEY,
    value INTEGER NOT NULL
) STRICT;

INSERT INTO counters (name, value) VALUES ('changes', 0), ('webhooks', 0);

CREATE TRIGGER job_inserted AFTER INSERT ON jobs
BEGIN
    INSERT INTO changes (tenant, job_id, batch_id, state, at)
    VALUES (NEW.tenant, NEW.id, NEW.batch_id, NEW.state, CAST(unixepoch('subsec') * 1000 AS INTEGER));
END;

CREATE TRIGGER job_changed AFTER UPDATE OF state ON jobs WHEN OLD.state <> NEW.state
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
    created_at  INTEGER NOT NULL
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
    ended_at     INTEGER
) STRICT;

CREATE INDEX webhook_deliveries_due ON webhook_deliveries (next_at) WHERE state = 'pending';
CREATE INDEX webhook_deliveries_of_webhook ON webhook_deliveries (webhook_id, created_at, id);
CREATE INDEX webhook_deliveries_by_time ON webhook_deliveries (created_at);

DROP VIEW job_records;
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
