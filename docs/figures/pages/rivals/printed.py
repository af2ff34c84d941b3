# SPDX-License-Identifier: Apache-2.0
"""The table of docs/rivals/terms.md: every figure that the paper prints, beside ours."""
from data import data
from formats import fixed, group, percent, span, table, times
from measurements import FOUR
from pages.silicon import energy, silicon as chip

MEASURED = ["printed/*", "ladder/*", "equal_area/*", "energy/*", "silicon/dop"]
HEAD = ["paper", "what", "printed", "RTL, equal lanes", "equal area", "why they differ", "command"]
LADDER = "`pipegs ladder`"
PROFILE, SILICON = "`pipegs profile`", "`pipegs silicon --design dop`"


def rtl(value, form, *rest):
    """Of each scene's ladder."""
    return span(form, [value(data.ladder[scene]) for scene in FOUR], *rest)


def equal(slow, fast):
    at = data.equal_area
    return span(times, [at[scene][slow].us / at[scene][fast].us for scene in FOUR])


def profiled(value, form, *rest):
    return span(form, [value(data.printed[scene]) for scene in FOUR], *rest)


def speedup(what, slow, fast, paper, why):
    ours = rtl(lambda one: one[slow].cycles / one[fast].cycles, times)
    return ["Fig. 9", what, f"up to {paper}x", ours, equal(slow, fast), why, LADDER]


def ratio(what, point, paper, why):
    ours = rtl(lambda one: one[point].raster_over_sort, fixed, 2)
    return ["Fig. 8a", what, paper, ours, "as equal lanes", why, LADDER]


def pipeline():
    """Fig. 3, 8 and 9: where time goes, and what the ideas are worth."""
    shares = [lambda one, stage=stage: one.stages[stage] for stage in ("preprocess", "sort", "raster")]
    hidden = rtl(
        lambda one: one.dop.exposed_share * one.dop.cycles / (one.tspp.exposed_share * one.tspp.cycles), percent, 1
    )
    rows = [
        ["Fig. 3a", "rasterization, share of the time", "about 70 %", profiled(shares[2], percent),
         "as equal lanes", "theirs is a GPU's", PROFILE],
        ["Fig. 3a", "preprocessing before all else, share of the frame", "about 15 %",
         rtl(lambda one: one.baseline.exposed_share, percent), "as equal lanes",
         "a GPU's memory and cores; here four PUs read every Gaussian first", LADDER],
        ["Fig. 3a", "bubbles", "69 %", rtl(lambda one: one.baseline.bubbles, percent),
         "as equal lanes", "the RTL's are the RUs' alone", LADDER],
        ratio("raster / sort, Baseline", "baseline", "7.48", "a pixel costs its operations there, a cycle here"),
        ratio("raster / sort, DPC", "dpc", "5.71", "the same"),
        ratio("raster / sort, DPC + TSPP", "tspp", "1.83", "the RUs wait for alphas from memory"),
        ["Fig. 8a", "bubbles fewer by HGR", "76.2 %",
         rtl(lambda one: 1 - one.tspp.bubbles / one.baseline.bubbles, percent), "-",
         "alphas through memory add bubbles", LADDER],
        ["Fig. 8b", "preprocessing that DOP leaves exposed", "37 %", hidden, "-",
         "windows begin with the nearest layer alone; the abstract's 63 % are the same figure", LADDER],
        speedup("DPC + TSPP over Baseline", "baseline", "tspp", "2.33", "alphas do not fit the chip"),
        speedup("DOP over that", "tspp", "dop", "1.22", "it also saves trips of alphas to memory"),
        speedup("DOP over Baseline", "baseline", "dop", "2.85", "both"),
    ]  # fmt: skip
    return table(HEAD, rows)


def order_db():
    """What layers cost scenes that were not trained for them."""
    return rtl(lambda one: one.dop.psnr_order_db, fixed, 0)


def reuse():
    """Fig. 3b, 4 and 5b: how much can be used again. Counts: no lanes and no area are in them."""
    tiles = {one.tile: one for one in data.printed.own.arithmetic}
    direct = data.printed.own.direct
    saved = 1 - tiles[16].multiplications / direct.multiplications
    all_saved = 1 - (tiles[16].multiplications + tiles[16].additions) / (direct.multiplications + direct.additions)
    costs = [f"{fixed(one.multiplications, 2)} x, {fixed(one.additions, 2)} +" for one in tiles.values()]
    scenes = "other scenes; a tile counts here only if a pixel of it has alpha >= 1/255"
    rows = [
        ["Fig. 3b", "Gaussians in two tiles of 16 px or more", "over 70 %", profiled(lambda one: one.in_two, percent),
         scenes, PROFILE],
        ["Fig. 4a", "multiplications fewer by DPC", "96.2 %", percent(saved, 1), "-", PROFILE],
        ["Fig. 4a", "operations fewer by DPC", "76.9 %", percent(all_saved, 1), "-", PROFILE],
        ["Fig. 4b", "operations of a pixel, tiles of 8, 16, 32, 64 px", "a chart without numbers", "; ".join(costs),
         "-", PROFILE],
        ["Fig. 5b", "tiles of a Gaussian", "2.6 to 6.7", profiled(lambda one: one.mean_tiles, fixed, 1), scenes,
         PROFILE],
        ["Fig. 5b", "coefficients' cost with HGR", "0.15 to 0.52", profiled(lambda one: one.coefficients, fixed, 2),
         "once per Gaussian; once per Gaussian and window it is "
         + profiled(lambda one: one.coefficients_window, fixed, 2), PROFILE],
    ]  # fmt: skip
    return table(["paper", "what", "printed", "ours", "why they differ", "command"], rows)


def silicon():
    """Table 2 beside `dop`: mid of the ranges; power at full speed."""
    area, power = data.silicon.dop, [data.energy[scene].dop.rows for scene in FOUR]
    rows = [
        [unit, fixed(mm2, 3), fixed(area[unit].area_mm2.mid, 3), fixed(energy.PAPER[unit], 3),
         span(fixed, [one[unit].w_full.mid for one in power], 3)]
        for unit, mm2 in chip.PAPER.items()
    ]  # fmt: skip
    return table(["unit", "paper, mm2", "ours, mm2", "paper, W", "ours, W"], rows)
