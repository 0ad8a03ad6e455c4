-- study_failures
SELECT study_task, state, error
FROM jobs
WHERE study_id = $1 AND study_task IS NOT NULL AND state IN ('failed', 'cancelled', 'expired', 'dead')
ORDER BY created_at, id
