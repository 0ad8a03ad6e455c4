-- copy_artifacts
INSERT INTO job_artifacts (job_id, kind, tenant, path, hash, n_bytes)
SELECT $1, kind, tenant, path, hash, n_bytes
FROM job_artifacts
WHERE job_id = $2 AND kind NOT IN ('source', 'target')
