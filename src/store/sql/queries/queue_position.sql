-- queue_position
SELECT COUNT(*) + 1
FROM (
    SELECT 1
    FROM jobs
    WHERE state = 'queued' AND (priority > $1 OR (priority = $1 AND (created_at, id) < ($2, $3)))
    LIMIT 10000
) AS earlier
