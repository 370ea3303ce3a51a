# SPDX-License-Identifier: Apache-2.0
"""Plain drawings as SVG, with the constants of the C++ sources, for docs/figures/rules.py."""
import math
import pathlib
import re
import types

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
BLACK, GRAY, BLUE, RED = "#1a1a1a", "#777777", "#1f5fa8", "#b3261e"
PALE = {BLACK: "#ffffff", GRAY: "#e6e6e6", BLUE: "#dfe8f2", RED: "#f6dedb"}
MARKER = ('<marker id="{}" viewBox="0 0 8 8" refX="7" refY="4" markerWidth="7" markerHeight="7" '
          'orient="auto-start-reverse"><path d="M0 0 L8 4 L0 8 z" fill="{}"/></marker>')


def subscript(match):
    name, space, then = match.groups()
    rest = f'<tspan dx="{4 if space else 0}" dy="-4">{then}</tspan>' if then else ""
    return f'<tspan dy="4" font-size="11">{name}</tspan>{rest}'


def constants(*sources):
    """All `constexpr double` and `float` of sources below src/, by name."""
    values = {}
    for source in sources:
        for name, value in re.findall(r"constexpr (?:double|float) (k\w+) = ([^;]+?)F?;",
                                      (ROOT / "src" / source).read_text()):
            if re.fullmatch(r"[-+*/().e\d\s]+", value):
                values[name] = eval(value)
    return types.SimpleNamespace(**values)


def polar(angle, length=1.0, center=(0.0, 0.0)):
    return center[0] + length * math.cos(angle), center[1] + length * math.sin(angle)


def arc(center, radius, first, last, pieces=32):
    return [polar(first + (last - first) * k / pieces, radius, center) for k in range(pieces + 1)]


class Figure:
    """Lengths in units of `scale` pixels about `origin`, y upwards; texts lie over everything."""

    def __init__(self, name, title, width, height):
        self.name, self.title, self.size = name, title, (width, height)
        self.shapes, self.texts = [], []
        self.view((0, 0), 1.0)

    def view(self, origin, scale):
        self.origin, self.scale = origin, scale

    def at(self, p):
        return self.origin[0] + self.scale * p[0], self.origin[1] - self.scale * p[1]

    def line(self, points, color=BLACK, width=1.5, dashed=False, ends="", fill="none"):
        """ends: with arrows at its `start`, `end` or both."""
        d = " L".join("%.1f %.1f" % self.at(p) for p in points)
        more = ' stroke-dasharray="6 4"' if dashed else ""
        for end in ends.split():
            more += f' marker-{end}="url(#{color[1:]})"'
        self.shapes.append(f'<path d="M{d}" fill="{fill}" stroke="{color}" stroke-width="{width}"{more}/>')

    def area(self, points, color, opacity=1.0):
        d = " L".join("%.1f %.1f" % self.at(p) for p in points)
        self.shapes.append(f'<path d="M{d}z" fill="{PALE[color]}" opacity="{opacity}"/>')

    def circle(self, p, radius, color=BLACK, fill="none", dashed=False, width=1.5):
        x, y = self.at(p)
        more = ' stroke-dasharray="6 4"' if dashed else ""
        self.shapes.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{radius * self.scale:.1f}" fill="{fill}" '
                           f'stroke="{color}" stroke-width="{width}"{more}/>')

    def dot(self, p, color=BLACK, size=3.5):
        x, y = self.at(p)
        self.shapes.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{size}" fill="{color}"/>')

    def cross(self, p, color=BLACK, size=0.25):
        for sign in (-1, 1):
            self.line([(p[0] - size, p[1] - sign * size), (p[0] + size, p[1] + sign * size)], color, 2)

    def robot(self, p, color, name="", velocity=None, radius=1.0, shift=(0, 0)):
        """The name stands in the disc, moved by so many pixels."""
        self.circle(p, radius, color, PALE[color])
        if velocity:
            self.arrow(p, (p[0] + velocity[0], p[1] + velocity[1]), color)
        self.text(p, name, color, "middle", shift[0], shift[1] + 5, bold=True)

    def ghost(self, p, color):
        self.circle(p, 1.0, color, "none", dashed=True)

    def arrow(self, p, q, color=BLACK, dashed=False):
        self.line([p, q], color, 2, dashed, "end")

    def wall(self, *points):
        self.line(points, BLACK, 5)

    def length(self, p, q, text, anchor="middle", dx=0.0, dy=-5.0):
        """A measure between two points; the text stands at its middle."""
        self.line([p, q], BLACK, 1, False, "start end")
        self.text(((p[0] + q[0]) / 2, (p[1] + q[1]) / 2), text, BLACK, anchor, dx, dy)

    def text(self, p, text, color=BLACK, anchor="start", dx=0.0, dy=0.0, bold=False):
        if not text:
            return
        x, y = self.at(p)
        more = ' font-weight="bold"' if bold else ""
        text = re.sub(r"_(\w+)( ?)(&\w+;|.)?", subscript, text)
        self.texts.append(f'<text x="{x + dx:.1f}" y="{y + dy:.1f}" fill="{color}" '
                          f'text-anchor="{anchor}"{more}>{text}</text>')

    def svg(self):
        width, height = self.size
        markers = "".join(MARKER.format(color[1:], color) for color in PALE)
        return "\n".join([
            f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" '
            f'height="{height}" font-family="DejaVu Sans, Verdana, Arial, sans-serif" font-size="14">',
            f"<title>{self.title}</title>", f"<defs>{markers}</defs>",
            f'<clipPath id="all"><rect width="{width}" height="{height}"/></clipPath>',
            '<rect width="100%" height="100%" fill="#ffffff"/>',
            '<g clip-path="url(#all)">', *self.shapes, "</g>",
            '<g stroke="#ffffff" stroke-width="4" stroke-linejoin="round" paint-order="stroke">',
            *self.texts, "</g>", "</svg>", ""])


def graph(figure, origin, width, ticks, points, x_name, y_name):
    """y from 0 to 1 over x; ticks: (x, text)."""
    figure.view(origin, 1.0)
    scale = width / ticks[-1][0]
    figure.line([(0, 0), (width + 12, 0)], BLACK, 1, False, "end")
    figure.line([(0, 0), (0, 78)], BLACK, 1, False, "end")
    figure.line([(0, 60), (-4, 60)], BLACK, 1)
    figure.text((0, 60), "1", BLACK, "end", -8, 5)
    for x, text in ticks:
        figure.line([(scale * x, 0), (scale * x, -4)], BLACK, 1)
        figure.text((scale * x, 0), text, BLACK, "middle", 0, 18)
    figure.line([(scale * x, 60 * y) for x, y in points], BLUE, 2.5)
    figure.text((width, 0), x_name, BLACK, "end", 0, 37)
    figure.text((10, 78), y_name, BLACK, "start", 0, 4)
