-- get_artifact
SELECT jobs.state, jobs.purged_at, job_artifacts.path, job_artifacts.n_bytes
FROM jobs
LEFT JOIN job_artifacts ON job_artifacts.job_id = jobs.id AND job_artifacts.kind = $3
WHERE jobs.id = $1 AND jobs.tenant = $2
