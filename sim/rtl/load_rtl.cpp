// SPDX-License-Identifier: Apache-2.0
// load_rtl.cpp: finds, builds when needed, and opens the shared library of one configuration and variant.
//
// The libraries lie in the build folder under rtl/<configuration><variant>, as in rtl/units=2+waves;
// sim/rtl/build_rtl.sh brings one up to date and does nothing when it is. They stay open until the program ends:
// Verilated code must not be unloaded while it is in use.
#include <dlfcn.h>
#include <fmt/format.h>
#include <unistd.h>

#include <climits>
#include <filesystem>
#include <sstream>

#include "scenes/own_failure.hpp"
#include "sim/progress.hpp"
#include "sim/rtl/rtl_model.hpp"
#include "sim/run_program.hpp"

namespace pipegs {
namespace {

// The variant as sim/rtl/build_rtl.sh takes it: words that begin with +.
std::string variant_words(const RtlVariant& variant, const char* between) {
  std::string words;
  if (variant.waves) words += fmt::format("{}+waves", between);
  if (!variant.asserts) words += fmt::format("{}+noasserts", between);
  for (const std::string& unit : variant.gates) words += fmt::format("{}+{}", between, unit);
  return words;
}

// The folder of a name, CMake's too. One that no file system takes becomes folders in each other, cut at commas.
std::filesystem::path folder_of(std::string name) {
  constexpr size_t kLongest = NAME_MAX;
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
  if (!variant.gates.empty() && !options.waves.empty()) throw ConfigError("--waves: the netlist writes none");
  variant.waves = !options.waves.empty();
  return variant;
}

std::string build_rtl(const Config& config, const RtlVariant& variant) {
  const std::string difference = config_difference(config), name = difference + variant_words(variant, "");
  const std::filesystem::path folder = std::filesystem::path(PIPEGS_BUILD_DIR) / "rtl" / folder_of(name);
  const std::filesystem::path library = folder / "librtl.so", log = folder / "build.log";
  std::vector<std::string> words = {PIPEGS_SOURCE_DIR "/sim/rtl/build_rtl.sh", PIPEGS_BUILD_DIR, folder.string()};
  require_own_file(words[0]);
  std::istringstream more(variant_words(variant, " ") + (difference == "default" ? "" : " " + difference));
  for (std::string word; more >> word;) {
    std::istringstream settings(word);
    for (std::string setting; std::getline(settings, setting, ',');) words.push_back(setting);
  }
  words.push_back("+fresh");  // looks only: who may not write can use what is there
  if (run_program(words) == 0) return library.string();
  words.pop_back();
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (access(folder.c_str(), W_OK) != 0)
    throw RtlBuildError(fmt::format(
        "the RTL of configuration {} is not built, or not of these sources, and nothing can be written in {}", name,
        folder.string()));
  fmt::print(stderr, "building the RTL for configuration {} ...\n", name);
  const Progress stage("building the RTL");
  if (run_program(words, log) != 0)
    throw RtlBuildError(fmt::format("the RTL of configuration {} does not build: see {}", name, log.string()));
  return library.string();
}

std::unique_ptr<RtlModel> load_rtl(const Config& config, const RtlVariant& variant) {
  return open_rtl(build_rtl(config, variant), config);
}

std::unique_ptr<RtlModel> open_rtl(const std::string& library, const Config& config) {
  void* handle = dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) throw OwnFailure(fmt::format("{}: {}", library, dlerror()));
  using Create = RtlModel* (*)(const Config*);
  const auto create = reinterpret_cast<Create>(dlsym(handle, "pipegs_rtl_create"));
  if (create == nullptr) throw OwnFailure(fmt::format("{}: no pipegs_rtl_create", library));
  return std::unique_ptr<RtlModel>(create(&config));
}

}  // namespace pipegs
