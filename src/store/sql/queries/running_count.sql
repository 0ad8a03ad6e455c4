-- running_count
SELECT COUNT(*) FROM jobs WHERE state = 'running'
