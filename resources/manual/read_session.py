#!/usr/bin/env python3
"""What a Stillcut session holds, read with h5py alone: read_session.py FILE.h5"""
import sys

import h5py


def text(value):
    return value.decode("utf-8") if isinstance(value, bytes) else str(value)


with h5py.File(sys.argv[1], "r") as f:  # swmr=True reads one that is still being recorded
    assert text(f.attrs["format"]) == "stillcut-session"
    setup = f["setup"].attrs
    print("machine", text(setup["machine"]), "tool", text(setup["tool"]), "teeth", setup["teeth"])

    for name, samples in f["samples"].items():
        x = samples[:] * samples.attrs["scale"]  # in SI units
        low, high = f["pyramid"][name]["256"][:].T * samples.attrs["scale"]  # the picture of it
        print("channel", name, text(samples.attrs["name"]), len(x), "frames", text(samples.attrs["unit"]),
              "buckets", len(low), "from", low.min(initial=0.0), "to", high.max(initial=0.0))

    t = f["steps/blocks"]["first_sample_ns"] * 1e-9
    verdicts = f["verdicts"][:]
    alarms = verdicts[(verdicts["valid"] == 1) & (verdicts["state"] >= 2)]
    print("steps", len(t), "verdicts", len(verdicts), "alarming", len(alarms))

    reasons = text(f.attrs["reason_codes"]).split("\n")
    for event in f["events"]:
        print("event", event["time_ns"] * 1e-9, reasons[event["reason"]], *event["reason_numbers"])

    markers = {m["number"]: m for m in f["markers"]}  # the newest row of each number
    for m in markers.values():
        if not m["removed"]:
            print("marker", m["begin_ns"] * 1e-9, m["end_ns"] * 1e-9, text(m["label"]), text(m["author"]), text(m["note"]))
