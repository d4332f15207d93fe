-- Where Telegraf brings the messages (telegraf.conf), after schema.sql: its rows as they come, and the way from there.
CREATE TABLE stillcut_raw (time timestamp, topic text, value text, host text);
CREATE FUNCTION stillcut_take() RETURNS trigger LANGUAGE plpgsql AS $$
BEGIN
  INSERT INTO stillcut_message
  SELECT split_part(NEW.topic, '/stillcut/', 1), split_part(NEW.topic, '/stillcut/', 2), (p->>'series')::bigint,
         (p->>'sequence')::bigint, (p->>'utc_ms')::bigint, p
  FROM (SELECT NEW.value::jsonb AS p) AS message
  ON CONFLICT DO NOTHING;
  RETURN NULL;  -- the raw row itself is not kept
END $$;
CREATE TRIGGER stillcut_take BEFORE INSERT ON stillcut_raw FOR EACH ROW EXECUTE FUNCTION stillcut_take();
