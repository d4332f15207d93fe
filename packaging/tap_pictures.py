"""The pictures of the chapter on tap tests: where hammer and sensor stand, and tips coupled to one holder."""
import csv
import os

from svg_plot import Plot, text

STICK_OUTS = (55, 65, 75)  # mm


def mode_column(hertz, stiffness):
    """Compliance of a holder in its spindle: two modes, of which the second is stiffer."""
    total = 0.0
    for natural, damping, k in ((900.0, 0.04, stiffness), (2400.0, 0.03, 3.0 * stiffness)):
        ratio = hertz / natural
        total += 1.0 / (k * complex(1.0 - ratio * ratio, 2.0 * damping * ratio))
    return total


def holder_table(stiffness, last=5000):
    rows = ["Frequency [Hz],Real [m/N],Imag [m/N]"]
    for hertz in range(200, last + 1, 5):
        h = mode_column(float(hertz), stiffness)
        rows.append(f"{hertz},{h.real:.9e},{h.imag:.9e}")
    return "\n".join(rows) + "\n"


def coupling(folder, out, cli):
    for name, stiffness in (("face.csv", 6e7), ("above.csv", 7e7)):
        with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
            file.write(holder_table(stiffness))
    curves = []
    for stick_out in STICK_OUTS:
        cli(folder, "couple", "face.csv", "--cross", "above.csv", "--spacing", "40", "--diameter", "12",
            "--stickout", str(stick_out), "--flutes", "26", "--loss", "0.03", "--out", "tip.csv")
        with open(os.path.join(folder, "tip.csv"), encoding="utf-8") as file:
            rows = [[float(cell) for cell in row] for row in list(csv.reader(file))[1:]]
        curves.append((f"{stick_out} mm out", [row[0] for row in rows], [1e6 * row[1] for row in rows]))
    low, high = (f(f(ys) for _, _, ys in curves) for f in (min, max))
    plot = Plot("frequency [Hz]", (200, 5000))
    plot.add("Re [um/N]", (1.1 * low, 1.1 * high), curves)
    plot.write(os.path.join(out, "coupling.svg"))


def view(x, axis, note):
    """Spindle, holder and tool from the side; the hammer from the left, the sensor on the right."""
    shapes = [f'<rect x="{x + a:.1f}" y="{y:.1f}" width="{w:.1f}" height="{h:.1f}" fill="{c}" stroke="#555"/>'
              for a, y, w, h, c in ((-45, 14, 90, 34, "#d4d4d4"), (-26, 48, 52, 52, "#bcbcbc"), (-9, 100, 18, 40, "#a3a3a3"),
                                    (-8, 140, 16, 56, "#8f8f8f"), (9, 184, 14, 11, "#c2410c"), (-92, 182, 30, 16, "#0b5cad"))]
    shapes.append(f'<path d="M{x - 62:.1f},190.0H{x - 13:.1f}m-8,-5l8,5l-8,5" stroke="#0b5cad" fill="none" stroke-width="2"/>')
    words = [(x, 35, "spindle"), (x, 78, "holder"), (x - 77, 175, "hammer"), (x + 62, 180, "accelerometer"),
             (x + 62, 193, "at the tip"), (x, 218, f"along {axis}: {note}")]
    return shapes + [text(*word) for word in words]


def setup(out):
    parts = ['<svg xmlns="http://www.w3.org/2000/svg" width="640" height="230" viewBox="0 0 640 230" '
             'font-family="sans-serif">', '<rect width="100%" height="100%" fill="#fff"/>']
    parts += view(160.0, "x", "the direction of feed") + view(480.0, "y", "square to it") + ["</svg>"]
    with open(os.path.join(out, "tap-setup.svg"), "w", encoding="utf-8") as file:
        file.write("\n".join(parts) + "\n")
