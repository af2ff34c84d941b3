// SPDX-License-Identifier: Apache-2.0
// ply_header_fuzz: any bytes as the header of a .ply: it is refused with an InputError, or each name in it comes once.
#include <cstdlib>
#include <set>

#include "scenes/input_error.hpp"
#include "scenes/ply/ply_file.hpp"
#include "verif/fuzz/keep.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace pipegs;
  try {
    PlySource source("fuzz.ply", std::string(reinterpret_cast<const char*>(data), size));
    const PlyHeader header = read_ply_header(source);
    if (source.remaining() > size) std::abort();
    Kept<3> kept;
    std::set<std::string> elements;
    for (const PlyElement& element : header.elements) {
      if (!elements.insert(element.name).second) std::abort();
      std::set<std::string> properties;
      for (const PlyProperty& property : element.properties) {
        if (!properties.insert(property.name).second) std::abort();
        kept.add(property.name);
      }
    }
  } catch (const InputError& error) { refused(error); }
  return 0;
}
