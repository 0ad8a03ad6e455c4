-- load
SELECT
    (SELECT COUNT(*) FROM jobs WHERE state = 'queued') AS queued,
    (SELECT COUNT(*) FROM jobs WHERE state = 'running') AS running,
    (SELECT COALESCE({now} - MIN(created_at), 0) FROM jobs WHERE state = 'queued') AS oldest_ms
