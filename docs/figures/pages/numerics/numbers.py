# SPDX-License-Identifier: Apache-2.0
"""Figures of docs/numerics/numbers.md: what unit tests print."""
from data import data
from formats import fixed, group, percent, table

MEASURED = ["prints/*"]


def worst(test, name, **where):
    """The largest of a test's figures, of all lines that it prints or of those where a number is as said."""
    lines = data.prints.all[test]
    return max(line[name] for line in lines if all(line[key] == one for key, one in where.items()))


def two(test, name="worst", digits=1):
    """A power of two."""
    return f"2^{worst(test, name):.{digits}f}"


def plain(test, name, digits, **where):
    return fixed(worst(test, name, **where), digits)


def small(test, name="worst", **where):
    """5.9e-8"""
    mantissa, exponent = f"{worst(test, name, **where):.1e}".split("e")
    return f"{mantissa}e{int(exponent)}"


def share(test):
    return percent(worst(test, "percent") / 100, 1)


def left():
    """Units of dopu_depth's slack that no Gaussian needed."""
    return fixed(min(line.left for line in data.prints.all.dopu_depth), 1)


def flipped():
    return f"{group(worst('pu_rows', 'flipped'))} of {group(worst('pu_rows', 'pixels'))} flipped"


def frame():
    """PSNR of a random scene at three widths."""
    demanded = {"8": ("8, 12 bits (`dop`)", 58), "10": ("10, 14 bits", 67.5), "12": ("12, 16 bits", 70.5)}
    return table(
        ["alpha, colour", "PSNR, dB", "demanded, dB"],
        [[title, fixed(data.prints.golden[bits], 1), fixed(least, 1)] for bits, (title, least) in demanded.items()],
    )


def gain(more, less):
    return f"{data.prints.golden[more] - data.prints.golden[less]:.1f} dB"
