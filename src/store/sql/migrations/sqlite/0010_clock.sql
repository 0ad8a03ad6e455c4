-- What the service remembers of itself: the last time it saw, and the mark of its blob store.
CREATE TABLE facts (
    name   TEXT PRIMARY KEY,
    number INTEGER,
    text   TEXT
) STRICT;

-- The place of a job in the queue: by when it came, whatever the clock said.
ALTER TABLE jobs ADD COLUMN place INTEGER;
UPDATE jobs SET place = rowid;
CREATE TRIGGER job_placed AFTER INSERT ON jobs
BEGIN
    UPDATE jobs SET place = NEW.rowid WHERE id = NEW.id;
END;

DROP INDEX jobs_queue_of_tenant;
CREATE INDEX jobs_queue_of_tenant ON jobs (tenant, priority DESC, place) WHERE state = 'queued';

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
