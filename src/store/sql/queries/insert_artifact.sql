-- insert_artifact
INSERT INTO job_artifacts (job_id, kind, tenant, path, hash, n_bytes) VALUES ($1, $2, $3, $4, $5, $6)
