-- take_turn
-- A tenant that has not waited lately begins at the present and not where it stopped: it is owed nothing for the time.
INSERT INTO turns (tenant, started, due)
SELECT $1, present.at, present.at + $2
FROM (SELECT COALESCE(MAX(started), 0) AS at FROM turns) AS present
WHERE TRUE
ON CONFLICT (tenant) DO UPDATE SET
    started = CASE WHEN turns.due > excluded.started THEN turns.due ELSE excluded.started END,
    due = CASE WHEN turns.due > excluded.started THEN turns.due ELSE excluded.started END + $2
