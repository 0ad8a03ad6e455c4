-- queue_position
-- In two parts, each a range of the queue's index; as one condition PostgreSQL would look at all that wait.
SELECT COUNT(*) + 1
FROM (
    SELECT 1 FROM (SELECT id FROM jobs WHERE state = 'queued' AND priority > $1 LIMIT 10000) AS more_urgent
    UNION ALL
    SELECT 1
    FROM (
        SELECT id
        FROM jobs
        WHERE state = 'queued' AND priority = $1 AND (created_at, id) < ($2, $3)
        LIMIT 10000
    ) AS older
    LIMIT 10000
) AS earlier
