-- lock_result_to_purge
SELECT id
FROM jobs
WHERE id = $1 AND purged_at IS NULL AND expires_at IS NOT NULL AND (expires_at <= {now} OR finished_at <= {now} - $2)
{skip_locked}
