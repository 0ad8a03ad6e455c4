-- queue_position
-- In two parts, each a range of the queue's index; with a single condition PostgreSQL would read all queued jobs.
SELECT COUNT(*) + 1
FROM (
    SELECT 1
    FROM (SELECT id FROM jobs WHERE state = 'queued' AND tenant = $4 AND priority > $1 LIMIT 10000) AS more_urgent
    UNION ALL
    SELECT 1
    FROM (
        SELECT id
        FROM jobs
        WHERE state = 'queued' AND tenant = $4 AND priority = $1 AND (created_at, id) < ($2, $3)
        LIMIT 10000
    ) AS older
    LIMIT 10000
) AS earlier
