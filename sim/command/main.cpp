// SPDX-License-Identifier: Apache-2.0
// main.cpp: the command line `pipegs`. Each subcommand lives in its own file; here, and nowhere else, what was thrown
// becomes an exit code.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>
#include <verilated_config.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <new>
#include <nlohmann/json.hpp>

#include "cpp_model/frame_setup.hpp"
#include "scenes/atomic_file.hpp"
#include "scenes/input_error.hpp"
#include "scenes/text/nearest.hpp"
#include "scenes/text/quote.hpp"
#include "sim/command/command.hpp"
#include "sim/command/option_groups.hpp"
#include "sim/command/terminal.hpp"
#include "sim/progress.hpp"
#include "sim/report/measurement_store.hpp"
#include "sim/rtl/rtl_fault.hpp"

namespace pipegs {
namespace {

int fail(int code, const std::string& what) {
  const std::string line = "pipegs: " + what;  // where this program fails it names its logs, which are not shortened
  fmt::print(stderr, "{}\n", code == kExitOwnFailure ? one_line(line) : message_line(line));
  return code;
}

template <class... Errors>
bool is(const std::exception& error) {
  return ((dynamic_cast<const Errors*>(&error) != nullptr) || ...);
}

int tell(const std::exception& error) {
  if (interrupted()) return fail(kExitInterrupted, error.what());
  if (is<InputError, ConfigError, FrameError>(error)) return fail(kExitBadInput, error.what());
  if (is<RtlFault>(error)) return fail(kExitDiffers, error.what());
  if (is<std::bad_alloc>(error)) return fail(kExitOwnFailure, "out of memory");
  if (is<std::logic_error>(error)) return fail(kExitOwnFailure, fmt::format("a bug of ours: {}", error.what()));
  return fail(kExitOwnFailure, error.what());
}

// Names of files go into reports, which are UTF-8 as all JSON is, and into lines of commands that run again.
void check_text(int argc, char** argv) {
  using Json = nlohmann::json;
  for (int i = 1; i < argc; ++i) {
    const std::string_view text = argv[i];
    if (!is_one_line(text))
      throw InputError(
          fmt::format("argument {}: found {}, expected one line without control characters", i, quote(text)));
    // CLI11 would take the next argument for its value.
    if (text.starts_with("--") && text.find('=') == text.size() - 1)
      throw InputError(fmt::format("{}: found '', expected a value", text.substr(0, text.size() - 1)));
    try {
      Json(argv[i]).dump();
    } catch (const Json::type_error&) {
      throw InputError(fmt::format("argument {}: found {}, expected text in UTF-8 (a name in Latin-1 must be changed)",
                                   i, Json(argv[i]).dump(-1, ' ', true, Json::error_handler_t::replace)));
    }
  }
}

bool has_studies(const CLI::App& app) {
  return !app.get_subcommands([](const CLI::App* command) { return command->get_name() == "study"; }).empty();
}

// Studies are in a program of their own, which also has all that is in this one: who runs none compiles none. What is
// no command here is one there, or in its list. Returns when there is no such program, or one of older sources.
void run_with_studies(const CLI::App& app, int argc, char** argv) {
  const auto named = [&](const CLI::App* command) { return argc > 1 && command->get_name() == argv[1]; };
  if (!app.get_subcommands(named).empty()) return;
  std::error_code none;
  const std::filesystem::path own = std::filesystem::read_symlink("/proc/self/exe", none);
  const std::filesystem::path studies = own.parent_path() / "pipegs-studies";
  const auto written = [&](const std::filesystem::path& file) { return std::filesystem::last_write_time(file, none); };
  if (std::filesystem::exists(studies, none) && written(studies) >= written(own)) execv(studies.c_str(), argv);
}

// A first word that is missing or no command, and behind `study` a second one that is no study.
void check_command(const CLI::App& app, int argc, char** argv) {
  const CLI::App* above = &app;
  for (int i = 1; i == argc || argv[i][0] != '-'; ++i) {
    const std::vector<const CLI::App*> commands = above->get_subcommands(nullptr);
    if (commands.empty()) return;
    const auto named = [&](const CLI::App* command) { return i < argc && command->get_name() == argv[i]; };
    const auto found = std::find_if(commands.begin(), commands.end(), named);
    if (found == commands.end()) {
      std::vector<std::string> names;
      for (const CLI::App* command : commands) {
        if (!command->get_group().empty()) names.push_back(command->get_name());  // else it is a hidden one
      }
      const std::string given =
          i == argc ? "nothing" : fmt::format("{} (nearest: {})", quote(argv[i]), nearest_word(argv[i], names));
      throw InputError(fmt::format("found {}, expected a {}: {}{}", given, i == 1 ? "command" : above->get_name(),
                                   fmt::join(names, ", "),
                                   has_studies(app) ? "" : " (studies are in pipegs-studies: make build)"));
    }
    above = *found;
  }
}

int run_command(CLI::App& app, int argc, char** argv, const Run& run) {
  check_text(argc, argv);
  check_command(app, argc, argv);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) {  // --help
      app.exit(error);
      return std::cout.flush() ? kExitOk : fail(kExitOwnFailure, "standard output cannot be written");
    }
    return fail(kExitBadInput, fmt::format("{} (--help shows how)", error.what()));
  }
  const CLI::App* chosen = &app;
  while (!chosen->get_subcommands().empty()) chosen = chosen->get_subcommands().front();
  const Progress stage(chosen->get_name());
  const int code = run();
  if (interrupted()) return fail(kExitInterrupted, "interrupted");
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
    return fail(kExitOwnFailure, "standard output cannot be written");
  return code;
}

}  // namespace
}  // namespace pipegs

int main(int argc, char** argv) {
  using namespace pipegs;
  guard_terminal();
  watch_interrupts();
  CLI::App app("PipeGS: 3D Gaussian splatting hardware, simulated and compared bit for bit");
  app.require_subcommand(1);
  app.set_version_flag("--version", fmt::format("PipeGS, not released; sources of the models {:.12}; Verilator {}",
                                                measured_by(), VERILATOR_VERSION));
  app.footer(
      "COMMAND --help lists its options, --version the sources. Exit codes: 0 agrees or\n"
      "done, 1 differs, 2 bad input or bad use, 3 our own failure, 130 interrupted.");
  Run run;
  add_sim(app, run);
  add_render(app, run);
  add_explain(app, run);
  add_ladder(app, run);
  add_model(app, run);
  add_what_if(app, run);
  add_config(app, run);
  add_effects(app, run);
  add_silicon(app, run);
  add_campaign(app, run);
  add_point(app, run);
  add_report(app, run);
  add_info(app, run);
  add_convert(app, run);
  add_pack(app, run);
  const auto study = std::make_shared<CLI::App>("a study of the machine or its models by NAME", "study");
  study->require_subcommand(1);
  study->footer("NAME --help lists its options.");
  add_studies(app, *study, run);
  if (!study->get_subcommands(nullptr).empty()) app.add_subcommand(study);
  if (!has_studies(app)) run_with_studies(app, argc, argv);
  group_options(app);
  // The footer names these two. Hidden only now: a command takes over --help where it is shown.
  for (const char* flag : {"--help", "--version"}) app.get_option(flag)->group("");
  int code = kExitOk;
  try {
    code = run_command(app, argc, argv, run);
  } catch (const std::exception& error) { code = tell(error); }
  if (code == kExitInterrupted) abandon_files();
  return code;
}
