-- purge_changes
DELETE FROM changes WHERE at <= {now} - $1 AND ($2 = '' OR tenant = $2) AND $3 NOT LIKE '%,' || tenant || ',%'
