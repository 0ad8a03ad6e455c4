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

ALTER TABLE jobs ADD COLUMN study_id TEXT COLLATE "C";
-- The key of the record that the job makes for its study.
ALTER TABLE jobs ADD COLUMN study_task TEXT COLLATE "C";
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
    CAST(EXTRACT(EPOCH FROM statement_timestamp()) * 1000 AS BIGINT) AS read_at
FROM jobs
LEFT JOIN job_progress ON job_progress.job_id = jobs.id;

-- Jobs that plan and model are hidden, and so are their changes.
DROP TRIGGER job_inserted ON jobs;
CREATE TRIGGER job_inserted AFTER INSERT ON jobs
FOR EACH ROW WHEN (NEW.method <> 'study') EXECUTE FUNCTION note_change();

DROP TRIGGER job_changed ON jobs;
CREATE TRIGGER job_changed AFTER UPDATE OF state ON jobs
FOR EACH ROW WHEN (OLD.state <> NEW.state AND NEW.method <> 'study') EXECUTE FUNCTION note_change();
