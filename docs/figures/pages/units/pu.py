# SPDX-License-Identifier: Apache-2.0
"""Tables of docs/units/pu.md."""
from data import data
from formats import fixed, group, listing
from pages.numerics.numbers import small, two  # noqa: F401  (the page uses them)
from pages.silicon.silicon import blocks

MEASURED = ["prints/all", "memories/dop"]
PRINTS = data.prints.all
(conic,) = PRINTS.pu_conic
(recip,) = [line for line in PRINTS.recip if line.bits == 26]
(rows,) = PRINTS.pu_rows
(exp2,) = PRINTS.exp2


def area(*modules):
    """kNAND2 of these modules in one of the four PUs, with what each holds of rtl/lib."""
    return fixed(blocks(*modules) / 4e3, 0)


def tenths(*modules):
    """The same, to a tenth."""
    return fixed(blocks(*modules) / 4e3, 1)


def store_kb(place):
    """KB of an SRAM of one alpha store of `dop`."""
    (row,) = [row for row in data.memories.dop if place in row.place]
    return fixed(row.width * row.depth / 8192, 1)


def words(place):
    """Words and bits of an SRAM of `dop`."""
    (row,) = [row for row in data.memories.dop if place in row.place]
    return f"{row.depth} words of {row.width} bits"


def power():
    """Error of the power by the length of the Gaussians."""
    return listing(
        "sigma up to",
        [(f"{group(line.sigma)} px", line) for line in PRINTS.pu_coeff],
        ("worst", "worst", "{:.1e}".format),
        ("rms", "rms", "{:.1e}".format),
        ("from the quantised covariance, worst", "quantised", "{:.1e}".format),
    )


def regions():
    """Regions that count and those kept beyond."""
    return listing(
        "sigma up to",
        [(f"{group(line.sigma)} px", line) for line in PRINTS.pu_intersect],
        ("regions that hold a counting pixel", "regions", "{:.3g}".format),
        ("kept beyond", lambda line: f"{fixed(line.percent, 1)} %"),
        ("regions of the box", "boxes", "{:.3g}".format),
    )
