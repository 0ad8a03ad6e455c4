-- mark_study_purged
UPDATE studies
SET purged_at = {now}, revision = revision + 1
WHERE id = $1 AND purged_at IS NULL AND expires_at IS NOT NULL AND (expires_at <= {now} OR finished_at <= {now} - $2)
