-- bound_wait_of_holds
UPDATE blob_holds SET expires_at = {now} + $1 WHERE expires_at > {now} + $1
