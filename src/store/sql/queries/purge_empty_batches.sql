-- purge_empty_batches
DELETE FROM batches
WHERE
    created_at <= {now} - $1
    AND ($2 = '' OR tenant = $2) AND $3 NOT LIKE '%,' || tenant || ',%'
    AND NOT EXISTS (SELECT 1 FROM jobs WHERE jobs.batch_id = batches.id)
