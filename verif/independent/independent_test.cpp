// SPDX-License-Identifier: Apache-2.0
// independent_test: truth, golden model and the default machine against pictures by a renderer that shares nothing with
// them: numpy, written from INRIA's semantics alone (render.py).
//
// pictures.py makes scenes of SH degree 0 to 3, with and without antialiasing, and draws them for two cameras of some
// windows, fx not fy, principal points off the centre: colours, T, depth and how many Gaussians each pixel blends.
// The truth must equal them to the rounding of a float, by INRIA's rules and by those that machines promise.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <stdexcept>

#include "cpp_model/float/metrics.hpp"
#include "cpp_model/float/truth.hpp"
#include "scenes/ply/ply.hpp"
#include "sim/compare/simulate.hpp"
#include "sim/design/design_point.hpp"

namespace pipegs {
namespace {

namespace fs = std::filesystem;

const fs::path kFolder = fs::temp_directory_path() / ("pipegs_independent_" + std::to_string(getpid()));

// A PFM as render.py writes it: "PF", size, little endian, three float32 channels, bottom row first.
Image read_pfm(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string kind;
  double scale = 0;
  int width = 0, height = 0;
  file >> kind >> width >> height >> scale;
  file.get();
  if (!file || kind != "PF" || scale != -1.0) throw std::runtime_error(path.string() + " is no little-endian PFM");
  Image image(width, height);
  for (int y = height - 1; y >= 0; --y) {
    for (int x = 0; x < width; ++x) {
      float rgb[3];
      if (!file.read(reinterpret_cast<char*>(rgb), sizeof rgb)) throw std::runtime_error(path.string() + " ends early");
      image.rgb[image.at(x, y)] = {rgb[0], rgb[1], rgb[2]};
    }
  }
  return image;
}

struct Case {
  int degree, view;
};

class Independent : public testing::TestWithParam<Case> {
 protected:
  static void SetUpTestSuite() {
    if (fs::exists(kFolder)) return;
    fs::create_directories(kFolder);
    const std::string folder = "'" PIPEGS_INDEPENDENT "/";
    const int status =
        std::system((folder + "with_numpy.sh' " + folder + "pictures.py' '" + kFolder.string() + "'").c_str());
    code_ = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    std::atexit([] { fs::remove_all(kFolder); });
  }
  void SetUp() override {
    if (code_ == 77) GTEST_SKIP() << "no python3 with numpy";
    ASSERT_EQ(code_, 0);
    scene_ = read_ply(kFolder / ("scene_" + std::to_string(GetParam().degree) + ".ply"));
    camera_ = read_cameras(kFolder / "cameras.json").at(static_cast<size_t>(GetParam().view));
    ASSERT_EQ(scene_.sh_degree, GetParam().degree);
    ASSERT_EQ(scene_.antialiased, GetParam().degree % 2 == 0);
  }
  // Colours of one picture and planes of another file, as one image.
  Image wanted(const std::string& rules) const {
    const std::string name = rules + std::to_string(GetParam().degree) + "_" + std::to_string(GetParam().view);
    Image image = read_pfm(kFolder / (name + ".pfm"));
    const Image planes = read_pfm(kFolder / (name + "_planes.pfm"));
    for (size_t i = 0; i < planes.rgb.size(); ++i) {
      image.transmittance[i] = planes.rgb[i][0];
      image.depth[i] = planes.rgb[i][1];
      image.blended[i] = static_cast<uint32_t>(planes.rgb[i][2]);
    }
    return image;
  }
  Scene scene_;
  Camera camera_;
  static inline int code_ = -1;
};

// The largest difference of each plane.
struct Apart {
  double rgb = 0, through = 0, depth = 0;
  size_t blended = 0;  // pixels that blend another number of Gaussians
};

Apart apart(const Image& a, const Image& b) {
  Apart most;
  for (size_t i = 0; i < a.rgb.size(); ++i) {
    for (int c = 0; c < 3; ++c) most.rgb = std::max(most.rgb, std::abs(a.rgb[i][c] - b.rgb[i][c]));
    most.through = std::max(most.through, std::abs(a.transmittance[i] - b.transmittance[i]));
    most.depth = std::max(most.depth, std::abs(a.depth[i] - b.depth[i]));
    most.blended += a.blended[i] != b.blended[i];
  }
  return most;
}

std::string text(const Apart& most) {
  return fmt::format("rgb {:.2e}, T {:.2e}, depth {:.2e}, {} pixels with another count", most.rgb, most.through,
                     most.depth, most.blended);
}

TEST_P(Independent, TheTruthIsTheSamePictureByBothRules) {
  for (const Semantics semantics : {Semantics::kInria, Semantics::kExact}) {
    TruthOptions options;
    options.semantics = semantics;
    const Image found = render_truth(scene_, camera_, options);
    const Image numpy = wanted(semantics == Semantics::kInria ? "" : "whole_");
    ASSERT_EQ(found.rgb.size(), numpy.rgb.size());
    const Apart most = apart(found, numpy);
    std::printf("%s\n", text(most).c_str());
    EXPECT_LT(most.rgb, 1e-6);
    EXPECT_LT(most.through, 1e-6);
    EXPECT_LT(most.depth, 3e-5);  // of up to 250, as floats
    EXPECT_EQ(most.blended, 0u);
  }
}

// What a machine may be off: decibels, the largest difference of each plane, pixels that blend another number. A tenth
// more than what is measured, a decibel less: a change of the numbers shows. `fast` holds a colour in ten bits, cut to
// [0, 1] and rounded: half a unit is 4.9e-4, and 71 dB is all that such a picture can have. `exact` rounds alphas
// coarser than that. A depth is a weight times up to a thousand units.
struct Limits {
  const char* machine;
  double psnr[2];  // of the views
  Apart most;
};
constexpr Limits kLimits[] = {{"fast", {65.9, 66.5}, {3.2e-3, 4.8e-3, 1.8, 10}},
                              {"exact", {48.4, 58.0}, {3.2e-2, 1.1e-2, 5.9, 55}},
                              {"dop", {10, 10}, {1, 1, 1000, 10000}}};

Image clamped(Image image) {
  for (glm::dvec3& rgb : image.rgb) rgb = glm::clamp(rgb, 0.0, 1.0);
  return image;
}

TEST_P(Independent, TheMachinesAreWithinTheirTotalError) {
  const Image numpy = clamped(wanted("whole_"));
  for (const Limits& limits : kLimits) {
    SimulateOptions options;
    options.config = find_design_point(limits.machine).config;
    options.config.antialias = scene_.antialiased;
    Simulation result;
    simulate_golden(scene_, camera_, options, result);
    const double total = psnr(result.golden.image, numpy);
    const Apart most = apart(clamped(result.golden.image), numpy);
    std::printf("%s: %.2f dB; %s\n", limits.machine, total, text(most).c_str());
    EXPECT_GT(total, limits.psnr[GetParam().view]);
    EXPECT_LT(most.rgb, limits.most.rgb);
    EXPECT_LT(most.through, limits.most.through);
    EXPECT_LT(most.depth, limits.most.depth);
    EXPECT_LE(most.blended, limits.most.blended);
    if (std::string(limits.machine) == "exact" || scene_.antialiased) continue;  // RTL that no other test builds
    simulate_rtl(options, result);
    EXPECT_EQ(result.mismatches, 0u);
  }
}

INSTANTIATE_TEST_SUITE_P(Cases, Independent,
                         testing::Values(Case{0, 0}, Case{0, 1}, Case{1, 0}, Case{1, 1}, Case{2, 0}, Case{2, 1},
                                         Case{3, 0}, Case{3, 1}),
                         [](const auto& info) {
                           return fmt::format("Degree{}View{}", info.param.degree, info.param.view);
                         });

}  // namespace
}  // namespace pipegs
