-- audit_head
SELECT position, hash FROM audit_head
