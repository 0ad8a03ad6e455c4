-- set_study_priority
-- A plan that was made from an earlier revision would give its jobs the earlier priority.
UPDATE studies SET priority = $2, revision = revision + 1 WHERE id = $1
