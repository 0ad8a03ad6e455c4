-- bound_time_of_tickets
UPDATE tickets SET expires_at = {now} + $1 WHERE expires_at > {now} + $1
