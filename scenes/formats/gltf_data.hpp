// SPDX-License-Identifier: Apache-2.0
// gltf_data: the JSON of a glTF file and the bytes that it describes: buffers, views of them, accessors.
//
// Layout  A .glb is a header, a chunk of JSON and a chunk of bytes, which is the first buffer. Other buffers are data
//         URIs or files beside it. An accessor is `count` elements of a few numbers, `stride` apart.
// Rule    What a view or an accessor claims is held against its buffer. Sparse accessors and compressed buffers are
//         refused: no writer of Gaussians makes them.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "scenes/packed/input_file.hpp"
#include "scenes/text/json_node.hpp"

namespace pipegs {

struct GltfAccessor {
  InputFile buffer;  // keeps the bytes
  const std::uint8_t* bytes;
  std::uint64_t count, stride;
  int component;  // 5120 int8, 5121 uint8, 5122 int16, 5123 uint16, 5125 uint32, 5126 float
  bool normalized;

  double value(std::size_t i, int k) const;
  std::string type() const;
};

class GltfData {
 public:
  explicit GltfData(const InputFile& file);

  const JsonNode& json() const { return json_; }
  std::uint64_t bytes() const { return bytes_.sum(); }  // of the file and all buffers that were used
  std::uint64_t behind() const { return behind_; }      // of a .glb behind its length
  // InputError when the file cannot be shown without an extension that is none of `known`.
  void check_required(const std::vector<std::string>& known) const;

  // `index` is where the file names an accessor or a view.
  GltfAccessor accessor(const JsonNode& index, std::uint64_t width);
  InputFile view(const JsonNode& index);

 private:
  const InputFile& buffer(const JsonNode& index);
  void check_component(const JsonNode& entry, std::uint64_t view, std::uint64_t numbers, std::uint64_t room);

  InputFile file_, binary_;  // binary_: the second chunk of a .glb
  JsonNode json_;
  std::map<std::uint64_t, InputFile> buffers_;
  std::map<std::string, InputFile> files_;  // by their URI: read once
  std::map<std::uint64_t, int> users_;      // accessors of a view; empty: not looked at yet
  PackedBytes bytes_;
  std::uint64_t behind_ = 0;
};

}  // namespace pipegs
