-- delete_once_of_job
DELETE FROM idempotency_keys WHERE made = 'job:' || $1
