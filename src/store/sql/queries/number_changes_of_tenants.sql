-- number_changes_of_tenants
WITH fresh AS (
    SELECT
        changes.id,
        ROW_NUMBER() OVER (PARTITION BY changes.tenant ORDER BY changes.seq) + COALESCE(
            (SELECT value FROM counters WHERE counters.name = 'changes of ' || changes.tenant),
            (SELECT value FROM counters WHERE counters.name = 'changes before'),
            0
        ) AS place
    FROM changes
    WHERE changes.number IS NULL AND changes.seq IS NOT NULL
)
UPDATE changes SET number = fresh.place FROM fresh WHERE changes.id = fresh.id
