// SPDX-License-Identifier: Apache-2.0
// frame_limits_test: the driver's frame at the ends of its fields, in every form of a number, and the places and
// sizes of what lies in memory.
#include <gtest/gtest.h>

#include <cstring>
#include <functional>
#include <tuple>

#include "cpp_model/lib/corners.hpp"
#include "cpp_model/driver/pipegs_wide.h"
#include "verif/dopu/dopu_world.hpp"
#include "verif/dopu/frame_reference.hpp"

namespace pipegs {
namespace {

using Uint128 = unsigned __int128;

// The driver's 128 bits beside the compiler's own.
TEST(FrameLimits, AreReachedByNumbersOf128Bits) {
  std::mt19937_64 rng(frame_seed());
  const auto wide = [](Uint128 value) {
    return pipegs_wide{static_cast<uint64_t>(value >> 64), static_cast<uint64_t>(value)};
  };
  const auto narrow = [](pipegs_wide value) { return static_cast<Uint128>(value.high) << 64 | value.low; };
  for (int i = 0; i < 20000; ++i) {
    const uint64_t a = rng() >> (rng() % 64), b = rng() >> (rng() % 64), most = ~uint64_t{0};
    const Uint128 product = static_cast<Uint128>(a) * b, other = (static_cast<Uint128>(rng()) << 64 | rng()) >> 1;
    ASSERT_EQ(narrow(pipegs_wide_multiply(a, b)), product);
    ASSERT_EQ(narrow(pipegs_wide_add(wide(product >> 1), wide(other))), (product >> 1) + other);
    const int places = static_cast<int>(rng() % 128);
    ASSERT_EQ(narrow(pipegs_wide_left(wide(other), places)), other << places);
    ASSERT_EQ(narrow(pipegs_wide_right(wide(other), places)), other >> places);
    for (const uint64_t divisor : {b, most - a % 1000, uint64_t{0}}) {
      uint64_t quotient = 0;
      const Uint128 dividend = i % 2 == 0 ? other : product;
      const bool fits = divisor != 0 && dividend / divisor <= most;
      ASSERT_EQ(pipegs_wide_divide(wide(dividend), divisor, &quotient), fits);
      if (fits) ASSERT_EQ(quotient, static_cast<uint64_t>(dividend / divisor));
    }
    const Uint128 square = static_cast<Uint128>(a) * a;
    ASSERT_EQ(pipegs_wide_root(wide(square)), a);
    if (a > 0) ASSERT_EQ(pipegs_wide_root(wide(square - 1)), a - 1);
    ASSERT_EQ(pipegs_wide_root(wide(square + 2 * static_cast<Uint128>(a))), a);
  }
}

// The same number with more or fewer bits in its mantissa is the same number.
TEST(FrameLimits, AreTheSameForEveryFormOfANumber) {
  std::mt19937_64 rng(frame_seed());
  const Config config;
  const PackedScene scene = bare_scene(config, -30, rng);
  const pipegs_scene packed = driver_scene(scene);
  const pipegs_configuration machine = driver_configuration(config);
  for (int i = 0; i < 5000; ++i) {
    const pipegs_camera taken = driver_camera(random_camera(rng, 640, 480), kNearPlane);
    pipegs_camera other = taken;
    const auto change = [&](pipegs_number& number) {
      const int up = static_cast<int>(rng() % 11);
      number.mantissa *= int64_t{1} << up, number.exponent -= up;
      while (up == 0 && number.mantissa != 0 && number.mantissa % 2 == 0) number.mantissa /= 2, ++number.exponent;
    };
    for (pipegs_number& number : other.position) change(number);
    for (auto& row : other.rotation) {
      for (pipegs_number& number : row) change(number);
    }
    for (pipegs_number* pair : {other.focal, other.center}) change(pair[0]), change(pair[1]);
    change(other.near_plane);
    const pipegs_memory memory = pipegs_place(&machine, &packed, &taken, 0);
    pipegs_job wanted = {}, found = {};
    const pipegs_setup setup = pipegs_setup_job(&machine, &packed, &taken, nullptr, &memory, &wanted);
    ASSERT_EQ(pipegs_setup_job(&machine, &packed, &other, nullptr, &memory, &found), setup);
    ASSERT_EQ(std::memcmp(&wanted, &found, sizeof wanted), 0) << "round " << i << ", seed " << frame_seed();
    std::memset(&found.frame, 0xff, sizeof found.frame);  // what is left of another frame does not matter
    ASSERT_EQ(pipegs_setup_job(&machine, &packed, &other, nullptr, &memory, &found), setup);
    ASSERT_EQ(std::memcmp(&wanted, &found, sizeof wanted), 0) << "round " << i << ", seed " << frame_seed();
  }
}

// The largest and the smallest value of a field, and what is half a unit beyond; the roundings of what is nearly 0.
TEST(FrameLimits, AreThoseOfTheFields) {
  std::mt19937_64 rng(frame_seed());
  const Config config;
  const PackedScene scene = bare_scene(config, 0, rng);
  const pipegs_scene packed = driver_scene(scene);
  const pipegs_configuration machine = driver_configuration(config);
  Camera camera = random_camera(rng, 640, 480);
  camera.position = {0, 0, 0};
  const pipegs_camera good = driver_camera(camera, 1);
  pipegs_job job = {};
  const auto setup = [&](const std::function<void(pipegs_camera&)>& change) {
    pipegs_camera taken = good;
    change(taken);
    const pipegs_memory memory = pipegs_place(&machine, &packed, &taken, 0);
    return pipegs_setup_job(&machine, &packed, &taken, nullptr, &memory, &job);
  };
  const auto position = [&](int64_t mantissa, int exponent) {
    return setup([&](pipegs_camera& taken) { taken.position[1] = {mantissa, exponent}; });
  };
  const int64_t high = int64_t{1} << (config.world_w - 2);
  EXPECT_EQ(position(-high, 0), PIPEGS_SETUP_OK);
  EXPECT_EQ(job.frame.camera_position_y, -high);
  EXPECT_EQ(position(-16 * high - 7, -4), PIPEGS_SETUP_OK);
  EXPECT_EQ(position(-16 * high - 8, -4), PIPEGS_SETUP_POSITION_Y);
  EXPECT_EQ(position(16 * high - 9, -4), PIPEGS_SETUP_OK);
  EXPECT_EQ(job.frame.camera_position_y, high - 1);
  EXPECT_EQ(position(16 * high - 8, -4), PIPEGS_SETUP_POSITION_Y);
  EXPECT_EQ(position(high, 0), PIPEGS_SETUP_POSITION_Y);
  for (const int exponent : {30, 62, 63, 64, 1000, 0x7fffffff}) {
    EXPECT_EQ(position(high, exponent), PIPEGS_SETUP_POSITION_Y) << exponent;
    EXPECT_EQ(position(1, exponent), exponent < 38 ? PIPEGS_SETUP_OK : PIPEGS_SETUP_POSITION_Y) << exponent;
    EXPECT_EQ(position(0, exponent), PIPEGS_SETUP_OK) << exponent;
  }
  for (const int64_t mantissa : {INT64_MAX, INT64_MIN, INT64_MIN / 2, int64_t{1}}) {
    for (int exponent = -70; exponent <= -20; ++exponent) {
      const long double value = std::ldexp(static_cast<long double>(mantissa), exponent);
      const bool fits = std::round(value) < high && std::round(value) >= -high;
      ASSERT_EQ(position(mantissa, exponent), fits ? PIPEGS_SETUP_OK : PIPEGS_SETUP_POSITION_Y) << exponent;
      if (fits) ASSERT_EQ(job.frame.camera_position_y, std::llround(value)) << mantissa << " * 2^" << exponent;
    }
    EXPECT_EQ(position(mantissa, -0x7fffffff), PIPEGS_SETUP_OK);
    EXPECT_EQ(job.frame.camera_position_y, 0);
  }
  const auto near_plane = [&](int64_t mantissa, int exponent) {
    return setup([&](pipegs_camera& taken) { taken.near_plane = {mantissa, exponent}; });
  };
  EXPECT_EQ(near_plane(2 * high - 1, 0), PIPEGS_SETUP_OK);
  EXPECT_EQ(near_plane(2 * high, 0), PIPEGS_SETUP_NEAR_PLANE);
  EXPECT_EQ(near_plane(-1, -2), PIPEGS_SETUP_OK);
  EXPECT_EQ(job.frame.lens_near_plane, 0u);
  EXPECT_EQ(near_plane(-1, -1), PIPEGS_SETUP_NEAR_PLANE);
  const auto focal = [&](int64_t mantissa, int exponent) {
    return setup([&](pipegs_camera& taken) { taken.focal[0] = {mantissa, exponent}; });
  };
  EXPECT_EQ(focal((int64_t{1} << 28) - 1, -14), PIPEGS_SETUP_OK);
  EXPECT_EQ(focal(1, 14), PIPEGS_SETUP_FOCAL_X);
  EXPECT_EQ(focal(1, -16), PIPEGS_SETUP_FOCAL_X) << "rounds to 0";
  EXPECT_EQ(focal(1, -15), PIPEGS_SETUP_GUARD_X) << "the least that does not";
  EXPECT_EQ(setup([](pipegs_camera& taken) { taken.rotation[2][0] = {2, 0}; }), PIPEGS_SETUP_ROTATION);
  // Entries that are no rotation's at all still make a quaternion of length 1.
  for (const int64_t entry : {-2, -1, 0, 1}) {
    ASSERT_EQ(setup([&](pipegs_camera& taken) {
                for (auto& row : taken.rotation) row[0] = row[1] = row[2] = {entry, 0};
              }),
              PIPEGS_SETUP_OK);
    double square = 0;
    for (const int64_t component : {job.frame.camera_quaternion_w, job.frame.camera_quaternion_x,
                                    job.frame.camera_quaternion_y, job.frame.camera_quaternion_z}) {
      square += std::ldexp(static_cast<double>(component * component), -36);
    }
    EXPECT_NEAR(square, 1, 1e-4) << entry;
  }
  for (const auto& [width, height, wanted] : {std::tuple{0u, 100u, PIPEGS_SETUP_WIDTH},
                                              {16385u, 100u, PIPEGS_SETUP_WIDTH},
                                              {0xffffffffu, 100u, PIPEGS_SETUP_WIDTH},
                                              {100u, 0u, PIPEGS_SETUP_HEIGHT},
                                              {100u, 16385u, PIPEGS_SETUP_HEIGHT},
                                              {16384u, 16384u, PIPEGS_SETUP_OK}}) {
    EXPECT_EQ(setup([&, side_x = width, side_y = height](pipegs_camera& taken) {
                taken.width = side_x, taken.height = side_y, taken.focal[0] = taken.focal[1] = {9000, 0};
              }),
              wanted)
        << width << " x " << height;
  }
}

// 1024 windows are a row's most.
TEST(FrameLimits, AreThoseOfTheWindows) {
  std::mt19937_64 rng(frame_seed());
  Config config;
  config.window = 16;
  Camera camera = random_camera(rng, kMaxImageSide, kMaxImageSide);
  camera.position = {0, 0, 0};
  const Frame frame = frame_setup(config, bare_scene(config, -20, rng), camera);
  EXPECT_EQ(frame.raster.windows.last_x, 1023u);
  EXPECT_EQ(frame.raster.windows.last_y, 1023u);
}

TEST(FrameLimits, OfTheSpreadHoldForEveryFocalLength) {
  std::mt19937_64 rng(frame_seed());
  for (int i = 0; i < 200000; ++i) {
    const uint32_t cut = 32 + static_cast<uint32_t>(rng() % 992);
    const uint64_t focal = std::max<uint64_t>(1, rng() >> (36 + rng() % 28));
    Config config;
    config.alpha_cut = static_cast<int>(cut), config.tight_cull = 1;
    ASSERT_EQ(pipegs_spread(cut, focal), reference_spread(config, focal)) << "focal " << focal << ", cut " << cut;
  }
}

// The driver's formula, from what the registers say, beside the same from the configuration: on the design points, on
// random corners of config.def, for scenes of every size, and for numbers that no scene has.
TEST(FrameLimits, AreThoseOfTheOverflowArea) {
  std::mt19937_64 rng(frame_seed());
  std::vector<Config> configs = machines();
  for (uint64_t i = 0; i < 300; ++i) configs.push_back(config_corner(1000 * frame_seed() + i));
  int with_lists = 0, with_alphas = 0, with_parts = 0, without = 0;
  for (const Config& config : configs) {
    const pipegs_configuration machine = driver_configuration(config);
    const auto expect_same = [&](uint64_t slots, uint64_t windows) {
      ASSERT_EQ(pipegs_overflow_size(&machine, slots, windows), 64 * reference_overflow(config, slots, windows))
          << config_difference(config) << ", " << slots << " slots, " << windows << " windows";
    };
    for (const uint64_t slots :
         {0ull, 1ull, 63ull, 64ull, (1ull << 20) - 1, 1ull << 20, 1ull << 33, 1ull << 58, 1ull << 62, ~0ull}) {
      for (const uint64_t windows :
           {0ull, 1ull, 2040ull, 4095ull, 4096ull, 4097ull, 16383ull, 16384ull, 16385ull, ~0ull}) {
        expect_same(slots, windows);
      }
    }
    for (int i = 0; i < 200; ++i) expect_same(rng() >> (rng() % 64), rng() >> (rng() % 64));
    for (int i = 0; i < 200; ++i) expect_same(rng() % (1 << 24), 1 + rng() % 4096);
    with_lists += config.has_lists(), with_alphas += machine.alpha_memory_lines != 0;
    with_parts += machine.parts > 1, without += pipegs_overflow_size(&machine, ~uint64_t{0}, 4096) == 0;
  }
  EXPECT_TRUE(with_lists > 9 && with_alphas > 9 && with_parts > 9 && without > 0);
}

// Where the scene, pixels and overflow areas lie, in bytes, and how large they are.
TEST(FrameLimits, GiveTheAreasTheirSizes) {
  std::mt19937_64 rng(frame_seed());
  for (const Config& config : machines()) {
    const PackedScene scene = bare_scene(config, -25, rng);
    Camera camera = random_camera(rng, 700, 300);
    camera.position = {1, 2, 3};
    pipegs_scene packed = driver_scene(scene);
    packed.slots = rng() >> (40 + rng() % 20);
    const pipegs_camera taken = driver_camera(camera, kNearPlane);
    const pipegs_configuration machine = driver_configuration(config);
    const uint64_t side = static_cast<uint64_t>(config.window),
                   windows = ((700 + side - 1) / side) * ((300 + side - 1) / side);
    pipegs_memory memory = pipegs_place(&machine, &packed, &taken, 0x12340000);
    EXPECT_EQ(memory.overflow_size, 64 * reference_overflow(config, packed.slots, windows))
        << config_difference(config);
    pipegs_job job = {};
    ASSERT_EQ(pipegs_setup_job(&machine, &packed, &taken, nullptr, &memory, &job), PIPEGS_SETUP_OK);
    const uint64_t base = 0x12340000;
    EXPECT_EQ(job.frame.tables_cells, base + 64 * scene.layout.cells);
    EXPECT_EQ(job.frame.tables_colors, base + 64 * scene.layout.colors);
    EXPECT_EQ(job.frame.tables_cells + job.areas.cells, job.frame.tables_groups);
    EXPECT_EQ(job.frame.tables_groups + job.areas.groups, job.frame.tables_chunks);
    EXPECT_EQ(job.frame.tables_chunks + job.areas.chunks, job.frame.tables_gaussians);
    EXPECT_EQ(job.frame.tables_gaussians + job.areas.gaussians, job.frame.tables_colors);
    EXPECT_EQ(job.frame.tables_colors + job.areas.colors, job.frame.tables_pixels);
    EXPECT_EQ(job.areas.pixels, windows * side * side * static_cast<uint64_t>(config.pixel_w) / 8);
    EXPECT_GE(job.frame.tables_overflow, job.frame.tables_pixels + job.areas.pixels);
    EXPECT_EQ(job.areas.overflow, memory.overflow_size);
    memory.overflow_size = 0x100000;  // what a caller with less memory gives
    ASSERT_EQ(pipegs_setup_job(&machine, &packed, &taken, nullptr, &memory, &job), PIPEGS_SETUP_OK);
    EXPECT_EQ(job.areas.overflow, 0x100000u);
    const pipegs_memory good = memory;
    const auto refused = [&] {
      const pipegs_setup setup = pipegs_setup_job(&machine, &packed, &taken, nullptr, &memory, &job);
      memory = good;
      return setup == PIPEGS_SETUP_MEMORY;
    };
    EXPECT_FALSE(refused());
    memory.scene += 32;
    EXPECT_TRUE(refused());
    memory.pixels += 1;
    EXPECT_TRUE(refused());
    memory.overflow += 64;
    EXPECT_TRUE(refused());
    memory.overflow_size = 100;
    EXPECT_TRUE(refused());
    memory.overflow = uint64_t{64} << config.address_w();
    EXPECT_TRUE(refused());
    memory.pixels = (uint64_t{64} << config.address_w()) - 64;
    EXPECT_TRUE(refused());
    pipegs_scene sharp = packed;
    sharp.antialias = 1;
    EXPECT_EQ(pipegs_setup_job(&machine, &sharp, &taken, nullptr, &memory, &job),
              config.antialias != 0 ? PIPEGS_SETUP_OK : PIPEGS_SETUP_ANTIALIAS);
    pipegs_configuration other = machine;
    ++other.pos_w;
    EXPECT_EQ(pipegs_setup_job(&other, &packed, &taken, nullptr, &memory, &job), PIPEGS_SETUP_SCENE);
    other = machine;
    other.config_hash ^= 1, other.units ^= 7;  // what no record depends on
    EXPECT_EQ(pipegs_setup_job(&other, &packed, &taken, nullptr, &memory, &job), PIPEGS_SETUP_OK);
  }
}

}  // namespace
}  // namespace pipegs
