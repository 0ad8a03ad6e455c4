-- count_study_results_to_purge
SELECT COUNT(*)
FROM studies
WHERE
    purged_at IS NULL AND expires_at IS NOT NULL AND (expires_at <= {now} OR finished_at <= {now} - $1)
    AND ($2 = '' OR tenant = $2) AND $3 NOT LIKE '%,' || tenant || ',%'
