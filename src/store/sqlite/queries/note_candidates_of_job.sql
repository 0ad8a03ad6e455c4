-- note_candidates_of_job
INSERT INTO blob_candidates (tenant, hash)
SELECT tenant, hash FROM job_artifacts WHERE job_id = ?1
ON CONFLICT DO NOTHING
