-- count_crash
UPDATE jobs SET crashes = crashes + 1 WHERE id = $1
