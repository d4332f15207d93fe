#!/usr/bin/env python3
"""A cut of noise, runout, tooth passings and chatter that grows, judged by Stillcut's Python module, whole and as it comes."""
import numpy
import stillcut

rate, teeth, speed = 25600.0, 4, 6000.0  # Hz, 1, rpm
t = numpy.arange(0.0, 6.0, 1.0 / rate)
x = numpy.random.default_rng(1).normal(0.0, 0.05, t.size) + 0.3 * numpy.sin(2.0 * numpy.pi * speed / 60.0 * t)
for n in range(1, 5):
    x += numpy.sin(2.0 * numpy.pi * n * teeth * speed / 60.0 * t) / n
x += (t > 2.0) * numpy.minimum(5.0, 0.01 * numpy.exp(8.0 * (t - 2.0))) * numpy.sin(2.0 * numpy.pi * 1316.0 * t)

answer = stillcut.analyze(x, rate, teeth, speed)["answer"]
print(answer["sentence"])
print(answer["judged_sentence"])
print([round(choice["speed_rpm"]) for choice in answer["advice"]["speeds"]], "rpm would be stable")

detector = stillcut.Detector(rate=rate, teeth=teeth, speed=speed)
for block in numpy.array_split(x, 600):  # as a sensor would give them
    alarms = [verdict for verdict in detector.feed(block) if verdict.alarm]
    if alarms:
        print(f"{alarms[0].state} at {alarms[0].frequency:.0f} Hz, {alarms[0].time:.3f} s after the first sample")
        break

mode = stillcut.Mode(frequency=1300.0, damping=0.02, stiffness=1.5e7)
lobes = stillcut.lobes([mode], [5500.0, 6000.0, 6500.0], teeth=teeth, diameter=0.012, tangential=7e8, radial=2e8)
for at, depth in zip(lobes.speed, lobes.depth):
    print(f"{at:.0f} rpm: stable to {1e3 * depth:.2f} mm")
