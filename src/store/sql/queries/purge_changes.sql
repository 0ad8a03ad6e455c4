-- purge_changes
DELETE FROM changes WHERE at <= {now} - $1
