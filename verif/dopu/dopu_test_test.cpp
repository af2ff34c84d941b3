// SPDX-License-Identifier: Apache-2.0
// dopu_test_test: rtl/dopu/dopu_test.sv against its bit-accurate model; the model against brute force in
// double precision.
#include "Vdopu_test.h"
#include "cpp_model/dopu/dopu_test.hpp"
#include "cpp_model/dopu/dopu.hpp"
#include "cpp_model/float/projection.hpp"
#include "cpp_model/dopu/nearest/dopu_nearest.hpp"
#include "cpp_model/pack/pack_quantize.hpp"
#include "verif/dopu/dopu_world.hpp"
#include "verif/support/bench.hpp"
#include "verif/support/config.hpp"
#include "verif/support/frame_ports.hpp"

namespace pipegs {
namespace {

// Can this Gaussian put alpha >= 1/AlphaCut on a pixel of the window? In double, from the packed values: the ellipse's
// exact bounding box against the window, which only errs towards yes. The camera is at the place that the frame has.
bool touches(const PackedScene& packed, const Frame& frame, const Camera& camera, const Node& node,
             const GaussianRecord& g, int window_x, int window_y) {
  const Config& config = packed.config;
  const auto scene = [&](auto world) { return std::ldexp(static_cast<double>(world), packed.scene_exponent); };
  const auto place = [&](int64_t center, int64_t offset) { return scene(center + (offset << node.offset_exp)); };
  const ActivatedGaussian gaussian{
      .mean = {place(node.center_x, g.offset_x), place(node.center_y, g.offset_y), place(node.center_z, g.offset_z)},
      .scale = {scene(scale_value(config, g.scale_0)), scene(scale_value(config, g.scale_1)),
                scene(scale_value(config, g.scale_2))},
      .rotation = glm::normalize(glm::dvec4(g.qw, g.qx, g.qy, g.qz)),
      .opacity = 1};
  const TruthProjection p =
      project_truth(gaussian, {}, nullptr, 0, camera, {.near_plane = scene(frame.lens.near_plane)});
  const double reach2 = 2 * std::log(config.alpha_cut) -
                        2 * std::log(2.0) * std::ldexp(static_cast<double>(g.opacity), -config.opacity_f);
  if (!p.visible || reach2 < 0) return false;
  const auto overlaps = [&](double mean, double variance, int first, int size) {
    const double reach = std::sqrt(reach2 * variance), last = std::min(first + config.window, size) - 1;
    return mean + reach >= first && mean - reach <= last;
  };
  return overlaps(p.mean.x, p.a, window_x * config.window, camera.width) &&
         overlaps(p.mean.y, p.c, window_y * config.window, camera.height);
}

// Where the frame has the camera, or its eyes.
std::vector<Camera> exact_cameras(const PackedScene& packed, const Frame& frame, const Camera& camera) {
  const double unit = std::ldexp(1.0, packed.scene_exponent);
  std::vector<Camera> cameras;
  for (const int eye : wanted_eyes(packed.config, frame)) {
    const double side = packed.config.eyes == 1 ? 0 : eye == 0 ? -unit : unit;
    const glm::dvec3 half(side * static_cast<double>(frame.eyes.half_x), side * static_cast<double>(frame.eyes.half_y),
                          0);
    cameras.push_back(camera);
    cameras.back().position =
        glm::dvec3(frame.camera.position.x, frame.camera.position.y, frame.camera.position.z) * unit +
        glm::transpose(camera.world_to_camera) * half;
  }
  return cameras;
}

TEST(DopuTestModel, NeverRejectsANodeWithAGaussianThatTouchesTheWindow) {
  const Config config = test_config();
  std::mt19937_64 rng(test_seed());
  uint64_t needed = 0, sent = 0;
  for (int view = 0; view < 100; ++view) {
    // Every other scene is sparse, its Gaussians opaque points: chunks of one, which only the dilation makes visible.
    Scene scene = random_scene(rng, view % 2 == 0 ? 1500 : 60);
    for (Gaussian& g : scene.gaussians) {
      if (view % 2 == 0) break;
      g.log_scale = glm::vec3(-12);
      g.opacity_logit = 9;
    }
    const Camera camera = random_camera(rng, 300 + static_cast<int>(rng() % 300), 200 + static_cast<int>(rng() % 200));
    const PackedScene packed = pack_scene(config, scene, camera_bound(camera));
    Frame frame = frame_setup(config, packed, camera);
    spread_eyes(config, packed, frame);
    const std::vector<Camera> exact = exact_cameras(packed, frame, camera);
    for (int wy = 0; wy <= static_cast<int>(frame.raster.windows.last_y); ++wy) {
      for (int wx = 0; wx <= static_cast<int>(frame.raster.windows.last_x); ++wx) {
        std::vector<bool> chosen(packed.chunks.size());
        const auto choose = [&](int, const Chunk&, uint64_t chunk) { chosen[chunk] = true; };
        if (config.has_watermarks()) dopu_nearest(config, frame, packed, wx, wy, kWholeWalk, choose);
        else dopu_window(config, frame, packed, wx, wy, choose);
        for (size_t c = 0; c < packed.chunks.size(); ++c) {
          const Node& node = packed.chunks[c];
          for (uint64_t slot = node.first; slot < node.first + node.count; ++slot) {
            const bool need = std::any_of(exact.begin(), exact.end(), [&](const Camera& seen) {
              return touches(packed, frame, seen, node, packed.gaussians[slot], wx, wy);
            });
            needed += need;
            sent += chosen[c];
            ASSERT_TRUE(!need || chosen[c]) << "view " << view << ", window " << wx << ", " << wy << ", chunk " << c
                                            << ", slot " << slot << " " << to_text(config, packed.gaussians[slot]);
          }
        }
      }
    }
  }
  RecordProperty("gaussians_needed", std::to_string(needed));
  RecordProperty("gaussians_sent", std::to_string(sent));
  EXPECT_GT(needed, 1000u);
}

// A legal node anywhere near the camera, of any size.
template <class Rng>
Node random_node(const Config& config, const Frame& frame, Rng& rng) {
  const auto around = [&](int64_t camera) {
    const int64_t size = int64_t{1} << (rng() % static_cast<uint64_t>(config.world_w - 2));
    return std::clamp(camera + static_cast<int64_t>(rng() % static_cast<uint64_t>(2 * size)) - size,
                      -(int64_t{1} << (config.world_w - 3)), int64_t{1} << (config.world_w - 3));
  };
  Node node = random_record<Node>(config, rng);
  node.center_x = around(frame.camera.position.x);
  node.center_y = around(frame.camera.position.y);
  node.center_z = around(frame.camera.position.z);
  node.half_exp = rng() % static_cast<uint64_t>(config.world_w - config.half_w());
  if (rng() % 2 == 0) node.scale_max >>= 1 + rng() % 4;
  if (!config.tight_boxes) return node;
  // The box around the ellipsoids holds that of the means.
  for (const auto& [half, down, up] :
       {std::tuple(&node.half_x, &node.down_x, &node.up_x), std::tuple(&node.half_y, &node.down_y, &node.up_y),
        std::tuple(&node.half_z, &node.down_z, &node.up_z)}) {
    *half = std::min(*half, 2 * std::min(*down, *up));
  }
  return node;
}

constexpr int kNearestW = 42;

void compare(Pace pace) {
  const Config config = test_config();
  Bench<Vdopu_test> bench;
  auto& dut = bench.dut;
  const uint64_t tag_mask = 0xf;
  CData always = 0;  // results have no ready
  WordSource<decltype(dut.node_i)> in(bench, dut.node_valid_i, dut.node_ready_o, dut.node_i, pace);
  RecordSink<Node, decltype(dut.result_node_o)> out(bench, config, dut.result_valid_o, always, dut.result_node_o);
  struct Probe : Endpoint {
    decltype(dut)& d;
    Bench<Vdopu_test>& b;
    std::vector<bool> pass;
    std::vector<uint64_t> tags, taken, exponents;
    std::vector<Hull> hulls;
    std::vector<int64_t> nearest, farthest;
    explicit Probe(Bench<Vdopu_test>& bench) : d(bench.dut), b(bench) { bench.add(*this); }
    void drive() override {
      d.set_i = taken.size() & 1;
      d.tag_i = taken.size() & 0xf;
      const Hull hull = taken.size() < hulls.size() ? hulls[taken.size()] : Hull{};
      d.tight_i = hull.tight;
      d.scale_i = static_cast<uint32_t>(hull.scale);
    }
    void observe() override {
      if (d.node_valid_i && d.node_ready_o) taken.push_back(b.cycle);
      if (!d.result_valid_o) return;
      pass.push_back(d.result_pass_o), tags.push_back(d.result_tag_o), exponents.push_back(d.result_exponent_o);
      const auto depth = [](uint64_t port) {
        return static_cast<int64_t>(port << (64 - kNearestW)) >> (64 - kNearestW);
      };
      nearest.push_back(depth(d.result_nearest_o)), farthest.push_back(depth(d.result_farthest_o));
    }
  } probe(bench);
  dut.awake_i = 1;
  bench.reset();
  uint64_t passed = 0, tight = 0;
  for (int round = 0; round < 30; ++round) {
    const Scene scene = random_scene(bench.rng, 300);
    const Camera camera = random_camera(bench.rng, 500, 400);
    const PackedScene packed = pack_scene(config, scene, camera_bound(camera));
    Frame frame = frame_setup(config, packed, camera, {}, round % 3 == 0 ? 2.0 : 0.2);
    spread_eyes(config, packed, frame);
    write_frame(config, dut, frame);
    Planes sets[2];
    Words words(2 * kPlanes * static_cast<size_t>(record_width<Plane>(config)) / 32 + 4), one(4);
    for (int set = 0; set < 2; ++set) {
      sets[set] = dopu_planes(config, frame, static_cast<int>(bench.rng() % 8), static_cast<int>(bench.rng() % 6));
      if (config.eyes > 1) sets[set].eye = static_cast<int>(bench.rng() % 3) - 1;
      for (int side = 0; side < kPlanes; ++side) {
        const int width = record_width<Plane>(config), at = (set * kPlanes + side) * width;
        pack(config, sets[set][static_cast<size_t>(side)], one.data());
        for (int bit = 0; bit < width; ++bit) put_bits(words.data(), at + bit, 1, get_bits(one.data(), bit, 1));
      }
    }
    write_port(dut.planes_i, words.data());
    write_test_eyes(config, dut, frame, {sets[0].eye, sets[1].eye});
    const size_t first = out.size();
    ASSERT_EQ(first, probe.taken.size());
    std::vector<Node> nodes;
    std::vector<int> steps;
    for (int i = 0; i < 200; ++i) {
      nodes.push_back(i % 2 == 0 ? random_node(config, frame, bench.rng)
                                 : packed.chunks[bench.rng() % packed.chunks.size()]);
      Words node(static_cast<size_t>(record_words<Node>(config)) + 1);
      pack(config, nodes.back(), node.data());
      in.push(node);
      // From the near plane's step on, or so that the node's largest reach is about as long as its depth.
      const int near = dopu_depth_near(config, frame), fraction = config.scale_m_w - config.bucket_bits;
      const int reach = static_cast<int>(shift_floor(static_cast<int64_t>(nodes.back().scale_max), fraction)) -
                        (8 << config.bucket_bits);
      const int around = reach + static_cast<int>(bench.rng() % (4u << config.bucket_bits));
      steps.push_back(std::clamp(i % 4 < 2 ? around : near + static_cast<int>(bench.rng() % (1u << config.bucket_w())),
                                 0, (2 << config.step_w()) - 1));
      probe.hulls.push_back(dopu_hull(config, nodes.back().scale_max, steps.back()));
    }
    ASSERT_TRUE(bench.run_until([&] { return out.size() == first + nodes.size(); }));
    for (size_t i = 0; i < nodes.size(); ++i) {
      const int step = steps[i];
      const bool expected = dopu_test(config, frame, sets[(first + i) & 1], nodes[i], step);
      tight += probe.hulls[first + i].tight;
      passed += expected;
      ASSERT_EQ(expected, probe.pass[first + i]) << "node " << first + i << " " << to_text(config, nodes[i])
                                                 << " cycle " << out.cycles[first + i] << " seed " << bench.seed;
      ASSERT_EQ(probe.tags[first + i], (first + i) & tag_mask);
      const Corners box = dopu_test_corners(config, frame, nodes[i], step);
      const bool ranks = config.has_watermarks();  // else the test says nothing about depth
      ASSERT_EQ(probe.nearest[first + i], ranks ? dopu_depth_bound(config, box, sets[0][kNear]) : 0)
          << to_text(config, nodes[i]);
      ASSERT_EQ(probe.farthest[first + i], config.has_walks() ? dopu_depth_end(config, box, sets[0][kNear]) : 0)
          << to_text(config, nodes[i]);
      ASSERT_EQ(probe.exponents[first + i], static_cast<uint64_t>(ranks ? box.exponent : 0));
      ASSERT_EQ(first_difference(config, nodes[i], out.at(first + i)), "");
    }
    if (pace == Pace::kAlways) {
      EXPECT_EQ(probe.taken.back() - probe.taken[first], 3 * (nodes.size() - 1)) << "pace: 3 cycles";
    }
  }
  EXPECT_GT(passed, 500u);
  EXPECT_LT(passed, 5500u);
  if (config.tight_boxes) {
    EXPECT_GT(tight, 1000u);
    EXPECT_LT(tight, 5000u);
  }
}

TEST(DopuTest, EqualsItsModelAtFullPace) { compare(Pace::kAlways); }
TEST(DopuTest, EqualsItsModelOneInFour) { compare(Pace::kQuarter); }
TEST(DopuTest, EqualsItsModelByCoin) { compare(Pace::kCoin); }

}  // namespace
}  // namespace pipegs
