-- bound_wait_of_leases
UPDATE jobs SET lease_expires_at = {now} + $1 WHERE state = 'running' AND lease_expires_at > {now} + $1
