-- take_records
INSERT INTO study_blobs (study_id, name, tenant, path, n_bytes)
SELECT jobs.study_id, 'matches/' || jobs.study_task || '.match', job_artifacts.tenant, job_artifacts.path, job_artifacts.n_bytes
FROM jobs
INNER JOIN job_artifacts ON job_artifacts.job_id = jobs.id AND job_artifacts.kind = 'study_record'
WHERE jobs.study_id = $1 AND jobs.state = 'succeeded' AND jobs.study_task IS NOT NULL
ON CONFLICT (study_id, name) DO NOTHING
