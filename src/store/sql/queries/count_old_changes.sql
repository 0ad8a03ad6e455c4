-- count_old_changes
SELECT COUNT(*) FROM changes WHERE at <= {now} - $1
