-- queue_length
SELECT COUNT(*) FROM jobs WHERE state = 'queued'
