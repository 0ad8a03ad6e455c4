-- bound_wait_of_requests
-- Keys of requests in progress.
UPDATE idempotency_keys SET expires_at = {now} + $1 WHERE made IS NULL AND expires_at > {now} + $1
