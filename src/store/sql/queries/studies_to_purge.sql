-- studies_to_purge
SELECT id, tenant
FROM studies
WHERE
    finished_at IS NOT NULL AND finished_at <= {now} - $1
    AND ($3 = '' OR tenant = $3) AND $4 NOT LIKE '%,' || tenant || ',%'
ORDER BY finished_at
LIMIT $2
