-- overdue_jobs
SELECT id, state
FROM jobs
WHERE
    (state = 'queued' AND deadline_at <= {now})
    OR (state = 'running' AND run_deadline_at + $1 < {now})
LIMIT 500
{skip_locked}
