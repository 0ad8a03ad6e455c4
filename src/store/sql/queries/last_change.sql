-- last_change
SELECT COALESCE(MAX(seq), 0) FROM changes
