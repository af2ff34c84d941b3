# SPDX-License-Identifier: Apache-2.0
"""Tables of docs/numerics/stability.md."""
from data import data
from formats import percent, table

MEASURED = ["stability/*"]
CASES = [  # what it is, how it is handled, its test
    (
        "T1 non-finite input",
        "left out, counted `non_finite`; no pair, no pixel changes",
        "Stability.T01_NonFiniteInputIsCulledAndCounted",
    ),
    (
        "T2 zero quaternion",
        "left out, counted, reported by `pipegs info`",
        "Stability.T02_ZeroQuaternionIsCulledAndTold",
    ),
    (
        "T3 quaternion of length 2^-60 to 2^60",
        "normalised in double by the host",
        "Stability.T03_QuaternionsOfAnyLength",
    ),
    ("T4 flat splats", "legal: the dilation of 0.3 gives a width", "Stability.T04_FlatSplats"),
    (
        "T5 needles, det by cancellation",
        "det is a sum of positive terms: none is dropped",
        "Stability.T05_NeedleDeterminant",
    ),
    (
        "T6 degenerate covariance",
        "det > 0 always, box within 3.4 standard deviations",
        "Stability.T06_DegenerateCovarianceGivesASaneBox",
    ),
    ("T7 b = 0", "no eigenvectors anywhere", "Stability.T07_AxisAligned"),
    (
        "T8 standard deviation below 2.4e-4",
        "scale and quaternion are stored, not the covariance",
        "Stability.T08_TinyScalesKeepTheirAxis",
    ),
    ("T10 near plane", "exact compare in view units", "Stability.T10_NearPlane"),
    ("T11 guard band", "x/z clamped in the Jacobian only", "Stability.T11_GuardBand"),
    ("T12 tiny scenes", "near plane is a parameter", "Stability.T12_TinyScenes"),
    (
        "T13 opacity about 1/255",
        "left out below it, no logarithm of less than 1",
        "Stability.T13_OpacitiesAroundTheCut",
    ),
    ("T14 alpha boundaries", "integer compares; cap at the code of 0.99", "Stability.T14_ExactBoundaries"),
    ("T15 power above 0", "clamped to 0", "Stability.T15_PowerAboveZeroKeepsThePeak"),
    (
        "T17 one tile holds all",
        "queues wait, sorts pass by pass; 245 535 in `StabilityLong`",
        "Stability.T17_OneTileHoldsAlmostAll",
    ),
    ("T18 equal depths", "by index; 100 000 in `StabilityLong`", "Stability.T18_EqualDepthsHaveOneOrder"),
    ("T21 stop at 1e-4", "`<`, exact in integers", "Stability.T21_StopAtTheBoundary"),
    (
        "T23 scales without logarithm",
        "rendered as asked, reported by `pipegs info`",
        "Stability.T23_ScalesWithoutLogarithm",
    ),
    ("T24 mirrored axes", "x right, y down, z forward", "Stability.T24_AxesAreNotMirrored"),
    ("T25 images of any size", "pixels beyond the image are never blended", "Stability.T25_ImagesOfAnySize"),
    ("T26 radius", "no cap: 100 000 pixels of standard deviation", "Stability.T26_NoCapOfTheRadius"),
    ("T27 camera inside", "near plane before anything is divided", "Stability.T27_CameraInside"),
    ("needles of 1e2 to 1e8, 24 angles, 5 tilts", "as T5", "StabilityBeyond.NeedlesAtEveryAngle"),
    (
        "specks to screens, 2^-40 to 2^16",
        "scales of 6 exponent bits, flushed below",
        "StabilityBeyond.FromSpecksToScreens",
    ),
    ("means 32 000 pixels away", "mean s18, curvatures keep their bits", "StabilityBeyond.AnchorsFarFromTheImage"),
    ("T crosses 1e-4 in every phase", "as T21", "StabilityBeyond.StopsInEveryPhase"),
    ("colours far outside", "clip at 0 and 4, counted", "StabilityBeyond.ColoursFarOutside"),
    (
        "10 000 of alpha 1/255",
        "T and weights each rounded to nearest",
        "StabilityBeyond.TenThousandFaintOnesOverOnePixel",
    ),
    ("ends of the formats", "record clips and counts", "StabilityBeyond.EndsOfTheFormats"),
]


def cases():
    """Each case with the largest error of a pixel and the bound there."""
    rows = []
    for what, how, test in CASES:
        found = data.stability.cases.cases[test]
        rows.append(
            [
                what,
                how,
                f"`{test}`",
                *[" of ".join(f"{value:.4f}" for value in found[key]) for key in ("alpha", "t", "color")],
            ]
        )
    return table(["case", "handling", "test", "alpha, measured of bound", "T", "colour"], rows)


def fp16_off():
    return percent(data.stability.cases.fp16_off, 1)


def popping():
    found = data.stability.cases.popping
    against = found.dop[2] + found.exact[2]
    return (
        f"`dop` draws {found.dop[0]} pairs against their depth, `exact` {found.exact[0]}; half a degree later "
        f"{found.dop[1]} pairs (`dop`) and {found.exact[1]} (`exact`) have swapped; "
        + (f"{against} swaps do not follow depth" if against else "all swaps follow depth")
    )


def depth_bits():
    return "order error " + ", ".join(
        f"{value:.1f} dB at {bits} bits" for bits, value in data.stability.cases.depth_bits.items()
    )
