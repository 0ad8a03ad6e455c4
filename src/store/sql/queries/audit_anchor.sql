-- audit_anchor
SELECT position, hash FROM audit_anchor
