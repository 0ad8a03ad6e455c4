-- lock_blobs_of_holder
SELECT 1
FROM blobs
WHERE (tenant, path) IN (SELECT tenant, path FROM blob_holds WHERE holder = $1)
ORDER BY tenant, path
{for_update}
