-- get_artifact
SELECT jobs.state, job_artifacts.hash, job_artifacts.n_bytes
FROM jobs
LEFT JOIN job_artifacts ON job_artifacts.job_id = jobs.id AND job_artifacts.kind = ?3
WHERE jobs.id = ?1 AND jobs.tenant = ?2
