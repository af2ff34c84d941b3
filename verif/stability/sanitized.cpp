// SPDX-License-Identifier: Apache-2.0
// sanitized: the golden model, compiled so that a signed overflow, a bad shift, a division by zero or an index out of
// bounds ends the program, on hostile and random scenes.
//
// Prints one hash of all pixels: stability_sanitize_test holds it against the optimised build's, for a model whose bits
// depend on optimisation would not be one (T28).
#include <cstdio>
#include <cstdlib>

#include "sim/bounds/hostile_scene.hpp"
#include "verif/stability/support/pixel_hash.hpp"

int main(int argc, char** argv) {
  const int count = argc > 1 ? std::atoi(argv[1]) : 20;
  std::printf("%016llx\n", static_cast<unsigned long long>(pipegs::hostile_hash(count)));
}
