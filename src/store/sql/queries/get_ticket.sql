-- get_ticket
SELECT tenant, key_id, path FROM tickets WHERE hash = $1 AND expires_at > {now}
