// SPDX-License-Identifier: Apache-2.0
// checkpoint: see checkpoint.hpp.
//
// Idea    visit() names every field of a state once, for the writer and for the reader.
#include "sim/studies/train/run/checkpoint.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <cmath>
#include <cstring>
#include <fstream>
#include <string>
#include <type_traits>

#include "scenes/atomic_file.hpp"
#include "scenes/packed/byte_reader.hpp"
#include "scenes/generate/generate_random.hpp"
#include "scenes/own_failure.hpp"
#include "scenes/text/text_file.hpp"

namespace pipegs {
namespace {

constexpr std::string_view kMagic = "PIPEGSCK";
constexpr std::uint32_t kVersion = 1;
constexpr std::uint64_t kMostBytes = std::uint64_t{1} << 36;

template <class Archive, class P>
void visit_parameters(Archive& archive, P& p, const std::string& of) {
  archive.field(of + " sh_degree", p.sh_degree);
  each_array(p, [&](const char* name, auto& values) { archive.array(of + " " + name, values); });
}

template <class Archive, class State>
void visit(Archive& archive, State& state) {
  archive.field("step", state.step);
  archive.field("seconds", state.seconds);
  archive.field("grid", state.grid.cells);
  archive.field("grid", state.grid.low);
  archive.field("grid", state.grid.cell_size);
  visit_parameters(archive, state.parameters, "parameters");
  visit_parameters(archive, state.moments.first, "first moments");
  visit_parameters(archive, state.moments.second, "second moments");
  archive.array("demand", state.demand.sum);
  archive.array("demand", state.demand.seen);
}

struct Writer {
  std::string bytes;

  void raw(const void* data, std::size_t size) { bytes.append(static_cast<const char*>(data), size); }
  template <class Value>
  void field(const std::string&, const Value& value) {
    raw(&value, sizeof value);
  }
  template <class Value>
  void array(const std::string& name, const std::vector<Value>& values) {
    field(name, std::uint64_t{values.size()});
    raw(values.data(), values.size() * sizeof(Value));
  }
};

struct Reader {
  ByteReader& bytes;

  template <class Value>
  void field(const std::string& name, Value& value) {
    value = bytes.take<Value>(name);
  }
  template <class Value>
  void array(const std::string& name, std::vector<Value>& values) {
    values.resize(static_cast<std::size_t>(bytes.count(sizeof(Value), name)));
    if (!values.empty())
      std::memcpy(values.data(), bytes.skip(values.size() * sizeof(Value), name).data(), values.size() * sizeof(Value));
  }
};

// Adds what it visits to a mark.
struct Marker {
  std::uint64_t mark = kVersion;

  void raw(const void* data, std::size_t size) {
    const uLong sum = crc32(crc32(0, nullptr, 0), static_cast<const Bytef*>(data), static_cast<uInt>(size));
    mark = generate::mixed(mark * 0x9e3779b97f4a7c15u + sum + 1);
  }
  template <class Value>
  void field(const std::string&, const Value& value) {
    raw(&value, sizeof value);
  }
  template <class Value>
  void array(const std::string& name, const std::vector<Value>& values) {
    field(name, std::uint64_t{values.size()});
    constexpr std::size_t kAtOnce = std::size_t{1} << 24;
    for (std::size_t i = 0; i < values.size(); i += kAtOnce)
      raw(values.data() + i, std::min(kAtOnce, values.size() - i) * sizeof(Value));
  }
};

template <class Value>
void check_finite(const std::filesystem::path& path, const std::string& name, const std::vector<Value>& values) {
  const auto* floats = reinterpret_cast<const float*>(values.data());
  const std::size_t count = values.size() * sizeof(Value) / sizeof(float);
  for (std::size_t i = 0; i < count; ++i) {
    if (!std::isfinite(floats[i]))
      throw InputError(path.string(), name, fmt::format("found {}, expected a finite number", floats[i]));
  }
}

void check_parameters(const std::filesystem::path& path, const std::string& of, const Parameters& p) {
  try {
    check_consistent(p);
  } catch (const std::invalid_argument& error) { throw InputError(path.string(), of, error.what()); }
  each_array(p, [&](const char*, const auto& values) { check_finite(path, of, values); });
}

void check_state(const std::filesystem::path& path, const TrainState& state) {
  check_parameters(path, "parameters", state.parameters);
  check_parameters(path, "first moments", state.moments.first);
  check_parameters(path, "second moments", state.moments.second);
  check_finite(path, "demand", state.demand.sum);
  const std::size_t count = state.parameters.size();
  const bool fits = state.step >= 0 && state.moments.first.size() == count && state.moments.second.size() == count &&
                    state.moments.first.sh_degree == state.parameters.sh_degree &&
                    state.moments.second.sh_degree == state.parameters.sh_degree && state.demand.sum.size() == count &&
                    state.demand.seen.size() == count;
  if (!fits) throw InputError(path.string(), "", "its arrays contradict each other, expected a checkpoint of training");
}

}  // namespace

std::uint64_t run_mark(const TrainOptions& options, const TrainingViews& views, const Parameters& start) {
  Marker marker;
  marker.field("", options.schedule.steps);
  marker.field("", options.schedule.fine_tuning);
  marker.field("", options.seed);
  marker.field("", options.most_gaussians);
  marker.field("", options.layers);
  marker.field("", options.draws_layered);
  marker.field("", options.regularised);
  marker.field("", options.cldr.form);
  marker.field("", options.layers_begin);
  marker.field("", options.cldr.weight);
  marker.field("", views.extent);
  for (const TrainingView& view : views.trained) {
    const Camera& camera = view.camera;
    marker.field("", camera.position);
    marker.field("", camera.world_to_camera);
    for (const double value : {camera.fx, camera.fy, camera.cx, camera.cy}) marker.field("", value);
    marker.field("", camera.width);
    marker.field("", camera.height);
    marker.field("", view.near_plane);
    marker.array("", view.codes);
    marker.array("", view.computed);
  }
  visit_parameters(marker, start, "");
  return marker.mark;
}

void write_checkpoint(const std::filesystem::path& path, std::uint64_t mark, const TrainState& state) {
  Writer writer;
  writer.bytes = kMagic;
  writer.field("", kVersion);
  writer.field("", mark);
  visit(writer, state);
  const auto sum = static_cast<std::uint32_t>(
      crc32_z(crc32_z(0, nullptr, 0), reinterpret_cast<const Bytef*>(writer.bytes.data()), writer.bytes.size()));
  writer.field("", sum);
  AtomicFile file(path);
  std::ofstream out(file.temporary(), std::ios::binary);
  out.write(writer.bytes.data(), static_cast<std::streamsize>(writer.bytes.size()));
  out.close();
  if (!out) throw OwnFailure(path.string() + ": cannot write");
  file.commit();
}

TrainState read_checkpoint(const std::filesystem::path& path, std::uint64_t mark) {
  const std::string data = read_text_file(path, "a checkpoint", kMostBytes);
  const auto refuse = [&](const std::string& what) { throw InputError(path.string(), "", what); };
  const std::string name = path.string();
  constexpr std::size_t kSumBytes = sizeof(std::uint32_t);
  if (data.size() < kMagic.size() + kSumBytes || !data.starts_with(kMagic))
    refuse("found something else, expected a checkpoint of training");
  ByteReader end(name, std::string_view(data).substr(data.size() - kSumBytes));
  const auto sum = static_cast<std::uint32_t>(
      crc32_z(crc32_z(0, nullptr, 0), reinterpret_cast<const Bytef*>(data.data()), data.size() - kSumBytes));
  if (sum != end.take<std::uint32_t>("checksum")) refuse("the checksum is wrong: it was cut or changed");
  ByteReader bytes(name, std::string_view(data).substr(kMagic.size(), data.size() - kMagic.size() - kSumBytes));
  if (const auto version = bytes.take<std::uint32_t>("version"); version != kVersion)
    refuse(fmt::format("found version {}, expected {}", version, kVersion));
  if (bytes.take<std::uint64_t>("mark") != mark)
    refuse("it is of another run, expected the same input and options (without --resume a new run begins)");
  TrainState state;
  Reader reader{bytes};
  visit(reader, state);
  if (bytes.remaining() > 0) refuse(fmt::format("found {} bytes behind the state, expected none", bytes.remaining()));
  check_state(path, state);
  return state;
}

}  // namespace pipegs
