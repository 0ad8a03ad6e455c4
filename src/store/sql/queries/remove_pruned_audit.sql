-- remove_pruned_audit
DELETE FROM audit
WHERE position <= (SELECT position FROM audit_anchor) AND position < (SELECT MIN(position) FROM audit) + $1
