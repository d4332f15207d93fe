-- Where TimescaleDB is there, after schema.sql: a chunk a day, compressed after a week, kept for two years.
-- Not run here: TimescaleDB is not in Debian 12. Plain PostgreSQL does without this file.
CREATE EXTENSION IF NOT EXISTS timescaledb;
SELECT create_hypertable('stillcut_message', 'utc_ms', chunk_time_interval => 86400000, migrate_data => true);
CREATE FUNCTION stillcut_now_ms() RETURNS bigint LANGUAGE sql STABLE AS
$$ SELECT CAST(extract(epoch FROM now()) * 1000 AS bigint) $$;
SELECT set_integer_now_func('stillcut_message', 'stillcut_now_ms');
ALTER TABLE stillcut_message SET (timescaledb.compress, timescaledb.compress_segmentby = 'machine, topic');
SELECT add_compression_policy('stillcut_message', BIGINT '604800000');
SELECT add_retention_policy('stillcut_message', BIGINT '63072000000');
