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

ALTER TABLE jobs ADD COLUMN study_id TEXT;
-- The key of the record that the job makes for its study.
ALTER TABLE jobs ADD COLUMN study_task TEXT;
CREATE INDEX jobs_by_study ON jobs (study_id, state) WHERE study_id IS NOT NULL;

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

-- Jobs that plan and model are hidden, and so are their changes.
DROP TRIGGER job_inserted;
CREATE TRIGGER job_inserted AFTER INSERT ON jobs WHEN NEW.method <> 'study'
BEGIN
    INSERT INTO changes (tenant, job_id, batch_id, state, at)
    VALUES (NEW.tenant, NEW.id, NEW.batch_id, NEW.state, CAST(unixepoch('subsec') * 1000 AS INTEGER));
END;

DROP TRIGGER job_changed;
CREATE TRIGGER job_changed AFTER UPDATE OF state ON jobs WHEN OLD.state <> NEW.state AND NEW.method <> 'study'
BEGIN
    INSERT INTO changes (tenant, job_id, batch_id, state, at)
    VALUES (NEW.tenant, NEW.id, NEW.batch_id, NEW.state, CAST(unixepoch('subsec') * 1000 AS INTEGER));
END;
