-- mesh_is_used
SELECT EXISTS (SELECT 1 FROM job_artifacts WHERE tenant = $1 AND path = $2)
