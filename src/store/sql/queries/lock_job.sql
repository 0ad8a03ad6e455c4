-- lock_job
SELECT state, purged_at FROM jobs WHERE id = $1 AND tenant = $2 AND method <> 'study' {for_update}
