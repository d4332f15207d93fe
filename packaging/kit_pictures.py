"""The picture of the chapter on hardware: three kits, from the spindle to the computer."""
import os

from svg_plot import text

ROW = 120
SENSOR, STRUCTURE, BOX = "#c2410c", "#d4d4d4", "#c7d9f0"
KITS = [  # name, sensor, what is between, cable into it, cable into the computer
    ("microphone", "measurement microphone", "USB sound card", "phantom power", "audio class"),
    ("IEPE", "accelerometer, 100 mV/g", "USB interface with IEPE", "coaxial, 2 to 4 mA", "audio class"),
    ("MEMS board", "MEMS accelerometer", "microcontroller", "SPI, or analog and ADC", "serial, counted frames"),
]


def box(x, y, width, height, colour):
    return f'<rect x="{x}" y="{y}" width="{width}" height="{height}" fill="{colour}" stroke="#555"/>'


def line(x, y, width):
    return f'<path d="M{x},{y}h{width}m-7,-4l7,4l-7,4" stroke="#0b5cad" fill="none" stroke-width="2"/>'


def spindle(y):
    """Spindle housing, holder and tool from the side."""
    return [box(30, y, 64, 44, STRUCTURE), box(46, y + 44, 32, 22, "#bcbcbc"), box(56, y + 66, 12, 26, "#8f8f8f"),
            text(62, y + 26, "spindle")]


def kit(number, name, sensor, between, first, second):
    y = number * ROW + 16
    shapes = spindle(y)
    if number == 0:  # apart from the spindle, pointed at the tool
        shapes += [box(136, y + 66, 26, 12, SENSOR), text(150, y + 98, sensor)]
        start, level = 162, y + 72
    else:  # on the housing, beside the lower bearing
        shapes += [box(94, y + 24, 14, 14, SENSOR), text(150, y + 98, sensor)]
        start, level = 108, y + 31
    shapes += [line(start, level, 288 - start), text((start + 288) / 2, level - 8, first, size=10),
               box(288, level - 18, 150, 36, BOX), text(363, level + 4, between),
               line(438, level, 102), text(489, level - 8, "USB", size=10),
               box(540, level - 18, 90, 36, "#e2e2e2"), text(585, level + 4, "computer"),
               text(489, level + 32, second, size=10), text(363, level - 26, name, size=12)]
    return shapes


def kits(out):
    height = ROW * len(KITS) + 10
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" width="660" height="{height}" viewBox="0 0 660 {height}" '
             'font-family="sans-serif">', '<rect width="100%" height="100%" fill="#fff"/>']
    for number, row in enumerate(KITS):
        parts += kit(number, *row)
    with open(os.path.join(out, "kits.svg"), "w", encoding="utf-8") as file:
        file.write("\n".join(parts + ["</svg>"]) + "\n")
