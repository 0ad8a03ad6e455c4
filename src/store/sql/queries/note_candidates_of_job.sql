-- note_candidates_of_job
UPDATE blobs
SET is_candidate = TRUE
WHERE (tenant, path) IN (SELECT tenant, path FROM job_artifacts WHERE job_id = $1)
