#!/usr/bin/env python3
"""From the broker into PostgreSQL, every message once: take_messages.py --port PORT [--host HOST] [mosquitto_sub's options] -- psql ...

Stands in for Telegraf, which is not in Debian: mosquitto_sub reads, psql writes. Prints what arrived every two seconds.
"""
import json
import signal
import subprocess
import sys
import time


def quoted(text):
    return "'" + text.replace("'", "''") + "'"


def main():
    split = sys.argv.index("--")
    listen = ["stdbuf", "-oL", "mosquitto_sub", *sys.argv[1:split], "--disable-clean-session", "-i", "take-messages", "-q", "2", "-F", "%t\t%p",
              "-t", "+/+/+/stillcut/meta", "-t", "+/+/+/stillcut/state", "-t", "+/+/+/stillcut/features",
              "-t", "+/+/+/stillcut/event/+"]
    database = subprocess.Popen([*sys.argv[split + 1:], "-q", "-v", "ON_ERROR_STOP=1"], stdin=subprocess.PIPE, text=True)
    arrived, states, said = {}, {}, time.monotonic()
    with subprocess.Popen(listen, stdout=subprocess.PIPE, text=True) as broker:
        signal.signal(signal.SIGTERM, lambda *_: broker.terminate())  # what it has heard is still written
        for line in broker.stdout:
            topic, payload = line.rstrip("\n").split("\t", 1)
            machine, what = topic.split("/stillcut/", 1)
            message = json.loads(payload)
            print(f"INSERT INTO stillcut_message VALUES ({quoted(machine)}, {quoted(what)}, {message['series']}, "
                  f"{message['sequence']}, {message['utc_ms']}, {quoted(payload)}) ON CONFLICT DO NOTHING;",
                  file=database.stdin, flush=True)
            arrived[machine] = arrived.get(machine, 0) + 1
            if what == "state":
                states[machine] = message["state"]
            if time.monotonic() - said > 2.0:
                said = time.monotonic()
                print(" ".join(f"{m.split('/')[-1]}:{n}:{states.get(m, '?')}" for m, n in sorted(arrived.items())), flush=True)
    database.stdin.close()
    return database.wait()


if __name__ == "__main__":
    sys.exit(main())
