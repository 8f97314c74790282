"""Lines, areas, arrows and words in the plane of a picture, written as SVG. Numbers are rounded, so that every machine writes the same."""
import html
import math

PAPER, INK, SOFT, BODY1, BODY2, RIGHT, WRONG = "#ffffff", "#1c2127", "#58626e", "#4c78a8", "#e08a2e", "#15803d", "#c62828"
# The same in a dark window.
DARK = dict(zip((PAPER, INK, SOFT, BODY1, BODY2, RIGHT, WRONG), ("#1d232a", "#dfe4ea", "#9aa5b1", "#7aa7d8", "#f0a860", "#4cc27a", "#ff8a80")))
FONT = "system-ui, 'DejaVu Sans', sans-serif"


def dark_style():
    rules = "".join(f'[fill="{light}"]{{fill:{dark}}}[stroke="{light}"]{{stroke:{dark}}}' for light, dark in DARK.items())
    return f"<style>@media (prefers-color-scheme: dark) {{{rules}}}</style>"


class Picture:
    """`scale` pixels for a unit; (x, y) = (0, 0) is drawn at pixel `origin`, y upwards."""

    def __init__(self, width, height, scale, origin, title):
        self.scale, self.origin = scale, origin
        self.parts = [
            f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" height="{height}" role="img">',
            f"<title>{html.escape(title)}</title>",
            dark_style(),
            f'<rect width="{width}" height="{height}" rx="8" fill="{PAPER}"/>',
        ]

    def at(self, point, origin=None, scale=None):
        """The same picture with another origin and scale: a second panel."""
        panel = object.__new__(Picture)
        panel.scale, panel.origin, panel.parts = scale or self.scale, origin or point, self.parts
        return panel

    def pixel(self, point):
        return self.origin[0] + self.scale * point[0], self.origin[1] - self.scale * point[1]

    def path(self, points, colour, width=1.6, fill="none", opacity=0.2, dashes="", closed=False):
        steps = " L".join("{:.1f} {:.1f}".format(*self.pixel(point)) for point in points)
        shade = f' fill="{fill}" fill-opacity="{opacity}"' if fill != "none" else ' fill="none"'
        dash = f' stroke-dasharray="{dashes}"' if dashes else ""
        end = "Z" if closed else ""
        self.parts.append(f'<path d="M{steps}{end}" stroke="{colour}" stroke-width="{width}" stroke-linejoin="round"{shade}{dash}/>')

    def body(self, points, colour):
        self.path(points, colour, fill=colour, closed=True)

    def dot(self, point, colour, radius=3.6):
        x, y = self.pixel(point)
        self.parts.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{radius}" fill="{colour}"/>')

    def arrow(self, start, end, colour, width=2.2, head=9):
        (x0, y0), (x1, y1) = self.pixel(start), self.pixel(end)
        length = math.hypot(x1 - x0, y1 - y0)
        ux, uy = (x1 - x0) / length, (y1 - y0) / length
        self.parts.append(
            f'<path d="M{x0:.1f} {y0:.1f} L{x1 - ux * head:.1f} {y1 - uy * head:.1f}" stroke="{colour}" stroke-width="{width}"/>'
            f'<path d="M{x1:.1f} {y1:.1f} L{x1 - ux * head - uy * head * 0.42:.1f} {y1 - uy * head + ux * head * 0.42:.1f} '
            f'L{x1 - ux * head + uy * head * 0.42:.1f} {y1 - uy * head - ux * head * 0.42:.1f}Z" fill="{colour}"/>')

    def text(self, point, words, colour=INK, size=14, anchor="start", weight="normal"):
        x, y = self.pixel(point)
        self.label((x, y), words, colour, size, anchor, weight)

    def label(self, pixel, words, colour=INK, size=14, anchor="start", weight="normal"):
        self.parts.append(f'<text x="{pixel[0]:.1f}" y="{pixel[1]:.1f}" font-family="{FONT}" font-size="{size}" '
                          f'font-weight="{weight}" text-anchor="{anchor}" fill="{colour}">{html.escape(words)}</text>')

    def box(self, corner, size, lines, colour=INK, fill="none"):
        """A rectangle and its lines of words, the first one heavier; corner and size in pixels."""
        (x, y), (width, height) = corner, size
        shade = f'fill="{fill}" fill-opacity="0.16"' if fill != "none" else 'fill="none"'
        self.parts.append(f'<rect x="{x}" y="{y}" width="{width}" height="{height}" rx="5" stroke="{colour}" stroke-width="1.4" {shade}/>')
        top = y + height / 2 + 5 - 9 * (len(lines) - 1)
        for row, words in enumerate(lines):
            self.label((x + width / 2, top + 18 * row), words, INK if row == 0 else SOFT, 14 if row == 0 else 13, "middle", "600" if row == 0 else "normal")

    def written(self):
        return "\n".join([*self.parts, "</svg>", ""])


class Plan(Picture):
    """Boxes and arrows, in pixels from the upper left corner."""

    def __init__(self, width, height, title):
        super().__init__(width, height, 1, (0, 0), title)

    def pixel(self, point):
        return point

    def line_to(self, *points, colour=SOFT):
        """An arrow through these points."""
        if len(points) > 2:
            self.path(points[:-1], colour, 1.8)
        self.arrow(points[-2], points[-1], colour, 1.8, 8)
