// SPDX-License-Identifier: Apache-2.0
// closed.cpp: see closed.hpp.
#include "sim/studies/terms/closed.hpp"

#include "sim/studies/terms/terms.hpp"

namespace pipegs {
namespace {

constexpr double kBase = 7.48, kDpc = 5.71, kHgr = 1.83;         // raster / sort, Sec. 5.3.1
constexpr double kHgrOver = 2.33, kDopOver = 1.22, kAll = 2.85;  // Sec. 5.3.2
constexpr double kFront = 0.15, kMore = 1.2, kLeft = 0.37, kHidden = 0.63, kFewer = 0.762;
constexpr double kRaster = 0.70, kBubbles = 0.69;  // Fig. 3a
constexpr int kExp = 16;
constexpr double kPixels = 256, kRows = 16, kPowerProducts = 7, kPairProducts = 4, kRowProducts = 4;
constexpr double kRenderingUnits = 64, kRowUnits = 32;

}  // namespace

std::vector<ClosedRow> closed_form() {
  const double others = (kPowerOps - kDpcOps) / (kBase / kDpc - 1) - kDpcOps;  // exponential, opacity and blending
  const double blend = (kDpcOps + others) * kHgr / kDpc;
  const double front = kFront / (1 - kFront) * kBase, base = front + kBase;  // P, and the frame
  const double hgr = base / kHgrOver, hgr_front = hgr - kHgr;                // with the paper's speed-up
  const double hgr_share = (1 - 1 / kDopOver) / kHidden;                     // P of HGR's frame, by DOP's figures
  const double moved = (raster_ops(Rung::kDpc, kExp) - kBlendOps) / kBlendOps * kHgr;  // on as many serial lanes
  const double on_rows = moved * kRenderingUnits / kRowUnits;
  const double front_of_both = (kBase - kHgrOver * kHgr) / (kHgrOver * kMore - 1);
  return {
      {"power, operations saved (Fig. 4a)", "1 - (10 + 16 x 8 + 256 x 2) / (256 x 11)", 1 - kDpcOps / kPowerOps, 0.769},
      {"power, multiplications saved (Fig. 4a)", "1 - (4 + 16 x 4) / (256 x 7)",
       1 - (kPairProducts + kRows * kRowProducts) / (kPixels * kPowerProducts), 0.962},
      {"operations beside the power", "(11 + x) / (2.54 + x) = 7.48 / 5.71; counted: 16 + 9", others, kExp + kBlendOps},
      {"of those, blending", "(2.54 + x) / y = 5.71 / 1.83; counted: 9", blend, kBlendOps},
      {"raster / sort, DPC", "7.48 x (2.54 + 16 + 9) / (11 + 16 + 9)",
       kBase * raster_ops(Rung::kDpc, kExp) / raster_ops(Rung::kBaseline, kExp), kDpc},
      {"raster / sort, HGR", "7.48 x 9 / (11 + 16 + 9)", kBase * kBlendOps / raster_ops(Rung::kBaseline, kExp), kHgr},
      {"DOP over Baseline", "2.33 x 1.22", kHgrOver * kDopOver, kAll},
      {"preprocessing, HGR over Baseline (Fig. 3c)", "P = 15 % of P + 7.48; (P + 7.48) / (P' + 1.83) = 2.33; P' / P",
       hgr_front / front, kMore},
      {"HGR over Baseline", "P as above, P' = 1.2 P", base / (kMore * front + kHgr), kHgrOver},
      {"preprocessing of Baseline's frame", "2.33 and P' = 1.2 P; P / (P + 7.48)",
       front_of_both / (front_of_both + kBase), kFront},
      {"bubbles: SUs beside RUs (Fig. 3a)", "(7.48 - 1) / (P + 7.48)", (kBase - 1) / base, kBubbles},
      {"bubbles: PUs, SUs and RUs (Fig. 3a)", "1 - (15 % + 70 % + 70 % / 7.48) / 3",
       1 - (kFront + kRaster + kRaster / kBase) / 3, kBubbles},
      {"bubbles less by HGR, of time", "1 - (1.83 - 1) / (7.48 - 1)", 1 - (kHgr - 1) / (kBase - 1), kFewer},
      {"bubbles less by HGR, of the frame", "1 - 2.33 (1.83 - 1) / (7.48 - 1)", 1 - kHgrOver * (kHgr - 1) / (kBase - 1),
       kFewer},
      {"DOP over HGR", "(P' + 1.83) / (0.37 P' + 1.83)", hgr / (kLeft * hgr_front + kHgr), kDopOver},
      {"DOP over HGR", "(P' + 1.83) / (0.37 P + 1.83)", hgr / (kLeft * front + kHgr), kDopOver},
      {"preprocessing hidden by DOP", "(1 - 1 / 1.22) (P' + 1.83) / P'", (1 - 1 / kDopOver) * hgr / hgr_front, kHidden},
      {"Baseline's frame over its sort",
       "1.22 and 63 %: P' is 28.6 % of HGR's frame; 2.33 x 1.83 / (1 - 28.6 %); at "
       "least 7.48",
       kHgrOver * kHgr / (1 - hgr_share), kBase},
      {"operations a Row Unit must do in a cycle", "(2.54 + 16) / 9 x 1.83 x 64 / 32 lanes over P' - P; one as the RUs",
       on_rows / (hgr_front - front), 1},
      {"HGR over Baseline, one operation a cycle",
       "alphas on 32 Row Units after the projections: (P + 7.48) / (P + "
       "7.54 + 1.83)",
       base / (front + on_rows + kHgr), kHgrOver},
  };
}

}  // namespace pipegs
