-- advance_counters_of_tenants
INSERT INTO counters (name, value)
SELECT 'changes of ' || tenant, MAX(number) FROM changes WHERE seq >= $1 GROUP BY tenant
ON CONFLICT (name) DO UPDATE SET
    value = CASE WHEN excluded.value > counters.value THEN excluded.value ELSE counters.value END
