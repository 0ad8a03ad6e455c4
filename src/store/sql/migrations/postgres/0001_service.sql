-- Times are milliseconds since 1970 by the database's own clock. Names compare byte by byte, as in SQLite.

CREATE SEQUENCE job_places;

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
    traceparent      TEXT COLLATE "C",
    -- Whether the answer can be relied on, as JSON.
    verdict          TEXT,
    study_id         TEXT COLLATE "C",
    -- The key of the record that the job makes for its study.
    study_task       TEXT COLLATE "C",
    -- The place in the queue: in order of arrival, whatever the clock says.
    place            BIGINT DEFAULT nextval('job_places')
);

ALTER SEQUENCE job_places OWNED BY jobs.place;

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

-- Every change of a job's state, by the triggers below. `seq` counts the changes of all tenants in the order of commits and
-- is given after the commit; `number` counts those of one tenant, which its clients see.
CREATE TABLE changes (
    id       BIGINT GENERATED ALWAYS AS IDENTITY PRIMARY KEY,
    seq      BIGINT UNIQUE,
    tenant   TEXT COLLATE "C" NOT NULL,
    job_id   TEXT COLLATE "C" NOT NULL,
    batch_id TEXT COLLATE "C",
    state    TEXT COLLATE "C" NOT NULL,
    at       BIGINT NOT NULL,
    number   BIGINT
);

CREATE INDEX changes_by_number ON changes (tenant, number);

CREATE INDEX changes_without_number ON changes (id) WHERE number IS NULL;

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
    created_at  BIGINT NOT NULL,
    -- No attempt before `next_at`: another process is at it until `busy_until`, or the receiver has failed `failures` times.
    next_at     BIGINT NOT NULL DEFAULT 0,
    busy_until  BIGINT NOT NULL DEFAULT 0,
    served_at   BIGINT NOT NULL DEFAULT 0,
    failures    BIGINT NOT NULL DEFAULT 0,
    -- How long the wait until `next_at` is, so that a clock that is set back makes no wait longer.
    wait_ms     BIGINT NOT NULL DEFAULT 3600000
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
    ended_at     BIGINT,
    traceparent  TEXT COLLATE "C",
    -- As `webhooks.wait_ms`.
    wait_ms      BIGINT NOT NULL DEFAULT 43200000
);

CREATE INDEX webhook_deliveries_due ON webhook_deliveries (next_at) WHERE state = 'pending';

CREATE INDEX webhook_deliveries_waiting ON webhook_deliveries (webhook_id, next_at) WHERE state = 'pending';

CREATE INDEX webhook_deliveries_of_webhook ON webhook_deliveries (webhook_id, created_at, id);

CREATE INDEX webhook_deliveries_by_time ON webhook_deliveries (created_at);

INSERT INTO counters (name, value) VALUES ('changes', 0), ('webhooks', 0), ('changes before', 0);

CREATE FUNCTION note_change() RETURNS TRIGGER LANGUAGE plpgsql AS $$
BEGIN
    INSERT INTO changes (tenant, job_id, batch_id, state, at)
    VALUES (NEW.tenant, NEW.id, NEW.batch_id, NEW.state, CAST(EXTRACT(EPOCH FROM clock_timestamp()) * 1000 AS BIGINT));
    RETURN NULL;
END
$$;

-- Jobs that plan and model a study are hidden, and so are their changes.
CREATE TRIGGER job_inserted AFTER INSERT ON jobs
FOR EACH ROW WHEN (NEW.method <> 'study') EXECUTE FUNCTION note_change();

CREATE TRIGGER job_changed AFTER UPDATE OF state ON jobs
FOR EACH ROW WHEN (OLD.state <> NEW.state AND NEW.method <> 'study') EXECUTE FUNCTION note_change();

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

-- Each claim of a job takes a turn: tenants that wait are served in the order of `due`, and a turn adds to it the less the
-- greater the tenant's weight. `started` is where the tenant's last turn began; the greatest of all is the present.
CREATE TABLE turns (
    tenant  TEXT COLLATE "C" PRIMARY KEY,
    started BIGINT NOT NULL,
    due     BIGINT NOT NULL
);

-- The audit log: who did what, when, from where, with which outcome. Ids only. `hash` covers the row and the hash before it.
CREATE TABLE audit (
    position BIGINT PRIMARY KEY,
    at       BIGINT NOT NULL,
    tenant   TEXT,
    key_id   TEXT,
    action   TEXT NOT NULL,
    resource TEXT,
    address  TEXT,
    status   BIGINT,
    hash     TEXT NOT NULL
);

-- Its last row, so that a missing end is noticed.
CREATE TABLE audit_head (
    one      BIGINT PRIMARY KEY CHECK (one = 1),
    position BIGINT NOT NULL,
    hash     TEXT NOT NULL
);
INSERT INTO audit_head (one, position, hash)
VALUES (1, 0, '0000000000000000000000000000000000000000000000000000000000000000');

CREATE FUNCTION refuse_audit_change() RETURNS trigger LANGUAGE plpgsql AS
$$ BEGIN RAISE EXCEPTION 'the audit log is append-only'; END $$;
CREATE TRIGGER audit_keeps_all BEFORE TRUNCATE ON audit
FOR EACH STATEMENT EXECUTE FUNCTION refuse_audit_change();
CREATE TRIGGER audit_grows BEFORE UPDATE ON audit_head
FOR EACH ROW WHEN (NEW.position < OLD.position) EXECUTE FUNCTION refuse_audit_change();

-- Where the audit log begins: the position and hash of the last row that was pruned. Rows up to it may be removed.
CREATE TABLE audit_anchor (
    one      BIGINT PRIMARY KEY CHECK (one = 1),
    position BIGINT NOT NULL,
    hash     TEXT NOT NULL
);
INSERT INTO audit_anchor (one, position, hash)
VALUES (1, 0, '0000000000000000000000000000000000000000000000000000000000000000');

CREATE FUNCTION refuse_audit_removal() RETURNS trigger LANGUAGE plpgsql AS
$$ BEGIN
    IF OLD.position > (SELECT position FROM audit_anchor) THEN
        RAISE EXCEPTION 'the audit log is append-only';
    END IF;
    RETURN OLD;
END $$;
CREATE TRIGGER audit_keeps_rows BEFORE DELETE ON audit
FOR EACH ROW EXECUTE FUNCTION refuse_audit_removal();
CREATE TRIGGER audit_keeps_content BEFORE UPDATE ON audit
FOR EACH ROW EXECUTE FUNCTION refuse_audit_change();
CREATE TRIGGER audit_anchor_advances BEFORE UPDATE ON audit_anchor
FOR EACH ROW WHEN (NEW.position < OLD.position) EXECUTE FUNCTION refuse_audit_change();
CREATE TRIGGER audit_anchor_stays BEFORE DELETE ON audit_anchor
FOR EACH ROW EXECUTE FUNCTION refuse_audit_change();

-- The id of the key that encrypts blobs; no row if they are not encrypted.
CREATE TABLE encryption (
    one    BIGINT PRIMARY KEY CHECK (one = 1),
    key_id TEXT NOT NULL
);

-- Short-lived permissions to read one resource, by the hash of the ticket.
CREATE TABLE tickets (
    hash       TEXT COLLATE "C" PRIMARY KEY,
    tenant     TEXT COLLATE "C" NOT NULL,
    key_id     TEXT COLLATE "C",
    path       TEXT COLLATE "C" NOT NULL,
    expires_at BIGINT NOT NULL
);
CREATE INDEX tickets_of_tenant ON tickets (tenant, expires_at);
CREATE INDEX tickets_by_time ON tickets (expires_at);

-- Studies: their state is here; who is in them, what is asked and what was found are blobs.
CREATE TABLE studies (
    id             TEXT COLLATE "C" PRIMARY KEY,
    tenant         TEXT COLLATE "C" NOT NULL,
    state          TEXT COLLATE "C" NOT NULL
        CHECK (state IN ('queued', 'matching', 'modelling', 'finished', 'failed', 'cancelled')),
    -- Raised by every change: what was decided from an earlier one is not stored.
    revision       BIGINT NOT NULL DEFAULT 0,
    method         TEXT COLLATE "C" NOT NULL,
    method_version TEXT COLLATE "C" NOT NULL,
    n_subjects     BIGINT NOT NULL,
    priority       BIGINT NOT NULL,
    labels         TEXT COLLATE "C" NOT NULL,
    external_ref   TEXT COLLATE "C",
    max_attempts   BIGINT NOT NULL,
    max_queued     BIGINT NOT NULL,
    max_run_ms     BIGINT,
    traceparent    TEXT COLLATE "C",
    -- The hidden job that plans or models.
    step_id        TEXT COLLATE "C",
    round          BIGINT NOT NULL DEFAULT 0,
    n_before       BIGINT NOT NULL DEFAULT 0,
    n_tasks        BIGINT NOT NULL DEFAULT 0,
    n_made         BIGINT NOT NULL DEFAULT 0,
    error          TEXT COLLATE "C",
    created_at     BIGINT NOT NULL,
    finished_at    BIGINT,
    expires_at     BIGINT,
    purged_at      BIGINT
);

CREATE INDEX studies_by_time ON studies (tenant, created_at, id);
CREATE INDEX studies_active ON studies (created_at, id) WHERE state IN ('queued', 'matching', 'modelling');
CREATE INDEX studies_finished ON studies (finished_at) WHERE finished_at IS NOT NULL;

-- Blobs to which a study refers: its inputs, its definition, the records of its matches, its template and its results.
CREATE TABLE study_blobs (
    study_id TEXT COLLATE "C" NOT NULL REFERENCES studies (id) ON DELETE CASCADE,
    name     TEXT COLLATE "C" NOT NULL,
    tenant   TEXT COLLATE "C" NOT NULL,
    path     TEXT COLLATE "C" NOT NULL,
    n_bytes  BIGINT NOT NULL,
    PRIMARY KEY (study_id, name)
);

CREATE INDEX study_blobs_by_path ON study_blobs (tenant, path);

-- What the service remembers of itself: the last time it saw, and the mark of its blob store.
CREATE TABLE facts (
    name   TEXT COLLATE "C" PRIMARY KEY,
    number BIGINT,
    text   TEXT
);

-- Processes that run jobs, at work or idle, each with when it was last seen; one that is not seen for a minute has ended.
CREATE TABLE workers (
    name TEXT NOT NULL PRIMARY KEY,
    seen_at BIGINT NOT NULL
);
