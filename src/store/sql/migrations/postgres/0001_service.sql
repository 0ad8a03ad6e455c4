-- Times are milliseconds since 1970 by the database's own clock. Names compare byte by byte, as in SQLite.

CREATE TABLE jobs (
    id               TEXT COLLATE "C" PRIMARY KEY,
    tenant           TEXT COLLATE "C" NOT NULL,
    state            TEXT COLLATE "C" NOT NULL
        CHECK (state IN ('queued', 'running', 'succeeded', 'failed', 'cancelled', 'expired', 'dead')),
    method           TEXT COLLATE "C" NOT NULL,
    method_version   TEXT COLLATE "C" NOT NULL,
    parameters       TEXT COLLATE "C" NOT NULL,
    source           TEXT COLLATE "C" NOT NULL,
    target           TEXT COLLATE "C" NOT NULL,
    priority         BIGINT NOT NULL,
    labels           TEXT COLLATE "C" NOT NULL,
    external_ref     TEXT COLLATE "C",
    attempt          BIGINT NOT NULL DEFAULT 0,
    max_attempts     BIGINT NOT NULL,
    crashes          BIGINT NOT NULL DEFAULT 0,
    cancel_requested BOOLEAN NOT NULL DEFAULT FALSE,
    created_at       BIGINT NOT NULL,
    scheduled_at     BIGINT NOT NULL,
    started_at       BIGINT,
    finished_at      BIGINT,
    expires_at       BIGINT,
    deadline_at      BIGINT,
    lease_epoch      BIGINT NOT NULL DEFAULT 0,
    worker_id        TEXT COLLATE "C",
    lease_expires_at BIGINT,
    error            TEXT COLLATE "C",
    max_run_ms       BIGINT,
    run_deadline_at  BIGINT,
    retry_of         TEXT COLLATE "C",
    batch_id         TEXT COLLATE "C",
    cached           BOOLEAN NOT NULL DEFAULT FALSE,
    cache_key        TEXT COLLATE "C",
    purged_at        BIGINT,
    traceparent      TEXT COLLATE "C"
);

CREATE INDEX jobs_queue ON jobs (priority DESC, created_at, id) WHERE state = 'queued';

CREATE INDEX jobs_leases ON jobs (lease_expires_at) WHERE state = 'running';

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

CREATE TABLE job_progress (
    job_id        TEXT COLLATE "C" PRIMARY KEY REFERENCES jobs (id) ON DELETE CASCADE,
    fraction      DOUBLE PRECISION NOT NULL,
    phase         TEXT COLLATE "C",
    iteration     BIGINT,
    message       TEXT COLLATE "C",
    energy_latest DOUBLE PRECISION
);

CREATE TABLE trace_chunks (
    job_id      TEXT COLLATE "C" NOT NULL REFERENCES jobs (id) ON DELETE CASCADE,
    first_seq   BIGINT NOT NULL,
    last_seq    BIGINT NOT NULL,
    lease_epoch BIGINT NOT NULL,
    points      TEXT COLLATE "C" NOT NULL,
    PRIMARY KEY (job_id, first_seq)
);

CREATE TABLE job_artifacts (
    job_id  TEXT COLLATE "C" NOT NULL REFERENCES jobs (id) ON DELETE CASCADE,
    kind    TEXT COLLATE "C" NOT NULL,
    tenant  TEXT COLLATE "C" NOT NULL,
    path    TEXT COLLATE "C" NOT NULL,
    hash    TEXT COLLATE "C" NOT NULL,
    n_bytes BIGINT NOT NULL,
    PRIMARY KEY (job_id, kind)
);

CREATE INDEX job_artifacts_by_path ON job_artifacts (tenant, path);

CREATE TABLE job_labels (
    job_id     TEXT COLLATE "C" NOT NULL REFERENCES jobs (id) ON DELETE CASCADE,
    tenant     TEXT COLLATE "C" NOT NULL,
    name       TEXT COLLATE "C" NOT NULL,
    value      TEXT COLLATE "C" NOT NULL,
    -- The job's, so that the index below has the jobs of a label in the order of lists.
    created_at BIGINT NOT NULL,
    PRIMARY KEY (job_id, name)
);

CREATE INDEX job_labels_by_value ON job_labels (tenant, name, value, created_at, job_id);

CREATE TABLE blobs (
    tenant         TEXT COLLATE "C" NOT NULL,
    path           TEXT COLLATE "C" NOT NULL,
    -- May have lost its last reference.
    is_candidate   BOOLEAN NOT NULL DEFAULT FALSE,
    -- Is being removed since then: nobody may begin to refer to it.
    removing_since BIGINT,
    PRIMARY KEY (tenant, path)
);

CREATE INDEX blob_candidates_by_path ON blobs (tenant, path) WHERE is_candidate;

CREATE TABLE blob_holds (
    holder     TEXT COLLATE "C" NOT NULL,
    tenant     TEXT COLLATE "C" NOT NULL,
    path       TEXT COLLATE "C" NOT NULL,
    expires_at BIGINT NOT NULL,
    PRIMARY KEY (holder, tenant, path)
);

CREATE INDEX blob_holds_by_path ON blob_holds (tenant, path);

CREATE INDEX blob_holds_by_end ON blob_holds (expires_at);

CREATE TABLE meshes (
    tenant     TEXT COLLATE "C" NOT NULL,
    hash       TEXT COLLATE "C" NOT NULL,
    path       TEXT COLLATE "C" NOT NULL,
    n_bytes    BIGINT NOT NULL,
    name_hint  TEXT COLLATE "C",
    created_at BIGINT NOT NULL,
    PRIMARY KEY (tenant, hash)
);

CREATE INDEX meshes_by_path ON meshes (tenant, path);

CREATE INDEX meshes_by_time ON meshes (tenant, created_at, hash);

CREATE TABLE mesh_checks (
    tenant     TEXT COLLATE "C" NOT NULL,
    hash       TEXT COLLATE "C" NOT NULL,
    input_key  TEXT COLLATE "C" NOT NULL,
    outcome    TEXT COLLATE "C" NOT NULL,
    PRIMARY KEY (tenant, hash, input_key),
    FOREIGN KEY (tenant, hash) REFERENCES meshes (tenant, hash) ON DELETE CASCADE
);

CREATE TABLE batches (
    id           TEXT COLLATE "C" PRIMARY KEY,
    tenant       TEXT COLLATE "C" NOT NULL,
    n_jobs       BIGINT NOT NULL,
    labels       TEXT COLLATE "C" NOT NULL,
    external_ref TEXT COLLATE "C",
    created_at   BIGINT NOT NULL
);

CREATE INDEX batches_by_time ON batches (tenant, created_at, id);

CREATE TABLE idempotency_keys (
    tenant      TEXT COLLATE "C" NOT NULL,
    name        TEXT COLLATE "C" NOT NULL,
    fingerprint TEXT COLLATE "C" NOT NULL,
    -- Who works on it; another's writes change nothing.
    token       TEXT COLLATE "C" NOT NULL,
    -- What was made: 'job:<id>' or 'batch:<id>'; absent while in progress.
    made        TEXT COLLATE "C",
    expires_at  BIGINT NOT NULL,
    PRIMARY KEY (tenant, name)
);

CREATE INDEX idempotency_keys_by_end ON idempotency_keys (expires_at);

CREATE INDEX idempotency_keys_by_made ON idempotency_keys (made);

CREATE TABLE api_keys (
    id         TEXT COLLATE "C" PRIMARY KEY,
    tenant     TEXT COLLATE "C" NOT NULL,
    name       TEXT COLLATE "C" NOT NULL,
    -- BLAKE3 of the secret part, which is random and long: no slow hash is needed.
    hash       TEXT COLLATE "C" NOT NULL,
    scopes     TEXT COLLATE "C" NOT NULL,
    created_at BIGINT NOT NULL,
    expires_at BIGINT,
    revoked_at BIGINT
);

CREATE TABLE changes (
    id       BIGINT GENERATED ALWAYS AS IDENTITY PRIMARY KEY,
    seq      BIGINT UNIQUE,
    tenant   TEXT COLLATE "C" NOT NULL,
    job_id   TEXT COLLATE "C" NOT NULL,
    batch_id TEXT COLLATE "C",
    state    TEXT COLLATE "C" NOT NULL,
    at       BIGINT NOT NULL
);

CREATE INDEX changes_unnumbered ON changes (id) WHERE seq IS NULL;

CREATE INDEX changes_of_tenant ON changes (tenant, seq);

CREATE INDEX changes_by_time ON changes (at);
CREATE INDEX changes_by_job ON changes (job_id);

CREATE TABLE counters (
    name  TEXT COLLATE "C" PRIMARY KEY,
    value BIGINT NOT NULL
);

CREATE TABLE webhooks (
    id          TEXT COLLATE "C" PRIMARY KEY,
    tenant      TEXT COLLATE "C" NOT NULL,
    url         TEXT COLLATE "C" NOT NULL,
    -- States that are told, a JSON list; empty for all.
    states      TEXT COLLATE "C" NOT NULL,
    secret      TEXT COLLATE "C" NOT NULL,
    is_enabled  BOOLEAN NOT NULL DEFAULT TRUE,
    disabled_because TEXT COLLATE "C",
    created_at  BIGINT NOT NULL
);

CREATE INDEX webhooks_of_tenant ON webhooks (tenant, created_at, id);

CREATE TABLE webhook_deliveries (
    id           TEXT COLLATE "C" PRIMARY KEY,
    webhook_id   TEXT COLLATE "C" NOT NULL REFERENCES webhooks (id) ON DELETE CASCADE,
    tenant       TEXT COLLATE "C" NOT NULL,
    event        TEXT COLLATE "C" NOT NULL,
    payload      TEXT COLLATE "C" NOT NULL,
    state        TEXT COLLATE "C" NOT NULL CHECK (state IN ('pending', 'delivered', 'failed')),
    attempts     BIGINT NOT NULL DEFAULT 0,
    next_at      BIGINT NOT NULL,
    status       BIGINT,
    error        TEXT COLLATE "C",
    created_at   BIGINT NOT NULL,
    ended_at     BIGINT
);

CREATE INDEX webhook_deliveries_due ON webhook_deliveries (next_at) WHERE state = 'pending';

CREATE INDEX webhook_deliveries_of_webhook ON webhook_deliveries (webhook_id, created_at, id);

CREATE INDEX webhook_deliveries_by_time ON webhook_deliveries (created_at);

INSERT INTO counters (name, value) VALUES ('changes', 0), ('webhooks', 0);

CREATE FUNCTION note_change() RETURNS TRIGGER LANGUAGE plpgsql AS $$
BEGIN
    INSERT INTO changes (tenant, job_id, batch_id, state, at)
    VALUES (NEW.tenant, NEW.id, NEW.batch_id, NEW.state, CAST(EXTRACT(EPOCH FROM clock_timestamp()) * 1000 AS BIGINT));
    RETURN NULL;
END
$$;

CREATE TRIGGER job_inserted AFTER INSERT ON jobs FOR EACH ROW EXECUTE FUNCTION note_change();

CREATE TRIGGER job_changed AFTER UPDATE OF state ON jobs
FOR EACH ROW WHEN (OLD.state <> NEW.state) EXECUTE FUNCTION note_change();

-- A job with what is read beside it. The clock stands still during a statement: with one that does not, PostgreSQL
-- would read all of the view before it takes a page of it.
CREATE VIEW job_records AS
SELECT
    jobs.*,
    job_progress.fraction,
    job_progress.phase,
    job_progress.iteration,
    job_progress.message,
    job_progress.energy_latest,
    CAST(EXTRACT(EPOCH FROM statement_timestamp()) * 1000 AS BIGINT) AS read_at
FROM jobs
LEFT JOIN job_progress ON job_progress.job_id = jobs.id;
