#!/usr/bin/python3
"""The Python module against the program's own answers: test_module.py CLI SCENARIOS, PYTHONPATH naming the module."""
import json
import os
import subprocess
import sys
import tempfile
import threading
import unittest

import numpy

import stillcut

CLI, SCENARIOS = sys.argv[1:3] if len(sys.argv) > 2 else ("", "")


def cli(*words):
    """Code 1 of analyze is "chatter"."""
    run = subprocess.run([CLI, *words], stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False, text=True)
    assert run.returncode in (0, 1), run.stderr
    return run.stdout


class Cut:
    """A simulated cut, its samples in a WAV file and as an array."""

    def __init__(self, scenario, seed):
        self.folder = tempfile.TemporaryDirectory()
        self.path = os.path.join(self.folder.name, "cut.wav")
        cli("simulate", os.path.join(SCENARIOS, scenario), "--strategy", "monitor", "--seed", str(seed), "--out", self.path)
        self.rate, self.x = read_wav(self.path)

    def __del__(self):
        self.folder.cleanup()


def read_wav(path):
    from scipy.io import wavfile
    rate, x = wavfile.read(path)
    if x.dtype.kind == "i":
        x = x / float(2 ** (8 * x.dtype.itemsize - 1))
    return float(rate), x.astype(numpy.float32)


class Analyze(unittest.TestCase):
    def test_says_what_the_command_line_says(self):
        for scenario in ("xu-aluminium.toml", "ford-stable.toml"):
            cut = Cut(scenario, 3)
            wanted = json.loads(cli("analyze", cut.path, "--teeth", "2", "--speed", "6000", "--json"))
            scale = float(wanted.get("scale", 1.0))
            got = stillcut.analyze(cut.x * scale, cut.rate, teeth=2, speed=6000,
                                   sensor=wanted["answer"]["channels"][0]["quantity"] if wanted["answer"]["channels"] else "sound")
            self.assertEqual(got["answer"]["finding"], wanted["answer"]["finding"], scenario)
            self.assertEqual(got["answer"]["alarms"], wanted["answer"]["alarms"], scenario)
            self.assertEqual(got["answer"]["advice"], wanted["answer"]["advice"], scenario)
            self.assertAlmostEqual(got["answer"]["judged_s"], wanted["answer"]["judged_s"], places=2)
            self.assertEqual([v["key"] for v in got["own_values"]], [v["key"] for v in wanted["own_values"]], scenario)
            self.assertTrue(got["own_values"])
            self.assertEqual(set(got["own_values"][0]), set(wanted["own_values"][0]))

    def test_remarks_say_what_was_assumed(self):
        cut = Cut("xu-aluminium.toml", 3)
        self.assertEqual(stillcut.analyze(cut.x, cut.rate, teeth=2, speed=6000)["remarks"], [])
        guessed = stillcut.analyze(cut.x, cut.rate)["remarks"]
        self.assertEqual([r.split(":")[0] for r in guessed], ["teeth not given", "speed not given"])
        wanted = json.loads(cli("analyze", cut.path, "--json"))["remarks"]
        self.assertEqual([r.split(" (")[0] for r in wanted if "not given" in r], [r.split(":")[0] for r in guessed])

    def test_a_speed_in_revolutions_a_second_is_doubted(self):
        rate, turns = 12800.0, 100.0  # of the spindle a second
        t = numpy.arange(int(6 * rate)) / rate
        x = sum(numpy.sin(2 * numpy.pi * n * turns * t + n) / n for n in (1, 2, 3, 4, 6, 8, 12))
        x = x + 0.02 * numpy.random.default_rng(6).standard_normal(len(t))
        self.assertTrue(any("6000" in r for r in stillcut.analyze(x, rate, teeth=4, speed=turns)["remarks"]))
        self.assertFalse(stillcut.analyze(x, rate, teeth=4, speed=60 * turns)["remarks"])

    def test_a_constant_channel_is_named_and_left_out(self):
        cut = Cut("xu-aluminium.toml", 3)
        x = numpy.stack([numpy.full(len(cut.x), 4.0), cut.x if cut.x.ndim == 1 else cut.x[:, 0]], axis=1)
        got = stillcut.analyze(x, cut.rate, teeth=2, speed=6000)
        self.assertEqual([c["channel"] for c in got["answer"]["left_out"]], [0])
        self.assertEqual(got["channels"], 1)

    def test_silence_is_not_called_free_of_chatter(self):
        got = stillcut.analyze(numpy.zeros(50000), 25000.0, teeth=4, speed=6000)
        self.assertNotEqual(got["answer"]["finding"], "chatter")
        self.assertNotEqual(got["answer"]["finding"], "no-chatter")

    def test_what_is_wrong_is_one_line(self):
        for call, word in (
            (lambda: stillcut.analyze([0.0] * 10, 10.0), "rate"),
            (lambda: stillcut.analyze(numpy.zeros((2, 2, 2)), 1000.0), "shape"),
            (lambda: stillcut.analyze(numpy.zeros((2, 50)), 1000.0), "shape"),
            (lambda: stillcut.analyze(["a"], 1000.0), "type"),
            (lambda: stillcut.analyze([], 1000.0), "none"),
            (lambda: stillcut.analyze([0.0] * 10, 1000.0, sensor="smell"), "smell"),
            (lambda: stillcut.analyze([0.0] * 10, 1000.0, methods=["magic"]), "magic"),
            (lambda: stillcut.analyze([0.0] * 10, 1000.0, methods=[]), "one to"),
            (lambda: stillcut.analyze([0.0] * 10, 1000.0, parameters={"no.such": 1}), "no.such"),
            (lambda: stillcut.analyze([0.0] * 10, 1000.0, teeth=-1), "teeth"),
            (lambda: stillcut.analyze([0.0] * 10, 1000.0, teeth=1000), "200"),
            (lambda: stillcut.analyze([0.0] * 10, 1000.0, teeth=4.7), "whole"),
            (lambda: stillcut.analyze([0.0] * 10, 1000.0, speed=float("nan")), "speed"),
            (lambda: stillcut.analyze([0.0] * 10, float("nan")), "rate"),
            (lambda: stillcut.analyze([0.0] * 10, 1000.0, scale=0.0), "scale"),
            (lambda: stillcut.analyze([0.0] * 10, 1000.0, sensor=None), "sensor"),
            (lambda: stillcut.analyze([0.0] * 10, 1000.0, methods=[1]), "methods"),
            (lambda: stillcut.analyze([0.0] * 10, 1000.0, parameters=["a"]), "mapping"),
            (lambda: stillcut.Detector(rate=1000.0, channels=10**5), "32"),
            (lambda: stillcut.Detector(rate=1000.0).feed([0.0], speed=-5), "speed"),
        ):
            with self.assertRaises(ValueError) as raised:
                call()
            self.assertIn(word, str(raised.exception))
            self.assertNotIn("\n", str(raised.exception))


class Detector(unittest.TestCase):
    def test_says_the_same_however_the_samples_come(self):
        cut = Cut("xu-aluminium.toml", 5)
        x = cut.x if cut.x.ndim == 2 else cut.x[:, None]
        whole = stillcut.Detector(rate=cut.rate, teeth=2, speed=6000, channels=x.shape[1]).feed(x)
        parts, at = [], 0
        fed = stillcut.Detector(rate=cut.rate, teeth=2, speed=6000, channels=x.shape[1])
        for n in numpy.random.default_rng(1).integers(0, 3000, 10000):
            parts += fed.feed(x[at:at + n])
            at += n
            if at >= len(x):
                break
        self.assertEqual(whole, parts)
        self.assertAlmostEqual(whole[-1].time, len(x) / cut.rate, delta=0.0051)
        answer = stillcut.analyze(x, cut.rate, teeth=2, speed=6000)["answer"]
        if answer["alarms"]:
            first = next(v.time for v in whole if v.alarm)
            self.assertAlmostEqual(first, answer["first_alarm_s"], places=3)
        for v in whole:
            self.assertIn(v.state, ("air", "stable", "onset", "chatter", "not-judged"))
            if v.state == "not-judged":
                self.assertTrue(v.reason)

    def test_every_method_runs(self):
        x = numpy.random.default_rng(2).standard_normal(12800)
        for method in stillcut.detectors():
            verdicts = stillcut.Detector(method, rate=12800.0, teeth=3, speed=6000).feed(x, speed=6010)
            self.assertEqual(len(verdicts), 200)
            self.assertTrue(verdicts[-1].indicators)

    def test_channels_are_counted(self):
        with self.assertRaises(ValueError):
            stillcut.Detector(rate=12800.0, channels=2).feed(numpy.zeros(64))

    def test_what_is_masked_was_not_measured(self):
        x = numpy.ma.masked_array(numpy.random.default_rng(4).standard_normal(12800), mask=numpy.arange(12800) > 6400)
        verdicts = stillcut.Detector(rate=12800.0, teeth=2, speed=9000).feed(x)
        self.assertEqual(verdicts[-1].state, "not-judged")

    def test_two_threads_on_one_detector_wait_for_each_other(self):
        fed = stillcut.Detector(rate=25600.0, teeth=2, speed=9000)
        x = numpy.random.default_rng(3).standard_normal(256)
        counts = []

        def work():
            counts.append(sum(len(fed.feed(x)) for _ in range(200)))

        threads = [threading.Thread(target=work) for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(sum(counts), 4 * 200 * 256 // 128)

    def test_threads_run_beside_each_other(self):
        x = numpy.random.default_rng(3).standard_normal(25600)
        wanted = stillcut.Detector(rate=25600.0, teeth=2, speed=9000).feed(x)
        got = [None] * 4

        def work(k):
            got[k] = stillcut.Detector(rate=25600.0, teeth=2, speed=9000).feed(x)

        threads = [threading.Thread(target=work, args=(k,)) for k in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertTrue(all(g == wanted for g in got))


class Lobes(unittest.TestCase):
    MODE = stillcut.Mode(900.0, 0.03, 2.0e7, (0.0, 1.0))

    def test_a_slot_by_one_mode_has_the_limit_of_theory(self):
        # Full immersion, one mode across the feed, many teeth: Altintas and Budak 1995. The least of the lobes is the
        # absolute limit of -2 pi / (N a_yy K_t min Re G), a_yy = -pi K_r/2 of a full slot's mean.
        speeds = numpy.arange(3000.0, 16000.0, 25.0)
        found = stillcut.lobes([self.MODE], speeds, teeth=4, diameter=0.012, tangential=7.0e8, radial=2.1e8, method="zoa")
        zeta, k = self.MODE.damping, self.MODE.stiffness
        deepest_real = -1.0 / (4.0 * k * zeta * (1.0 + zeta))
        mean = numpy.pi / 2.0 * 0.3  # of the directional coefficient along y, over the slot
        limit = -2.0 * numpy.pi / (4 * mean * 2.0 * 7.0e8 * deepest_real)
        self.assertAlmostEqual(found.depth.min() / limit, 1.0, delta=0.02)

    def test_exact_and_semi_discretization_agree(self):
        speeds = [5200.0, 6000.0, 9000.0]
        cut = dict(teeth=2, diameter=0.010, tangential=6e8, radial=2e8, immersion=0.25)
        exact = stillcut.lobes([self.MODE], speeds, **cut)
        sdm = stillcut.lobes([self.MODE], speeds, method="sdm", **cut)
        numpy.testing.assert_allclose(sdm.depth, exact.depth, rtol=0.02)
        self.assertEqual(exact.speed.tolist(), speeds)

    def test_wrong_numbers_are_said(self):
        cut = dict(teeth=2, diameter=0.010, tangential=6e8, radial=2e8)
        for modes, speeds in (([], [5000.0]), ([stillcut.Mode(900.0, -0.1, 1e7)], [5000.0]), ([self.MODE], [])):
            with self.assertRaises(ValueError):
                stillcut.lobes(modes, speeds, **cut)
        with self.assertRaises(ValueError):
            stillcut.lobes([self.MODE], [5000.0], method="magic", **cut)


class FitModes(unittest.TestCase):
    def test_known_modes_come_back(self):
        f = numpy.arange(50.0, 3000.0, 1.0)
        known = [(420.0, 0.02, 8.0e6), (1310.0, 0.035, 2.1e7)]
        h = sum(1.0 / (k * (1.0 - (f / f0) ** 2 + 2j * z * f / f0)) for f0, z, k in known)
        for quantity, power in (("compliance", 0), ("mobility", 1), ("accelerance", 2)):
            fit = stillcut.fit_modes(f, h * (2j * numpy.pi * f) ** power, quantity=quantity)
            self.assertEqual(len(fit.modes), 2, quantity)
            for mode, (f0, z, k) in zip(fit.modes, known):
                self.assertAlmostEqual(mode.frequency / f0, 1.0, delta=2e-3)
                self.assertAlmostEqual(mode.damping / z, 1.0, delta=0.02)
                self.assertAlmostEqual(mode.stiffness / k, 1.0, delta=0.02)
            self.assertLess(fit.misfit, 0.02)
            self.assertEqual(fit.fitted.shape, fit.frequency.shape)

    def test_wrong_shapes_are_said(self):
        with self.assertRaises(ValueError):
            stillcut.fit_modes([1.0, 2.0], [1j])
        with self.assertRaises(ValueError):
            stillcut.fit_modes([1.0, 2.0], [1j, 1j], quantity="stiffness")
        with self.assertRaises(ValueError):
            stillcut.fit_modes([2.0, 1.0], [1j, 1j])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
