#!/usr/bin/env python3
"""A machine that exists nowhere, as the lines of `stillcut-cli run --json --status`, one a second:
simulated_machine.py SECONDS SEED

Air, stable cutting, now and then chatter at a frequency and speed of its tool. No sample is simulated and nothing is
detected: for that, run `stillcut-cli run` on profiles/simulated.toml.
"""
import json
import random
import sys
import time

TOOLS = [("T4", 640.0, 6000.0), ("T12", 912.0, 8500.0), ("T16", 1180.0, 9800.0)]


def main():
    seconds, chance = int(sys.argv[1]), random.Random(int(sys.argv[2]))
    tool, hertz, speed = chance.choice(TOOLS)
    number, in_cut, chatter, alarm = 0, 0.0, 0.0, 0

    def line(line_type, t, **fields):
        nonlocal number
        number += 1
        print(json.dumps({"schema": "stillcut-cli/1", "command": "run", "type": line_type, "sequence": number,
                          "utc_ms": time.time_ns() // 1_000_000, "t": t, **fields}), flush=True)

    line("start", None, machine_name=f"machine {sys.argv[2]}", tool=tool, job=f"Housing {int(sys.argv[2]) % 3}",
         version="simulated", channels=[{"name": "x", "quantity": "acceleration", "unit": "m/s^2"}])
    for second in range(1, seconds + 1):
        time.sleep(1.0)
        alarm = alarm - 1 if alarm > 0 else (chance.randint(2, 4) if second > 2 and chance.random() < 0.15 else 0)
        state = "chatter" if alarm > 0 else "air" if second <= 2 else "stable"
        in_cut += state != "air"
        chatter += state == "chatter"
        line("status", float(second), state=state, phase="steady", valid=True, reason=None, kind="hopf",
             frequency_hz=hertz if alarm > 0 else None, energy_ratio=0.5 if alarm > 0 else 0.02, mode="advise",
             speed_rpm=speed + chance.uniform(-20.0, 20.0), rms=3.0, rms_unit="m/s^2", in_cut_s=in_cut, judged_s=in_cut,
             chatter_s=chatter, machine={"actual_rpm": speed, "programmed_rpm": speed})
        if alarm == 1 and chance.random() < 0.5:
            line("event", float(second), number=number, level="info", sentence="",
                 reason=chance.choice(["advice-refused", "advice-accepted"]), values=[1.07 * speed, 0.0, 0.0, 0.0])
    line("end", float(seconds), exit_code=0, sentence="the time is over", in_cut_s=in_cut, chatter_s=chatter)


if __name__ == "__main__":
    main()
