-- lock_change_counter
UPDATE counters SET value = value WHERE name = 'changes' RETURNING value
