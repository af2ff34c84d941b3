// SPDX-License-Identifier: Apache-2.0
// pack_image: the packed scene as lines of external memory; see pack.hpp.
//
// Idea    With lod = 1 a cell's count is longer than the field: its upper bits are where a group has its error.
// Layout  cells, groups, chunks: 2 nodes in a line | geometry: GaussiansPerLine in a line, each at its part |
//         colours: as packed | the frame begins at layout.pixels.
#include "cpp_model/pack/pack.hpp"

namespace pipegs {
namespace {

template <class R, class Table>
void put_records(const Config& config, const Table& records, uint64_t first, int per_line,
                 std::vector<MemoryLine>& lines) {
  std::vector<uint32_t> words(static_cast<size_t>(record_words<R>(config)));
  for (size_t i = 0; i < records.size(); ++i) {
    pack(config, records[i], words.data());
    MemoryLine& line = lines.at(first + i / static_cast<size_t>(per_line));
    const size_t at = i % static_cast<size_t>(per_line) * (line.size() / static_cast<size_t>(per_line));
    for (size_t w = 0; w < words.size(); ++w) line.at(at + w) = words[w];
  }
}

}  // namespace

MemoryImage memory_image(const PackedScene& packed) {
  MemoryImage image;
  image.layout = packed.layout;
  image.lines.resize(packed.layout.pixels);
  std::vector<Node> cells = packed.cells;
  for (Node& cell : cells) {
    if (packed.config.lod) cell.error = cell.count >> packed.config.count_w();
    cell.count &= (uint64_t{1} << packed.config.count_w()) - 1;
  }
  put_records<Node>(packed.config, cells, packed.layout.cells, 2, image.lines);
  put_records<Node>(packed.config, packed.groups, packed.layout.groups, 2, image.lines);
  put_records<Node>(packed.config, packed.chunks, packed.layout.chunks, 2, image.lines);
  const auto put_geometry = [&]<class R>(const NarrowTable<R>& table) {
    put_records<R>(packed.config, table, packed.layout.gaussians, packed.config.gaussians_per_line(), image.lines);
  };
  packed.config.coded() ? put_geometry(packed.codes) : put_geometry(packed.gaussians);
  for (size_t i = 0; i < packed.colors.size(); ++i) image.lines.at(packed.layout.colors + i) = packed.colors[i];
  return image;
}

}  // namespace pipegs
