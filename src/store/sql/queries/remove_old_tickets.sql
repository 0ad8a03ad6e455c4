-- remove_old_tickets
DELETE FROM tickets WHERE expires_at <= {now}
