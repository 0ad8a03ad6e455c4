-- lease_status
SELECT cancel_requested FROM jobs WHERE id = $1 AND lease_epoch = $2 AND state = 'running'
