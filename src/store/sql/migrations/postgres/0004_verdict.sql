-- Whether the answer of a job can be relied on, as JSON; absent for jobs that ended before this column was there.
ALTER TABLE jobs ADD COLUMN verdict TEXT;

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
