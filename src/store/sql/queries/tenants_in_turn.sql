-- tenants_in_turn
-- Reads one entry of the queue's index for each tenant that waits, however many jobs it has.
WITH RECURSIVE waiting (tenant) AS (
    SELECT MIN(tenant) FROM jobs WHERE state = 'queued'
    UNION ALL
    SELECT (SELECT MIN(jobs.tenant) FROM jobs WHERE jobs.state = 'queued' AND jobs.tenant > waiting.tenant)
    FROM waiting
    WHERE waiting.tenant IS NOT NULL
)
SELECT waiting.tenant, COALESCE(turns.due, 0) AS due, (SELECT COALESCE(MAX(started), 0) FROM turns) AS present
FROM waiting
LEFT JOIN turns ON turns.tenant = waiting.tenant
WHERE waiting.tenant IS NOT NULL
ORDER BY COALESCE(turns.due, 0), waiting.tenant
LIMIT $1
