-- mark_result_purged
UPDATE jobs SET purged_at = {now} WHERE id = $1
