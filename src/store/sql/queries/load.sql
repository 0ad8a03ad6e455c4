-- load
SELECT
    (SELECT COUNT(*) FROM jobs WHERE state = 'queued') AS queued,
    (SELECT COUNT(*) FROM jobs WHERE state = 'running') AS running,
    (SELECT COALESCE({now} - MIN(created_at), 0) FROM jobs WHERE state = 'queued') AS oldest_ms,
    (SELECT COUNT(DISTINCT worker_id) FROM jobs WHERE state = 'running') AS busy_workers,
    (
        SELECT COUNT(*)
        FROM workers
        WHERE seen_at >= {now} - 60000
            AND NOT EXISTS (SELECT 1 FROM jobs WHERE jobs.state = 'running' AND jobs.worker_id = workers.name)
    ) AS idle_workers
