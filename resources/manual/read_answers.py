#!/usr/bin/env python3
"""The answer of `stillcut-cli analyze` and its series, with numpy: read_answers.py RECORDING [options of analyze]"""
import json
import os
import subprocess
import sys
import tempfile

import numpy as np

with tempfile.TemporaryDirectory() as folder:
    series = os.path.join(folder, "series.csv")
    done = subprocess.run(["stillcut-cli", "analyze", *sys.argv[1:], "--json", "--series", series],
                          stdout=subprocess.PIPE, text=True, check=False)
    if done.returncode > 1:  # 0: no chatter, 1: chatter
        sys.exit(done.returncode)
    answer = json.loads(done.stdout)["answer"]
    assert json.loads(done.stdout)["schema"] == "stillcut-cli/1"
    table = np.genfromtxt(series, delimiter=",", names=True, dtype=None, encoding="utf-8", deletechars="")

print(answer["sentence"])
for choice in (answer["advice"] or {"speeds": []})["speeds"]:
    print(f"  {choice['speed_rpm']:.0f} rpm, {choice['waves']:.3g} waves between two teeth")

detector = answer["detector"]
t, valid = table["t"], table[detector + ".valid"] == 1  # what is not valid was not judged
alarm = valid & np.isin(table[detector + ".state"], ["onset", "chatter"])
step = np.median(np.diff(t))
print(f"judged {step * np.count_nonzero(valid):.2f} s of {t[-1]:.2f} s, in alarm {step * np.count_nonzero(alarm):.2f} s")
if detector + ".er" in table.dtype.names and valid.any():
    print(f"greatest energy ratio {np.nanmax(table[detector + '.er'][valid]):.3f}")
