-- move_audit_head
UPDATE audit_head SET position = $1, hash = $2
