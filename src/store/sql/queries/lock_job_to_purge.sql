-- lock_job_to_purge
SELECT id FROM jobs WHERE id = $1 AND finished_at IS NOT NULL {skip_locked}
