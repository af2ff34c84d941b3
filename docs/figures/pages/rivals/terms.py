# SPDX-License-Identifier: Apache-2.0
"""Tables of docs/rivals/terms.md: the paper's printed figures held against each other, and beside ours.

Time is in units of a tile's sort. Lists pass SUs and RUs side by side, so a frame takes P + R: P the exposed
preprocessing, R the rasterization, which hides the sort; the paper's raster / sort is R.
"""
from data import data
from formats import change, fixed, percent, span, table, times
from measurements import CHARTED, FOUR
from pages.cycles.ladder import rtl
from pages.frames import over, work
from pages.silicon import energy, silicon

MEASURED = ["model/*", "work/*", "rtl/own", "profile/*", "silicon/*"]
BASE, DPC, HGR = 7.48, 5.71, 1.83  # raster / sort, Sec. 5.3.1
HGR_OVER, DOP_OVER, ALL = 2.33, 1.22, 2.85  # Sec. 5.3.2
FRONT, MORE, LEFT, HIDDEN, FEWER = 0.15, 1.2, 0.37, 0.63, 0.762
RASTER, BUBBLES = 0.70, 0.69  # Fig. 3a
# Operations of a pixel: power in full, power by DPC in a tile of 16 px, exponential with opacity, blending by Eq. 2.
POWER, POWER_DPC, EXP, BLEND = 11, 2 + 8 / 16 + 10 / 256, 16, 9
RENDERING_UNITS, ROW_UNITS = 64, 32


def rows():
    """(figure, equation, what it gives, what the paper prints)."""
    every = POWER + EXP + BLEND
    others = (POWER - POWER_DPC) / (BASE / DPC - 1) - POWER_DPC
    front = FRONT / (1 - FRONT) * BASE
    base = front + BASE
    hgr = base / HGR_OVER
    hgr_front = hgr - HGR
    hgr_share = (1 - 1 / DOP_OVER) / HIDDEN
    on_rows = (POWER_DPC + EXP) / BLEND * HGR * RENDERING_UNITS / ROW_UNITS
    front_of_both = (BASE - HGR_OVER * HGR) / (HGR_OVER * MORE - 1)
    return [
        ("power, operations saved (Fig. 4a)", "1 - (10 + 16 x 8 + 256 x 2) / (256 x 11)", 1 - POWER_DPC / POWER, 0.769),
        ("power, multiplications saved (Fig. 4a)", "1 - (4 + 16 x 4) / (256 x 7)", 1 - (4 + 16 * 4) / (256 * 7), 0.962),
        ("operations beside the power", "(11 + x) / (2.54 + x) = 7.48 / 5.71; counted: 16 + 9", others, EXP + BLEND),
        ("of those, blending", "(2.54 + x) / y = 5.71 / 1.83; counted: 9", (POWER_DPC + others) * HGR / DPC, BLEND),
        ("raster / sort, DPC", "7.48 x (2.54 + 16 + 9) / (11 + 16 + 9)", BASE * (POWER_DPC + EXP + BLEND) / every, DPC),
        ("raster / sort, HGR", "7.48 x 9 / (11 + 16 + 9)", BASE * BLEND / every, HGR),
        ("DOP over Baseline", "2.33 x 1.22", HGR_OVER * DOP_OVER, ALL),
        ("preprocessing, HGR over Baseline (Fig. 3c)",
         "P = 15 % of P + 7.48; (P + 7.48) / (P' + 1.83) = 2.33; P' / P", hgr_front / front, MORE),
        ("HGR over Baseline", "P as above, P' = 1.2 P", base / (MORE * front + HGR), HGR_OVER),
        ("preprocessing of Baseline's frame", "2.33 and P' = 1.2 P; P / (P + 7.48)",
         front_of_both / (front_of_both + BASE), FRONT),
        ("bubbles: SUs beside RUs (Fig. 3a)", "(7.48 - 1) / (P + 7.48)", (BASE - 1) / base, BUBBLES),
        ("bubbles: PUs, SUs and RUs (Fig. 3a)", "1 - (15 % + 70 % + 70 % / 7.48) / 3",
         1 - (FRONT + RASTER + RASTER / BASE) / 3, BUBBLES),
        ("bubbles less by HGR, of time", "1 - (1.83 - 1) / (7.48 - 1)", 1 - (HGR - 1) / (BASE - 1), FEWER),
        ("bubbles less by HGR, of the frame", "1 - 2.33 (1.83 - 1) / (7.48 - 1)",
         1 - HGR_OVER * (HGR - 1) / (BASE - 1), FEWER),
        ("DOP over HGR", "(P' + 1.83) / (0.37 P' + 1.83)", hgr / (LEFT * hgr_front + HGR), DOP_OVER),
        ("DOP over HGR", "(P' + 1.83) / (0.37 P + 1.83)", hgr / (LEFT * front + HGR), DOP_OVER),
        ("preprocessing hidden by DOP", "(1 - 1 / 1.22) (P' + 1.83) / P'", (1 - 1 / DOP_OVER) * hgr / hgr_front,
         HIDDEN),
        ("Baseline's frame over its sort", "1.22 and 63 %: P' is 28.6 % of HGR's frame; 2.33 x 1.83 / (1 - 28.6 %); at "
         "least 7.48", HGR_OVER * HGR / (1 - hgr_share), BASE),
        ("operations a Row Unit must do in a cycle",
         "(2.54 + 16) / 9 x 1.83 x 64 / 32 lanes over P' - P; one as the RUs", on_rows / (hgr_front - front), 1),
        ("HGR over Baseline, one operation a cycle",
         "alphas on 32 Row Units after the projections: (P + 7.48) / (P + 7.54 + 1.83)", base / (front + on_rows + HGR),
         HGR_OVER),
    ]  # fmt: skip


def closed():
    """The paper's figures held against each other."""
    cells = [
        [name, how, fixed(value, 3), f"{paper:g}", change(value / paper - 1)] for name, how, value, paper in rows()
    ]
    return table(["figure", "equation", "gives", "paper", "residue"], cells)


def closed_of(start, place=0):
    """The value of a row of the closed form, by how its figure begins."""
    return [value for name, _, value, _ in rows() if name.startswith(start)][place]


def profiled(value, form, *rest):
    """Over the four scenes."""
    return span(form, [value(data.profile[scene]) for scene in FOUR], *rest)


def gains(name, base):
    return span(times, [over(scene, name, base) for scene in FOUR])


def left_exposed():
    """Preprocessing that DOP leaves exposed, own scene."""
    cycles = [rtl(name).exposed_share * rtl(name).cycles for name in ("dop", "tspp")]
    return percent(cycles[0] / cycles[1], 1)


def saved(*kinds):
    """Operations of these kinds that DPC saves in tiles of 16 pixels."""
    found = data.profile.own.arithmetic_per_pixel
    sixteen = next(one for one in found.dpc if one.tile == 16)
    return percent(1 - sum(sixteen[kind] for kind in kinds) / sum(found.direct[kind] for kind in kinds), 1)


def order_db():
    """What layers cost scenes that were not trained for them."""
    return span(fixed, [work(scene, "dop").psnr_order_db for scene in FOUR], 0)


def table_2():
    """Table 2 beside `dop`: mid of the ranges; power at full speed."""
    rows = [
        [
            unit,
            fixed(mm2, 3),
            fixed(silicon.area("dop", unit), 3),
            fixed(energy.PAPER[unit], 3),
            span(fixed, [energy.row(scene, "dop", unit).watts_full.mid for scene in CHARTED], 3),
        ]
        for unit, mm2 in silicon.PAPER.items()
    ]
    return table(["unit", "paper, mm2", "ours, mm2", "paper, W", "ours, W"], rows)
