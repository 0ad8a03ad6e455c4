-- queue_position
-- In two parts, each a range of the queue's index; with a single condition PostgreSQL would read all queued jobs.
SELECT COUNT(*) + 1
FROM (
    SELECT 1
    FROM (SELECT id FROM jobs WHERE state = 'queued' AND tenant = $3 AND priority > $1 LIMIT 10000) AS more_urgent
    UNION ALL
    SELECT 1
    FROM (
        SELECT id
        FROM jobs
        WHERE state = 'queued' AND tenant = $3 AND priority = $1 AND place < (SELECT place FROM jobs WHERE id = $2)
        LIMIT 10000
    ) AS older
    LIMIT 10000
) AS earlier
