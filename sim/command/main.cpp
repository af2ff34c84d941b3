// main.cpp: the command line `pipegs`. Each subcommand lives in its own file.
#include <fmt/format.h>

#include "scenes/input_error.hpp"
#include "sim/command/command.hpp"
#include "sim/progress.hpp"

int main(int argc, char** argv) {
  using namespace pipegs;
  watch_interrupts();
  CLI::App app("PipeGS: a 3D Gaussian splatting accelerator in SystemVerilog, simulated and compared bit for bit");
  app.require_subcommand(1);
  Run run;
  add_sim(app, run);
  add_render(app, run);
  add_explain(app, run);
  add_ladder(app, run);
  add_profile(app, run);
  add_timeline(app, run);
  add_sweep(app, run);
  add_dram(app, run);
  add_model(app, run);
  add_accuracy(app, run);
  add_fidelity(app, run);
  add_stress(app, run);
  add_budget(app, run);
  add_effects(app, run);
  add_silicon(app, run);
  add_info(app, run);
  try {
    app.parse(argc, argv);
    return run();
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kExitOk : kExitBadInput;
  } catch (const InputError& error) {
    fmt::print(stderr, "pipegs: {}\n", error.what());
    return kExitBadInput;
  } catch (const ConfigError& error) {
    fmt::print(stderr, "pipegs: {}\n", error.what());
    return kExitBadInput;
  } catch (const std::invalid_argument& error) {
    fmt::print(stderr, "pipegs: {}\n", error.what());
    return kExitBadInput;
  } catch (const std::exception& error) {
    fmt::print(stderr, "pipegs: {}\n", error.what());
    return interrupted() ? kExitInterrupted : kExitMismatch;
  }
}
