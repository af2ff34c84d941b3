# SPDX-License-Identifier: Apache-2.0
"""Lines whose names stand beside their ends, as an SVG file that is made of the data, like a page: no library, so
`--check` can make it again and compare. Colours and background are those of sim/report/page/svg.mjs.
"""
import math
from html import escape
from itertools import product

WIDTH, HEIGHT = 640, 400
LEFT, RIGHT, TOP, BOTTOM = 44, 16, 66, 48
COLORS = ("#4c8fd6", "#e0873a", "#45a173", "#c05fb4")
GRAY = "#8a8f98"
LETTER, LINE = 6.6, 15  # of a name: width of a letter, height of its lines
FREE = 9  # between a name and whatever else is drawn
HEAD = f"""<svg xmlns="http://www.w3.org/2000/svg" class="pipegs-charts" viewBox="0 0 {WIDTH} {HEIGHT}"
 width="{WIDTH}" height="{HEIGHT}" font-family="system-ui, sans-serif" font-size="12">
<style>.pipegs-charts {{ color: #1b1f24; }}
@media (prefers-color-scheme: dark) {{ .pipegs-charts {{ color: #e6e9ee; }} }}</style>
"""


def words(text, x, y, anchor="middle", **more):
    look = "".join(f' {key.replace("_", "-")}="{value}"' for key, value in ({"fill": "currentColor"} | more).items())
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}"{look}>{escape(text)}</text>'


def stroke(points, color=GRAY, width=1, dashes="none"):
    places = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
    return (
        f'<polyline points="{places}" fill="none" stroke="{color}" stroke-width="{width}" stroke-dasharray="{dashes}"/>'
    )


def between(points):
    """Places along a line, a few pixels apart."""
    found = list(points[:1])
    for (x0, y0), (x1, y1) in zip(points, points[1:]):
        steps = max(1, math.ceil(math.hypot(x1 - x0, y1 - y0) / 4))
        found += [(x0 + (x1 - x0) * i / steps, y0 + (y1 - y0) * i / steps) for i in range(1, steps + 1)]
    return found


def free_place(end, half, taken):
    """The middle of a name, so large from there, as near to the line's end as nothing else lies: below it, if it may
    be."""
    ways = sorted(product(range(-140, 141, 4), range(-60, 141, 4)), key=lambda way: math.hypot(way[0], way[1] - 24))
    for dx, dy in ways:
        x, y = end[0] + dx, end[1] + dy
        inside = LEFT + half[0] <= x <= WIDTH - RIGHT - half[0] and TOP + half[1] <= y <= HEIGHT - BOTTOM - half[1]
        if inside and not any(abs(x - a) < half[0] + FREE and abs(y - b) < half[1] + FREE for a, b in taken):
            return x, y
    return end[0], end[1] + 24


def lines(title, across, up, mark, series):
    """`series`: (name, what stands beneath it, [(x in per cent, y)]), the name beside the last point; `mark`: (y, what
    it is) of a dashed line."""
    values = [y for _, _, points in series for _, y in points]
    low, high = 10 * math.floor((min(values) - 8) / 10), 10 * math.ceil(max(values) / 10)

    def place(x, y):
        wide, tall = WIDTH - LEFT - RIGHT, HEIGHT - TOP - BOTTOM
        return LEFT + wide * x / 100, TOP + tall * (high - y) / (high - low)

    drawn = [words(title, WIDTH / 2, 20, font_size=15, font_weight="bold"), words(up, 8, TOP - 18, "start")]
    for y in range(low, high + 1, 10):
        drawn.append(stroke([place(0, y), place(100, y)], width=0.5))
        drawn.append(words(str(y), LEFT - 8, place(0, y)[1] + 4, "end"))
    for x in range(0, 101, 20):
        drawn.append(words(f"{x} %", min(place(x, low)[0], WIDTH - 20), HEIGHT - BOTTOM + 18))
    drawn.append(words(across, place(50, low)[0], HEIGHT - 10))
    taken, where = [], [[place(x, y) for x, y in points] for _, _, points in series]
    if low < mark[0] < high:
        ends = [place(0, mark[0]), place(100, mark[0])]
        drawn.append(stroke(ends, "currentColor", dashes="5 4"))
        drawn.append(words(mark[1], LEFT + 6, ends[0][1] + LINE, "start"))
        taken += between(ends)
    for points in where:
        taken += between(points)
    for color, (name, beneath, _), points in zip(COLORS, series, where):
        drawn.append(stroke(points, color, 2.5))
        drawn += [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="4" fill="{color}"/>' for x, y in points]
        half = LETTER * max(len(name), len(beneath)) / 2, LINE
        x, y = free_place(points[-1], half, taken)
        drawn.append(words(name, x, y - 3, fill=color, font_weight="bold"))
        drawn.append(words(beneath, x, y - 3 + LINE, fill=color))
        taken += [(x + half[0] * a, y + half[1] * b) for a, b in product((-1, -0.5, 0, 0.5, 1), (-1, 0, 1))]
    return HEAD + "\n".join(drawn) + "\n</svg>\n"
