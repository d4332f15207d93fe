#!/usr/bin/env python3
"""Follows `stillcut-cli run` line by line: watch_run.py PROFILE [options of run]"""
import datetime
import json
import subprocess
import sys

command = ["stillcut-cli", "run", "--profile", sys.argv[1], *sys.argv[2:], "--json"]
with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as run:
    expected = 1
    for text in run.stdout:
        line = json.loads(text)
        assert line["schema"] == "stillcut-cli/1" and line["sequence"] == expected, "a line is missing"
        expected += 1
        when = datetime.datetime.fromtimestamp(line["utc_ms"] / 1000.0).strftime("%H:%M:%S.%f")[:-3]
        if line["type"] in ("change", "status"):
            frequency = line["frequency_hz"]  # None: there is none
            print(when, line["state"], "" if frequency is None else f"{frequency:.0f} Hz", line["advice"]["sentence"] or "")
        elif line["type"] in ("event", "stopped", "resumed", "end"):
            print(when, line["type"], line["sentence"])
sys.exit(run.returncode)
