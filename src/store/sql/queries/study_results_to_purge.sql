-- study_results_to_purge
SELECT id
FROM studies
WHERE
    purged_at IS NULL AND expires_at IS NOT NULL AND (expires_at <= {now} OR finished_at <= {now} - $2)
    AND ($3 = '' OR tenant = $3) AND $4 NOT LIKE '%,' || tenant || ',%'
ORDER BY expires_at
LIMIT $1
