# SPDX-License-Identifier: Apache-2.0
"""Tables of docs/cycles/timing_model.md."""
from data import data
from formats import fixed, group, table

MEASURED = ["speed/*"]
BEFORE = "@70124d4+apart+cxx=-march=x86-64"  # the commit before what was done in RTL, built as below
VARIANTS = {  # variant: what it is, whether machines are built so
    BEFORE: ("the RTL of commit 70124d4, code for each unit, for any x86-64 processor", "no"),
    "+apart+cxx=-march=x86-64": ("today's RTL, code for each unit, as Verilator's `-O3` makes it", "no"),
    "+cxx=-march=x86-64": ("PUs, SUs and RUs share their code", "on a processor without AVX2"),
    "+": ("and for the processor's level of instructions", "the machine of `pipegs sim`"),
    "+apart+noasserts+cxx=-march=x86-64": ("code for each unit, no assertions, any processor", "no"),
    "+noasserts": ("shared code, the processor's level, no assertions", "without the effect `asserts`"),
}


def variants(point):
    """kHz of each variant, with nothing looked at and compared, over those of BEFORE."""
    found = data.speed[point]
    rows = []
    for variant, (what, kept) in VARIANTS.items():
        one = found[variant]
        rows.append(
            [
                what,
                group(one.khz),
                fixed(one.khz / found[BEFORE].khz, 2),
                group(one.compared_khz),
                fixed(one.compared_khz / found[BEFORE].compared_khz, 2),
                kept,
            ]
        )
    return table(["variant", "kHz", "ratio", "kHz, compared", "ratio", "built so"], rows)


def gain(point, variant="+noasserts"):
    """How many times as fast as before, nothing looked at."""
    return fixed(data.speed[point][variant].khz / data.speed[point][BEFORE].khz, 2)
