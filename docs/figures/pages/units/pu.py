# SPDX-License-Identifier: Apache-2.0
"""Tables of docs/units/pu.md."""
from data import data
from formats import fixed, group, table
from pages.numerics.numbers import small, two  # noqa: F401  (the page uses them)
from pages.silicon.silicon import blocks

MEASURED = [
    "prints/*/pu_*",
    "prints/*/recip",
    "prints/*/rsqrt",
    "prints/*/exp2",
    "memories/dop",
]
(conic,) = data.prints.pu.pu_conic.lines
(recip,) = [line for line in data.prints.lib.recip.lines if line.bits == 26]
(rows,) = data.prints.pu.pu_rows.lines
(exp2,) = data.prints.lib.exp2.lines


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


def power():
    """Error of the power by the length of the Gaussians."""
    rows = [
        [f"{group(line.sigma)} px", *[f"{line[name]:.1e}" for name in ("worst", "rms", "quantised")]]
        for line in data.prints.pu.pu_coeff.lines
    ]
    return table(["sigma up to", "worst", "rms", "from the quantised covariance, worst"], rows)


def regions():
    """Regions that count and those kept beyond."""
    rows = [
        [f"{group(line.sigma)} px", f"{line.regions:.3g}", f"{fixed(line.percent, 1)} %", f"{line.boxes:.3g}"]
        for line in data.prints.pu.pu_intersect.lines
    ]
    return table(["sigma up to", "regions that hold a counting pixel", "kept beyond", "regions of the box"], rows)
