-- lock_blobs_of_job
SELECT 1
FROM blobs
WHERE (tenant, path) IN (SELECT tenant, path FROM job_artifacts WHERE job_id = $1)
ORDER BY tenant, path
{for_update}
