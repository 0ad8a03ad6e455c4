-- lock_lease
SELECT cancel_requested FROM jobs WHERE id = $1 AND lease_epoch = $2 AND state = 'running' {for_update}
