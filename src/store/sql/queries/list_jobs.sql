-- list_jobs
SELECT *
FROM job_records
WHERE
    tenant = :tenant
    AND state = :state -- when state
    AND method = :method -- when method
    AND external_ref = :reference -- when reference
    AND batch_id = :batch -- when batch
    AND id IN (SELECT job_id FROM job_labels WHERE tenant = :tenant AND name = :label_a AND value = :value_a) -- when label_a
    AND id IN (SELECT job_id FROM job_labels WHERE tenant = :tenant AND name = :label_b AND value = :value_b) -- when label_b
    AND id IN (SELECT job_id FROM job_labels WHERE tenant = :tenant AND name = :label_c AND value = :value_c) -- when label_c
    AND id IN (SELECT job_id FROM job_labels WHERE tenant = :tenant AND name = :label_d AND value = :value_d) -- when label_d
    AND created_at >= :created_from -- when created_from
    AND created_at < :created_before -- when created_before
    AND (created_at, id) < (:after_time, :after_id) -- when after_newest
    AND (created_at, id) > (:after_time, :after_id) -- when after_oldest
ORDER BY created_at DESC, id DESC -- when newest
ORDER BY created_at, id -- when oldest
LIMIT :size
