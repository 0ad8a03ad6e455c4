-- get_batch
SELECT * FROM batches WHERE id = $1 AND tenant = $2
