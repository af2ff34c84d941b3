// SPDX-License-Identifier: Apache-2.0
// dopu_bucket_test: rtl/dopu/nearest/dopu_bucket.sv against an array of stacks.
#include "Vdopu_bucket.h"
#include "verif/support/bench.hpp"
#include "verif/support/config.hpp"

namespace pipegs {
namespace {

constexpr int kLists = 6, kDataWords = 6;
const int kBucketW = test_config().bucket_w(), kChains = 1 << kBucketW;

struct Entry {
  int list, bucket;
  uint64_t data;
};

// Inserts and pops at any time; every pop must bring the newest node of the list's first bucket.
class Driver : public Endpoint {
 public:
  Driver(Bench<Vdopu_bucket>& bench, int nodes) : bench_(bench), nodes_(nodes) { bench.add(*this); }
  void drive() override {
    auto& d = bench_.dut;
    auto& rng = bench_.rng;
    if (!inserting_ && rng() % 100 < insert_percent) {
      inserting_ = true;
      const bool narrow = rng() % 2 == 0;  // long chains and single nodes
      insert_ = {static_cast<int>(rng() % kLists),
                 static_cast<int>(narrow ? rng() % 3 * 63 : rng() % static_cast<uint64_t>(kChains)), rng()};
    }
    d.insert_valid_i = inserting_;
    d.insert_list_i = static_cast<CData>(insert_.list);
    d.insert_bucket_i = static_cast<std::decay_t<decltype(d.insert_bucket_i)>>(insert_.bucket);
    Words words(kDataWords + 1);
    put_bits(words.data(), 0, 64, insert_.data);
    put_bits(words.data(), 100, 64, ~insert_.data);
    write_port(d.insert_data_i, words.data());
    const int list = static_cast<int>(rng() % kLists);
    d.pop_valid_i = rng() % 100 < pop_percent && !expecting_ && size(list) != 0;
    d.pop_list_i = static_cast<CData>(list);
  }
  void observe() override {
    auto& d = bench_.dut;
    Words firsts(4);
    read_port(d.first_bucket_o, firsts.data());
    for (int l = 0; l < kLists; ++l) {
      if (expecting_ && expected_.list == l) continue;  // the node that is on its way out still counts, or no longer
      ASSERT_EQ((d.first_valid_o >> l) & 1, size(l) != 0) << "cycle " << bench_.cycle;
      if (size(l) != 0)
        ASSERT_EQ(static_cast<int>(get_bits(firsts.data(), kBucketW * l, kBucketW)), first(l))
            << "cycle " << bench_.cycle;
    }
    if (d.out_valid_o) {
      ASSERT_TRUE(expecting_);
      Words words(kDataWords + 1);
      read_port(d.out_data_o, words.data());
      ASSERT_EQ(d.out_list_o, expected_.list);
      ASSERT_EQ(d.out_bucket_o, expected_.bucket);
      ASSERT_EQ(get_bits(words.data(), 0, 64), expected_.data);
      ASSERT_EQ(get_bits(words.data(), 100, 64), ~expected_.data);
      expecting_ = false;
      ++popped;
    }
    if (d.pop_valid_i && d.pop_ready_o) {
      const int bucket = first(d.pop_list_i);
      auto& stack = stacks_[d.pop_list_i][bucket];
      expected_ = {d.pop_list_i, bucket, stack.back()};
      stack.pop_back();
      --held;
      expecting_ = true;
    }
    if (inserting_ && d.insert_ready_o) {
      ASSERT_LT(held, nodes_) << "more nodes than places";
      stacks_[insert_.list][insert_.bucket].push_back(insert_.data);
      ++held;
      inserting_ = false;
      most = std::max(most, held);
    }
    if (d.full_o) {
      ++full;
      ASSERT_GE(held + 2, nodes_) << "full with free places";
    }
  }
  uint64_t insert_percent = 50, pop_percent = 50, popped = 0, full = 0;
  int held = 0, most = 0;

 private:
  size_t size(int list) const {
    size_t n = 0;
    for (const auto& stack : stacks_[list]) n += stack.size();
    return n;
  }
  int first(int list) const {
    int bucket = 0;
    while (stacks_[list][bucket].empty()) ++bucket;
    return bucket;
  }
  Bench<Vdopu_bucket>& bench_;
  int nodes_;
  bool inserting_ = false, expecting_ = false;
  Entry insert_{}, expected_{};
  std::vector<std::vector<std::vector<uint64_t>>> stacks_{
      kLists, std::vector<std::vector<uint64_t>>(static_cast<size_t>(kChains))};
};

TEST(DopuBucket, PopsTheNewestOfTheFirstBucket) {
  Bench<Vdopu_bucket> bench;
  bench.dut.insert_valid_i = bench.dut.pop_valid_i = 0;
  Driver driver(bench, test_config().nearest_nodes);
  bench.reset();
  // Fills up, drains, lives at every level in between.
  const uint64_t paces[][2] = {{100, 0}, {100, 100}, {0, 100}, {100, 20}, {60, 60}, {20, 100}, {100, 100}, {0, 100}};
  for (const auto& [insert, pop] : paces) {
    driver.insert_percent = insert;
    driver.pop_percent = pop;
    for (int i = 0; i < 4000; ++i) {
      bench.step();
      ASSERT_FALSE(HasFatalFailure()) << "cycle " << bench.cycle << ", seed " << bench.seed;
    }
  }
  EXPECT_EQ(driver.most, test_config().nearest_nodes);
  EXPECT_EQ(driver.held, 0);
  EXPECT_GT(driver.full, 100u);
  EXPECT_GT(driver.popped, 2000u);
}

// Two cycles an insert, three a pop.
TEST(DopuBucket, KeepsItsPace) {
  Bench<Vdopu_bucket> bench;
  bench.dut.insert_valid_i = bench.dut.pop_valid_i = 0;
  Driver driver(bench, test_config().nearest_nodes);
  bench.reset();
  const int some = 16;
  driver.insert_percent = 100, driver.pop_percent = 0;
  const uint64_t begin = bench.cycle;
  ASSERT_TRUE(bench.run_until([&] { return driver.held == some; }));
  EXPECT_LE(bench.cycle - begin, 2u * some);
  driver.insert_percent = 0;
}

}  // namespace
}  // namespace pipegs
