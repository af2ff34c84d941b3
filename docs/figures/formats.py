# SPDX-License-Identifier: Apache-2.0
"""Numbers as the pages write them, and tables. A figure that does not exist (null) is a dash."""


def dashed(function):
    return lambda value, *rest: "-" if value is None else function(value, *rest)


@dashed
def group(value):
    """1234567 -> 1 234 567"""
    return f"{round(value):,}".replace(",", " ")


@dashed
def fixed(value, digits):
    return f"{value:.{digits}f}"


@dashed
def times(value, digits=2):
    return f"{value:.{digits}f}x"


@dashed
def percent(share, digits=0):
    return f"{100 * share:.{digits}f} %"


@dashed
def change(share, digits=1):
    """0.125 -> +12.5 %; what rounds to nothing -> +0.0 %"""
    return f"{round(100 * share, digits) + 0.0:+.{digits}f} %"


@dashed
def millions(value, digits=2):
    return f"{value / 1e6:.{digits}f} M"


@dashed
def thousands(value, digits=0):
    return f"{group(value / 1e3) if digits == 0 else fixed(value / 1e3, digits)} k"


def span(form, values, *digits):
    """From the least to the largest of some values: 1.9 to 2.8."""
    values = list(values)
    low, high = form(min(values), *digits), form(max(values), *digits)
    unit = low.split(" ")[-1] if low.endswith((" %", " M", " k")) else ""
    low = low.removesuffix(" " + unit) if unit else low
    return high if low == high.removesuffix(" " + unit) else f"{low} to {high}"


def mean(values):
    values = list(values)
    return sum(values) / len(values)


def text(value):
    """A cell or a single figure: integers in groups of three; other numbers only through a format."""
    if value is None:
        return "-"
    if isinstance(value, bool) or not isinstance(value, (int, str)):
        raise TypeError(f"{value!r} needs a format: fixed, times, percent, ...")
    return value if isinstance(value, str) else group(value)


def block(lines):
    """Lines as code: what a command prints."""
    return "\n".join("    " + line if line else "" for line in lines)


def table(header, rows):
    for row in rows:
        if len(row) != len(header):
            raise ValueError(f"{len(row)} cells under {len(header)} titles: {row}")
    lines = ["| " + " | ".join(map(text, row)) + " |" for row in [header, *rows]]
    return "\n".join([lines[0], "|" + "---|" * len(header), *lines[1:]])


def at(figures, path):
    """The value at a path of keys, a.b.c; a number is a place in a list."""
    for key in path.split("."):
        figures = figures[int(key) if key.isdigit() and not hasattr(figures, "keys") else key]
    return figures


def listing(first, found, *columns):
    """A table with a row for each (title, figures) of `found`. A column is its heading, a path of keys or a function of
    the figures, and the format of the value with its other arguments."""

    def cell(figures, where, form=text, *rest):
        return form(where(figures) if callable(where) else at(figures, where), *rest)

    rows = [[title, *[cell(figures, *column[1:]) for column in columns]] for title, figures in found]
    return table([first, *[column[0] for column in columns]], rows)
