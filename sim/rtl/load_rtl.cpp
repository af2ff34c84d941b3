// SPDX-License-Identifier: Apache-2.0
// load_rtl.cpp: finds, builds when needed, and opens the shared library of one configuration and variant.
//
// The libraries lie in the build folder under rtl/<configuration><variant>, as in rtl/units=2+waves;
// sim/rtl/build_rtl.sh brings one up to date and does nothing when it is. They stay open until the program ends:
// Verilated code must not be unloaded while it is in use.
#include <dlfcn.h>
#include <fmt/format.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>

#include "sim/progress.hpp"
#include "scenes/own_failure.hpp"
#include "sim/rtl/rtl_model.hpp"

namespace pipegs {
namespace {

// The variant as sim/rtl/build_rtl.sh takes it: words that begin with +.
std::string variant_words(const RtlVariant& variant, const char* between) {
  std::string words;
  if (variant.waves) words += fmt::format("{}+waves", between);
  if (!variant.asserts) words += fmt::format("{}+noasserts", between);
  if (variant.netlist) words += fmt::format("{}+netlist", between);
  return words;
}

// The folder of a name. One that a file system might not take (255 bytes) becomes folders in each other, cut at commas.
std::filesystem::path folder_of(std::string name) {
  constexpr size_t kLongest = 200;
  std::filesystem::path folder;
  while (name.size() > kLongest) {
    const size_t comma = name.rfind(',', kLongest);
    folder /= name.substr(0, comma);
    name.erase(0, comma + 1);
  }
  return folder / name;
}

}  // namespace

RtlVariant built_variant(RtlVariant variant, const RtlOptions& options) {
  if (variant.netlist && !options.waves.empty()) throw ConfigError("--waves: the netlist writes none");
  variant.waves = !options.waves.empty();
  return variant;
}

std::string build_rtl(const Config& config, const RtlVariant& variant) {
  const std::string difference = config_difference(config), name = difference + variant_words(variant, "");
  const std::filesystem::path folder = std::filesystem::path(PIPEGS_BUILD_DIR) / "rtl" / folder_of(name);
  std::string command =
      fmt::format("'{}/sim/rtl/build_rtl.sh' '{}' '{}'", PIPEGS_SOURCE_DIR, PIPEGS_BUILD_DIR, folder.string());
  command += variant_words(variant, " ");
  if (difference != "default") {
    std::string settings = " " + difference;
    for (char& c : settings) c = c == ',' ? ' ' : c;
    command += settings;
  }
  const std::filesystem::path library = folder / "librtl.so", log = folder / "build.log";
  std::filesystem::create_directories(folder);
  if (!std::filesystem::exists(library)) fmt::print(stderr, "building the RTL for configuration {} ...\n", name);
  if (std::system((command + " > '" + log.string() + "' 2>&1").c_str()) != 0) {
    throw RtlBuildError(fmt::format("the RTL of configuration {} does not build: see {}", name, log.string()));
  }
  return library.string();
}

std::unique_ptr<RtlModel> load_rtl(const Config& config, const RtlVariant& variant) {
  const std::string library = build_rtl(config, variant);
  void* handle = dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) throw OwnFailure(fmt::format("{}: {}", library, dlerror()));
  using Create = RtlModel* (*)(const Config*);
  const auto create = reinterpret_cast<Create>(dlsym(handle, "pipegs_rtl_create"));
  if (create == nullptr) throw OwnFailure(fmt::format("{}: no pipegs_rtl_create", library));
  return std::unique_ptr<RtlModel>(create(&config));
}

}  // namespace pipegs
