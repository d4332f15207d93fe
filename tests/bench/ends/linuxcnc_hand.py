#!/usr/bin/python3
# Beside a running LinuxCNC, through NML and not through linuxcncrsh: what its overrides are, and whether a program runs,
# a line "SPEED FEED 0|1" into OUT at every change; and its operator, a line on standard input for every touch:
# "hand SPEED FEED" turns both knobs, "power off" and "power on" are the machine's button, "run FILE" has it on, homed and
# cutting, both knobs at 100 %.
# Usage: linuxcnc_hand.py OUT
import select
import sys
import time

import linuxcnc

stat, command = linuxcnc.stat(), linuxcnc.command()
OFF, ON = linuxcnc.STATE_OFF, linuxcnc.STATE_ON
last = None


def poll():
    """The newest status; a machine that is still starting has none, and says so in one of two ways."""
    global stat
    while True:
        try:
            return stat.poll()
        except (linuxcnc.error, SystemError):
            time.sleep(0.05)
            stat = linuxcnc.stat()


def look(out):
    global last
    poll()
    running = int(stat.task_state == ON and stat.interp_state != linuxcnc.INTERP_IDLE)
    now = (round(100 * stat.spindle[0]["override"]), round(100 * stat.feedrate), running)
    if now != last:
        print(*now, file=out)
        last = now
    return running


def hand(speed, feed):
    command.spindleoverride(speed / 100.0, 0)
    command.feedrate(feed / 100.0)


def ready(out):
    """On and homed, as far as 5 s go."""
    end = time.monotonic() + 5.0
    while time.monotonic() < end:
        poll()
        if stat.estop:
            command.state(linuxcnc.STATE_ESTOP_RESET)
        elif stat.task_state != ON:
            command.state(ON)
        elif not all(stat.homed[:stat.joints]):
            command.mode(linuxcnc.MODE_MANUAL)
            command.home(-1)
        else:
            return
        look(out)
        time.sleep(0.05)


def run(file, out):
    hand(100, 100)
    if look(out):
        return
    command.abort()
    ready(out)
    command.mode(linuxcnc.MODE_AUTO)
    command.wait_complete(1.0)
    command.program_open(file)
    command.wait_complete(1.0)
    command.auto(linuxcnc.AUTO_RUN, 0)
    end = time.monotonic() + 3.0
    while not look(out) and time.monotonic() < end:
        time.sleep(0.01)


with open(sys.argv[1], "w", buffering=1) as out:
    while True:
        look(out)
        if select.select([sys.stdin], [], [], 0.001)[0]:
            line = sys.stdin.readline()
            if not line:
                break
            what, *words = line.split()
            if what == "hand":
                hand(float(words[0]), float(words[1]))
            elif what == "power":
                command.state(ON if words[0] == "on" else OFF)
            elif what == "run":
                run(words[0], out)
