-- bound_run_time
-- A job that started later than now was started by a clock that was set back since.
UPDATE jobs
SET run_deadline_at = {now} + (run_deadline_at - started_at), started_at = {now}
WHERE state = 'running' AND started_at > {now}
