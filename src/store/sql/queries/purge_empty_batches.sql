-- purge_empty_batches
DELETE FROM batches
WHERE created_at <= {now} - $1 AND NOT EXISTS (SELECT 1 FROM jobs WHERE jobs.batch_id = batches.id)
