-- set_verdict
UPDATE jobs SET verdict = $2 WHERE id = $1
