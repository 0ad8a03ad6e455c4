-- forget_worker
-- With those that ended without a word.
DELETE FROM workers WHERE name = $1 OR seen_at < {now} - 86400000
