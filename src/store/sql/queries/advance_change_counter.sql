-- advance_change_counter
UPDATE counters SET value = value + $1 WHERE name = 'changes'
