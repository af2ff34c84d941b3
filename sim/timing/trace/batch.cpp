// SPDX-License-Identifier: Apache-2.0
// batch.cpp: an experiment: many runs on one trace. A line of X_BATCH is one, in a process of its own: "NAME K=V ...",
// with PLAN=file, RECORDS=n, DRAM=name; NAME.json and NAME.err are what it says.
#include <fcntl.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <unistd.h>

#include <bit>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <fstream>
#include <sstream>
#include <string>

#include "sim/memory/dram_memory.hpp"
#include "sim/timing/knobs.hpp"
#include "sim/timing/timing_model.hpp"
#include "sim/timing/trace/trace.hpp"

namespace pipegs {

void run_batch(TimingTrace& trace) {
  if (const char* dump = knob_text("X_DUMP")) dump_waits(trace, dump);
  const char* name = knob_text("X_BATCH");
  if (name == nullptr) return;
  std::ifstream lines(name);
  const bool serve = knob("X_SERVE", 0) != 0;
  for (std::string line; std::getline(lines, line) || serve;) {
    if (!lines) {
      lines.clear();
      lines.seekg(0, std::ios::cur);
      usleep(500000);
      continue;
    }
    if (line == "quit") break;
    if (line.empty() || line[0] == '#') continue;
    std::fflush(stdout);
    int slot = -1;
    while (serve && slot < 0) {  // 2: held by who wrote the line
      if (knob("X_SERVE", 0) == 2) break;
      for (const char* at : {"/work/w/slots/0", "/work/w/slots/1"}) {
        slot = access("/work/w/quiet", F_OK) == 0 ? -1 : open(at, O_RDWR);
        if (slot >= 0 && flock(slot, LOCK_EX | LOCK_NB) == 0) break;
        if (slot >= 0) close(slot);
        slot = -1;
      }
      if (slot < 0) usleep(1000000);
    }
    const pid_t child = fork();
    if (child != 0) {
      int status = 0;
      waitpid(child, &status, 0);
      if (slot >= 0) close(slot);
      if (FILE* done = std::fopen((line.substr(0, line.find(' ')) + ".done").c_str(), "w")) std::fclose(done);
      if (status != 0) std::fprintf(stderr, "failed: %s\n", line.c_str());
      continue;
    }
    std::istringstream words(line);
    std::string out, word;
    words >> out;
    while (words >> word) {
      const size_t at = word.find('=');
      setenv(word.substr(0, at).c_str(), word.substr(at + 1).c_str(), 1);
    }
    FILE* json = std::fopen((out + ".json").c_str(), "w");
    stderr = std::fopen((out + ".err").c_str(), "w");
    if (json == nullptr || stderr == nullptr) _exit(1);
    Config config = trace.config;
    if (const char* records = knob_text("RECORDS")) config.records = std::atoi(records);
    ExternalMemoryOptions memory;
    memory.dram = kDefaultDram;
    memory.jitter = 20;
    if (const char* dram = knob_text("DRAM")) memory.dram = dram;
    try {
      apply_plan(trace, knob_text("PLAN"));
      size_t split = 0, visible = 0;
      for (const TimingWalk& walk : trace.walks) split += walk.last && walk.variant != 'W';
      for (const TimingWalk& walk : trace.walks)
        for (size_t i = walk.first_chunk; i < walk.first_chunk + walk.chunks; ++i) visible += static_cast<size_t>(std::popcount(trace.chunks_sent[i].survivors));
      const TimingResult r = timing_run(trace, config, memory);
      std::fprintf(json, "{\"cycles\": %llu, \"walks\": %zu, \"split\": %zu, \"visible\": %zu, \"bytes\": {", static_cast<unsigned long long>(r.cycles), trace.walks.size(), split, visible);
      bool first = true;
      for (const MemoryTraffic& s : r.streams) {
        std::fprintf(json, "%s\"%s\": %llu", first ? "" : ", ", s.stream.c_str(), static_cast<unsigned long long>(s.bytes_read + s.bytes_written));
        first = false;
      }
      std::fprintf(json, "}, \"window_ends\": [");
      for (size_t i = 0; i < r.window_ends.size(); ++i) std::fprintf(json, "%s%llu", i == 0 ? "" : ", ", static_cast<unsigned long long>(r.window_ends[i]));
      std::fprintf(json, "]}\n");
    } catch (const std::exception& e) {
      std::fprintf(stderr, "error: %s\n", e.what());
      std::fflush(stderr);
      _exit(1);
    }
    std::fclose(json);
    std::fflush(stderr);
    _exit(0);
  }
  std::fflush(stderr);
  _exit(0);
}

}  // namespace pipegs
