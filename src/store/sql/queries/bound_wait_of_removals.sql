-- bound_wait_of_removals
UPDATE blobs SET removing_since = {now} WHERE removing_since > {now}
