-- count_studies_to_purge
SELECT COUNT(*)
FROM studies
WHERE
    finished_at IS NOT NULL AND finished_at <= {now} - $1
    AND ($2 = '' OR tenant = $2) AND $3 NOT LIKE '%,' || tenant || ',%'
