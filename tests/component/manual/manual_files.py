"""The files that the manual's commands speak of, made from nothing but physics, the demonstration and the page itself."""
import cmath
import math
import os
import re
import shutil
import subprocess
import wave

MODE = "[[mode]]\nfrequency_hz = 950.0\ndamping = 0.02\nstiffness_n_per_m = 3e6\ndirection = [1.0, 0.0]\n"
CASE = ("[tool]\nteeth = 4\ndiameter_mm = 10.0\n[engagement]\nradial_immersion = 0.5\nside = \"up\"\n"
        "[chart]\nmax_depth_mm = 10.0\n[material]\ntangential_n_per_m2 = 6e8\nradial_n_per_m2 = 2e8\n")
CASE_JSON = ('{"name": "slot", "N": 2, "aD": 1.0, "up": true, "wmax_mm": 4, "Kt": 6e8, "Kn": 2e8,'
             ' "modes": [{"f": 922, "zeta": 0.011, "m": 0.03993, "d": [1, 0]}]}')


def short_demo(top):
    """The demonstration, over in 8 s: onset at 4 s as ever."""
    with open(os.path.join(top, "resources/scenarios/demo.toml"), encoding="utf-8") as file:
        text = file.read()
    return text.replace("duration_s = 30.0", "duration_s = 8.0").replace("exit_at_s = 29.0", "exit_at_s = 7.0")


def tap(stiffness=3e6):
    """Compliance of one mode, frequency by frequency."""
    rows = ["Frequency [Hz]\tReal [m/N]\tImag [m/N]"]
    for hertz in range(300, 3001):
        ratio = hertz / 950.0
        h = 1.0 / (stiffness * complex(1.0 - ratio * ratio, 2.0 * 0.02 * ratio))
        rows.append(f"{hertz}.0\t{h.real:.9e}\t{h.imag:.9e}")
    return "\n".join(rows) + "\n"


def hit(peak, rate=25600):
    """Half-sine blow on a mode of 950 Hz, and the acceleration there, over half a second."""
    omega, damping, stiffness, step = 2.0 * math.pi * 950.0, 0.03, 1e7, 1.0 / rate
    rows, x, v = ["Time (s),Force (N),Acc (m/s^2)"], 0.0, 0.0
    for i in range(rate // 2):
        since = i / rate - 0.01
        force = peak * math.sin(math.pi * since / 4e-4) if 0.0 <= since <= 4e-4 else 0.0
        acceleration = omega * omega * (force / stiffness - x) - 2.0 * damping * omega * v
        rows.append(f"{i / rate:.8f},{force:.6f},{acceleration:.6f}")
        for _ in range(8):
            v += step / 8 * (omega * omega * (force / stiffness - x) - 2.0 * damping * omega * v)
            x += step / 8 * v
    return "\n".join(rows) + "\n"


def forces(feed_mm_min, rate=10000, speed=6000.0, teeth=2, depth=3e-3):
    """Forces on the tool in a slot (Altintas' linear-edge model), one second."""
    chip = feed_mm_min * 1e-3 / speed / teeth
    rows = ["Time (s),Fx (N),Fy (N),Fz (N)"]
    for i in range(rate):
        fx = fy = fz = 0.0
        for tooth in range(teeth):
            angle = (2.0 * math.pi * (speed / 60.0 * i / rate + tooth / teeth)) % (2.0 * math.pi)
            if angle < math.pi:
                direction = cmath.exp(1j * angle)
                tangential = (7e8 * chip * direction.imag + 2e4) * depth
                radial = (2e8 * chip * direction.imag + 1e4) * depth
                fx += -tangential * direction.real - radial * direction.imag
                fy += tangential * direction.imag - radial * direction.real
                fz += 1e8 * chip * direction.imag * depth
        rows.append(f"{i / rate:.6f},{fx:.6f},{fy:.6f},{fz:.6f}")
    return "\n".join(rows) + "\n"


def tone(path, rate=8000):
    """Three seconds of a calibrator's 1 kHz, a tenth of full scale."""
    values = (round(3276.8 * math.sin(2000.0 * math.pi * (i + 0.5) / rate)) for i in range(3 * rate))
    with wave.open(path, "wb") as file:
        file.setparams((1, 2, rate, 0, "NONE", ""))
        file.writeframes(b"".join(value.to_bytes(2, "little", signed=True) for value in values))


def knocks(rate=4000):
    """Blows along y at 0.5, 1.1 and 1.7 s; x hears a fifth of them."""
    rows = ["t (s),x (m/s^2),y (m/s^2)"]
    for i in range(10000):
        since = [i / rate - at for at in (0.5, 1.1, 1.7) if i / rate >= at]
        blow = sum(math.exp(-t / 0.02) * math.cos(2.0 * math.pi * 600.0 * t) for t in since)
        quiet = 1e-3 * (i * 7919 % 13 - 6)
        rows.append(f"{i / rate:.6f},{0.2 * blow - quiet:.6f},{blow + quiet:.6f}")
    return "\n".join(rows) + "\n"


def block_after(text, heading, begin):
    """The indented block below a heading that begins with the given text."""
    part = text.split("\n" + heading + "\n", 1)
    blocks = re.findall(r"(?:^    .*\n)+", part[1], re.MULTILINE) if len(part) > 1 else []
    return next((re.sub(r"(?m)^    ", "", b.strip("\n")) + "\n" for b in blocks if b.strip().startswith(begin)), None)


def write(folder, name, text):
    with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
        file.write(text)


def lay_out(top, programs, folder):
    """What every page finds: the source tree as the README sees it, but for a shorter demonstration, and recordings.

    The manual's own names (scenarios/demo.toml) are not laid out: the programs find them, as for one who installed them."""
    def copy(name, *others):
        for other in others:
            shutil.copy(os.path.join(folder, name), os.path.join(folder, other))

    def program(*words):
        subprocess.run([os.path.join(programs, "stillcut-cli"), *words], cwd=folder, check=True,
                       stdout=subprocess.DEVNULL)

    os.makedirs(os.path.join(folder, "build/release"))
    os.makedirs(os.path.join(folder, "FOLDER"))
    os.symlink(programs, os.path.join(folder, "build/release/app"))
    os.symlink(os.path.join(top, "tests"), os.path.join(folder, "tests"))
    shutil.copytree(os.path.join(top, "resources"), os.path.join(folder, "resources"),
                    ignore=shutil.ignore_patterns("pictures", "icons"))
    write(folder, "resources/scenarios/demo.toml", short_demo(top))
    write(folder, "cut.toml", MODE + CASE)
    write(folder, "tap.txt", tap())
    for number, peak in enumerate((120.0, 140.0, 110.0), start=1):
        write(folder, f"hit{number}.csv", hit(peak))
    write(folder, "frf-x.csv", tap())
    write(folder, "frf-y.csv", tap(3.5e6))
    write(folder, "face.csv", tap())
    write(folder, "above.csv", tap(3.5e6))
    write(folder, "f300.csv", forces(300.0))
    write(folder, "f900.csv", forces(900.0))
    write(folder, "CASE.json", CASE_JSON)
    tone(os.path.join(folder, "tone.wav"))
    write(folder, "knocks.csv", knocks())
    write(folder, "mine.toml", "[energy-ratio]\nchatter = 0.3\n")
    copy("resources/scenarios/air-cut.toml", "S.toml")
    for example in ("analyze_in_python.py", "read_session.py", "read_answers.py", "read_answers.m", "watch_run.py"):
        copy("resources/manual/" + example, example)
    copy("resources/profiles/simulated.toml", "P.toml", "PROFILE.toml")
    program("simulate", "resources/scenarios/demo.toml", "--out", "cut.h5")
    program("convert", "cut.h5", "cut.wav")
    copy("cut.h5", "IN", "FILE", "FILE.h5", "FOLDER/cut.h5")
    copy("cut.wav", "phone.wav")
    add_page(folder, "")


def add_page(folder, page):
    """The page's own examples of files take the place of ours; a profile's scenario becomes one of a second or two."""
    if settings := block_after(page, "## Parameter files", "["):
        write(folder, "mine.toml", settings)
    if profile := block_after(page, "## Profiles", "version"):
        write(folder, "P.toml", profile)
    for name in ("P.toml", "PROFILE.toml"):
        with open(os.path.join(folder, name), encoding="utf-8") as file:
            text = file.read()
        write(folder, name, text.replace("scenarios/demo.toml", "S.toml"))
