-- delete_once_of_study
DELETE FROM idempotency_keys WHERE made = 'study:' || $1
