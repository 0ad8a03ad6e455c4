-- lock_blobs_of_study
SELECT 1
FROM blobs
WHERE (tenant, path) IN (SELECT tenant, path FROM study_blobs WHERE study_id = $1)
ORDER BY tenant, path
{for_update}
