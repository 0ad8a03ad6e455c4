-- insert_artifact
INSERT INTO job_artifacts (job_id, kind, tenant, hash, n_bytes) VALUES (?1, ?2, ?3, ?4, ?5)
