-- lock_audit_head
SELECT position, hash, {now} AS at FROM audit_head {for_update}
