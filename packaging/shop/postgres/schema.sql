-- The messages of stillcut-shop in PostgreSQL, and what they mean as views. Written so that SQLite takes it as well, which
-- the tests use. A message that comes twice has the same key and is left out by whoever inserts: ON CONFLICT DO NOTHING.
CREATE TABLE stillcut_message (
  machine text NOT NULL,      -- SITE/AREA/MACHINE, the topic before /stillcut/
  topic text NOT NULL,        -- what is behind it: state, event/alarm
  series bigint NOT NULL,
  sequence bigint NOT NULL,
  utc_ms bigint NOT NULL,
  payload jsonb NOT NULL,
  PRIMARY KEY (machine, series, sequence, utc_ms)
);
CREATE INDEX stillcut_message_time ON stillcut_message (topic, utc_ms);

CREATE VIEW stillcut_run AS
SELECT machine, CAST(payload->>'run' AS bigint) AS run, payload->>'machine' AS machine_name, payload->>'job' AS job,
       payload->>'tool' AS tool, payload->>'version' AS version, payload->>'profile_hash' AS profile_hash
FROM stillcut_message WHERE topic = 'meta';

CREATE VIEW stillcut_features AS
SELECT machine, utc_ms, CAST(payload->>'run' AS bigint) AS run, payload->>'job' AS job, payload->>'tool' AS tool,
       payload->>'state' AS state, CAST(payload->>'in_cut_s' AS double precision) AS in_cut_s,
       CAST(payload->>'judged_s' AS double precision) AS judged_s,
       CAST(payload->>'chatter_s' AS double precision) AS chatter_s,
       CAST(payload->>'chatter_mm' AS double precision) AS chatter_mm,
       CAST(payload->>'energy_ratio' AS double precision) AS energy_ratio,
       CAST(payload->>'rms' AS double precision) AS rms,
       CAST(payload->>'speed_rpm' AS double precision) AS speed_rpm,
       CAST(payload->>'actual_rpm' AS double precision) AS actual_rpm,
       CAST(payload->>'actual_feed_mm_min' AS double precision) AS actual_feed_mm_min,
       CAST(payload->>'speed_override_percent' AS double precision) AS speed_override_percent,
       CAST(payload->>'latency_ms' AS double precision) AS latency_ms
FROM stillcut_message WHERE topic = 'features';

CREATE VIEW stillcut_alarm AS
SELECT machine, utc_ms, CAST(payload->>'run' AS bigint) AS run, payload->>'job' AS job, payload->>'tool' AS tool,
       payload->>'edge' AS edge, payload->>'how' AS how, payload->>'kind' AS kind, payload->>'mode' AS mode,
       CAST(payload->>'frequency_hz' AS double precision) AS frequency_hz,
       CAST(payload->>'speed_rpm' AS double precision) AS speed_rpm,
       CAST(payload->>'duration_s' AS double precision) AS duration_s,
       CAST(payload->>'chatter_s' AS double precision) AS chatter_s,
       CAST(payload->>'chatter_mm' AS double precision) AS chatter_mm
FROM stillcut_message WHERE topic = 'event/alarm';

CREATE VIEW stillcut_advice AS
SELECT machine, utc_ms, CAST(payload->>'run' AS bigint) AS run, payload->>'job' AS job, payload->>'tool' AS tool,
       payload->>'answer' AS answer, CAST(payload->>'advised_rpm' AS double precision) AS advised_rpm,
       CAST(payload->>'speed_rpm' AS double precision) AS speed_rpm,
       CAST(payload->>'frequency_hz' AS double precision) AS frequency_hz
FROM stillcut_message WHERE topic = 'event/advice';

CREATE VIEW stillcut_state AS
SELECT machine, utc_ms, CAST(payload->>'run' AS bigint) AS run, payload->>'state' AS state, payload->>'reason' AS reason,
       payload->>'mode' AS mode, payload->>'tool' AS tool, payload->>'job' AS job,
       CAST(payload->>'frequency_hz' AS double precision) AS frequency_hz
FROM stillcut_message WHERE topic = 'state';
