-- lock_cached
SELECT 1 FROM jobs WHERE id = $1 AND state = 'succeeded' AND purged_at IS NULL {for_update}
