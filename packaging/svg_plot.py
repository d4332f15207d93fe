"""Small line plots as SVG, one panel above the other over one axis: enough for the manual, without a plotting library."""
import math

WIDTH, LEFT, RIGHT, PANEL, GAP, TOP, BOTTOM = 640, 64, 12, 84, 14, 12, 34
COLOURS = ["#0b5cad", "#c2410c", "#15803d", "#7c3aed", "#0f766e", "#a16207"]
STATES = {"air": "#d4d4d4", "stable": "#c7d9c9", "onset": "#f5c451", "chatter": "#d9534f"}


def text(x, y, words, anchor="middle", size=11, turn=False):
    words = words.replace("&", "&amp;").replace("<", "&lt;")
    turned = f' transform="rotate(-90 {x:.1f} {y:.1f})"' if turn else ""
    return f'<text x="{x:.1f}" y="{y:.1f}" font-size="{size}" text-anchor="{anchor}"{turned}>{words}</text>'


def ticks(low, high, logarithmic, most=4):
    if logarithmic:
        first, last = math.ceil(math.log10(low)), math.floor(math.log10(high))
        step = max(1, math.ceil((last - first) / most))
        return [10.0 ** k for k in range(first, last + 1, step)]
    raw = (high - low) / most
    unit = 10.0 ** math.floor(math.log10(raw))
    step = next(unit * k for k in (1, 2, 2.5, 5, 10) if unit * k >= raw * 0.999)
    return [k * step for k in range(math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9) + 1)]


class Plot:
    """add() panels, then write(). Ranges are (low, high); a curve is (label, xs, ys); a mark is (label, y)."""

    def __init__(self, x_label, x_range):
        self.x_label, self.x_range, self.parts, self.y = x_label, x_range, [], TOP

    def _x(self, value):
        low, high = self.x_range
        return LEFT + (value - low) / (high - low) * (WIDTH - LEFT - RIGHT)

    def add(self, label, y_range, curves, logarithmic=False, marks=(), dots=False):
        scale = (lambda v: math.log10(max(v, 1e-300))) if logarithmic else float
        low, high = (scale(v) for v in y_range)
        top, out = self.y, self.parts

        def place(value):
            return top + PANEL * (1.0 - (min(max(scale(value), low), high) - low) / (high - low))

        out.append(f'<rect x="{LEFT}" y="{top}" width="{WIDTH - LEFT - RIGHT}" height="{PANEL}" fill="none" '
                   'stroke="#888"/>')
        for tick in ticks(*y_range, logarithmic):
            out.append(f'<path d="M{LEFT},{place(tick):.1f}h{WIDTH - LEFT - RIGHT}" stroke="#e2e2e2"/>')
            out.append(text(LEFT - 5, place(tick) + 4, f"{tick:g}", "end", 10))
        out.append(text(16, top + PANEL / 2, label, turn=True))
        for name, y in marks:
            out.append(f'<path d="M{LEFT},{place(y):.1f}h{WIDTH - LEFT - RIGHT}" stroke="#555" stroke-dasharray="5 3"/>')
            out.append(text(WIDTH - RIGHT - 4, place(y) - 3, name, "end", 10))
        right = LEFT + 8
        for number, (name, xs, ys) in enumerate(curves):
            colour = COLOURS[number % len(COLOURS)]
            points = [(self._x(x), place(y)) for x, y in zip(xs, ys)
                      if self.x_range[0] <= x <= self.x_range[1] and math.isfinite(y)]
            if dots:
                out.extend(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="1.6" fill="{colour}"/>' for x, y in points)
            else:
                line = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
                out.append(f'<polyline points="{line}" fill="none" stroke="{colour}" stroke-width="1.6"/>')
            if name:
                out.append(f'<rect x="{right}" y="{top + 8}" width="12" height="3" fill="{colour}"/>')
                out.append(text(right + 16, top + 13, name, "start", 10))
                right += 34 + 6 * len(name)
        self.y += PANEL + GAP

    def states(self, label, changes, line=None):
        """A band of what a detector said: changes are (t, state) in their order. `line`: where it began in truth."""
        ends = [t for t, _ in changes[1:]] + [self.x_range[1]]
        for (begin, state), end in zip(changes, ends):
            begin, end = max(begin, self.x_range[0]), min(end, self.x_range[1])
            if end > begin:
                self.parts.append(f'<rect x="{self._x(begin):.1f}" y="{self.y}" width="{self._x(end) - self._x(begin):.1f}" '
                                  f'height="18" fill="{STATES[state]}"/>')
                if self._x(end) - self._x(begin) > 46:
                    self.parts.append(text(self._x((begin + end) / 2), self.y + 13, state, size=10))
        self.parts.append(text(LEFT - 5, self.y + 13, label, "end", 10))
        self.y += 18 + GAP
        if line is not None:
            self.parts.append(f'<path d="M{self._x(line):.1f},{TOP}V{self.y - GAP}" stroke="#d9534f" stroke-dasharray="2 2"/>')

    def write(self, path):
        bottom = self.y - GAP
        for tick in ticks(*self.x_range, False, 8):
            self.parts.append(text(self._x(tick), bottom + 14, f"{tick:g}", size=10))
        self.parts.append(text((LEFT + WIDTH - RIGHT) / 2, bottom + 28, self.x_label))
        with open(path, "w", encoding="utf-8") as file:
            file.write(f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{bottom + BOTTOM}" '
                       f'viewBox="0 0 {WIDTH} {bottom + BOTTOM}" font-family="sans-serif">\n'
                       '<rect width="100%" height="100%" fill="#fff"/>\n' + "\n".join(self.parts) + "\n</svg>\n")
