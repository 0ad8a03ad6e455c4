-- move_audit_anchor
UPDATE audit_anchor SET position = $1, hash = $2
