-- delete_artifacts
DELETE FROM job_artifacts WHERE job_id = $1
