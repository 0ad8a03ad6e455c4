-- lock_job
SELECT state, purged_at FROM jobs WHERE id = $1 AND tenant = $2 {for_update}
