// SPDX-License-Identifier: Apache-2.0
// ply_body: decoding of element rows; see ply_file.hpp.
//
// Idea    Three paths, by rising generality: rows of fixed size in blocks, rows with lists property
//         by property, ASCII word by word, a line for each row.
#include "scenes/ply/ply_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "scenes/input_error.hpp"
#include "scenes/scene.hpp"
#include "scenes/text/number.hpp"

namespace pipegs {
namespace {

static_assert(std::endian::native == std::endian::little, "ply_body decodes for little-endian hosts");

constexpr std::size_t kBlockBytes = std::size_t{1} << 18;

template <typename T>
T load(const std::uint8_t* bytes, bool swap) {
  std::uint8_t copy[sizeof(T)];
  std::memcpy(copy, bytes, sizeof(T));
  if (swap) std::reverse(copy, copy + sizeof(T));
  T value;
  std::memcpy(&value, copy, sizeof(T));
  return value;
}

double load_scalar(const std::uint8_t* bytes, PlyType type, bool swap) {
  switch (type) {
    case PlyType::kInt8: return load<std::int8_t>(bytes, swap);
    case PlyType::kUint8: return load<std::uint8_t>(bytes, swap);
    case PlyType::kInt16: return load<std::int16_t>(bytes, swap);
    case PlyType::kUint16: return load<std::uint16_t>(bytes, swap);
    case PlyType::kInt32: return load<std::int32_t>(bytes, swap);
    case PlyType::kUint32: return load<std::uint32_t>(bytes, swap);
    case PlyType::kFloat32: return load<float>(bytes, swap);
    case PlyType::kFloat64: return load<double>(bytes, swap);
  }
  return 0;
}

double parse_ascii(std::string_view word, PlyType type) {
  switch (type) {
    case PlyType::kInt8: return parse_integer<std::int8_t>(word);
    case PlyType::kUint8: return parse_integer<std::uint8_t>(word);
    case PlyType::kInt16: return parse_integer<std::int16_t>(word);
    case PlyType::kUint16: return parse_integer<std::uint16_t>(word);
    case PlyType::kInt32: return parse_integer<std::int32_t>(word);
    case PlyType::kUint32: return parse_integer<std::uint32_t>(word);
    default: return parse_value(word);
  }
}

bool has_lists(const PlyElement& element) {
  return std::any_of(element.properties.begin(), element.properties.end(), [](const auto& p) { return p.is_list; });
}

// The least a row can take: lists empty, ASCII words of one character and a separator.
std::size_t least_row_bytes(PlyFormat format, const PlyElement& element) {
  if (format == PlyFormat::kAscii) return 2 * element.properties.size();
  std::size_t bytes = 0;
  for (const PlyProperty& p : element.properties) bytes += size_of(p.is_list ? p.count_type : p.type);
  return bytes;
}

struct Reader {
  PlySource& source;
  PlyFormat format;
  const PlyElement& element;
  const std::vector<int>& slots;
  std::vector<float>& row;
  const std::function<void(std::size_t)>& on_row;
  double* wide;
  bool swap = format == PlyFormat::kBigEndian;

  [[noreturn]] void fail(std::uint64_t i, const std::string& field, const std::string& what) const {
    throw InputError(source.file(), fmt::format("{} {}, {}", element.name, i, field), what);
  }

  void fixed_rows() {
    struct Field {
      std::size_t offset;
      PlyType type;
      int slot;
    };
    std::vector<Field> fields;
    std::size_t row_bytes = 0;
    for (std::size_t p = 0; p < slots.size(); ++p) {
      const PlyType type = element.properties[p].type;
      if (slots[p] != kSkip) fields.push_back({row_bytes, type, slots[p]});
      row_bytes += size_of(type);
    }
    const std::uint64_t per_block = std::max<std::size_t>(1, kBlockBytes / row_bytes);
    for (std::uint64_t done = 0; done < element.count;) {
      const std::uint64_t n = std::min(per_block, element.count - done);
      const std::uint8_t* bytes = source.take(static_cast<std::size_t>(n) * row_bytes);
      for (std::uint64_t i = 0; i < n; ++i, bytes += row_bytes) {
        for (const Field& field : fields) {
          const std::uint8_t* at = bytes + field.offset;
          if (field.slot <= kWide) wide[kWide - field.slot] = load_scalar(at, field.type, swap);
          else if (field.type == PlyType::kFloat32) row[static_cast<std::size_t>(field.slot)] = load<float>(at, swap);
          else row[static_cast<std::size_t>(field.slot)] = narrow(load_scalar(at, field.type, swap));
        }
        on_row(static_cast<std::size_t>(done + i));
      }
      done += n;
    }
  }

  double binary_value(std::uint64_t i, const PlyProperty& property, PlyType type) {
    if (source.remaining() < size_of(type)) fail(i, property.name, "the file ends here, expected a value");
    return load_scalar(source.take(size_of(type)), type, swap);
  }

  double ascii_value(std::uint64_t i, const PlyProperty& property, PlyType type) {
    const std::string_view word = source.word();
    if (word.empty())
      fail(i, property.name,
           fmt::format("the {} ends here, expected a number", source.remaining() == 0 ? "file" : "line"));
    try {
      return parse_ascii(word, type);
    } catch (const NumberError& error) { fail(i, property.name, error.what()); }
  }

  void skip_list(std::uint64_t i, const PlyProperty& property) {
    const bool ascii = format == PlyFormat::kAscii;
    const double count =
        ascii ? ascii_value(i, property, property.count_type) : binary_value(i, property, property.count_type);
    const double least = ascii ? 1 : static_cast<double>(size_of(property.type));
    if (!(count >= 0) || count != std::floor(count) || count * least > static_cast<double>(source.remaining())) {
      fail(i, property.name, fmt::format("found a list of {:g} entries, expected at most what the file holds", count));
    }
    auto left = static_cast<std::uint64_t>(count);
    if (ascii) {
      for (; left > 0; --left) ascii_value(i, property, property.type);
      return;
    }
    for (left *= size_of(property.type); left > 0;) {
      const auto n = static_cast<std::size_t>(std::min<std::uint64_t>(left, kBlockBytes));
      source.take(n);
      left -= n;
    }
  }

  void general_rows() {
    const bool ascii = format == PlyFormat::kAscii;
    for (std::uint64_t i = 0; i < element.count; ++i) {
      if (ascii) source.next_line();  // a row is a line; without one the first value says what is missing
      for (std::size_t p = 0; p < slots.size(); ++p) {
        const PlyProperty& property = element.properties[p];
        if (property.is_list) {
          skip_list(i, property);
          continue;
        }
        const double value = ascii ? ascii_value(i, property, property.type) : binary_value(i, property, property.type);
        if (slots[p] <= kWide) wide[kWide - slots[p]] = value;
        else if (slots[p] != kSkip) row[static_cast<std::size_t>(slots[p])] = narrow(value);
      }
      if (const std::string_view more = ascii ? source.word() : std::string_view{}; !more.empty())
        fail(i, "line", fmt::format("found {} behind the last value, expected the end of the line", quote(more)));
      on_row(static_cast<std::size_t>(i));
    }
  }
};

}  // namespace

void check_fits(const PlySource& source, PlyFormat format, const PlyElement& element) {
  const std::size_t bytes = least_row_bytes(format, element);
  if (bytes == 0 || element.count == 0) return;
  // The last word of an ASCII file needs no separator, hence the byte more.
  const std::uint64_t available = source.remaining() + (format == PlyFormat::kAscii ? 1 : 0);
  if (element.count > available / bytes) {
    throw InputError(
        source.file(), fmt::format("line {}, element {}", element.line, quote(element.name)),
        fmt::format("found a count of {} at {} or more bytes each, but only {} bytes are left: the file is "
                    "truncated or the count wrong",
                    element.count, bytes, source.remaining()));
  }
}

void read_rows(PlySource& source, PlyFormat format, const PlyElement& element, const std::vector<int>& slots,
               std::vector<float>& row, const std::function<void(std::size_t)>& on_row, double* wide) {
  if (element.properties.empty()) return;
  check_fits(source, format, element);
  Reader reader{source, format, element, slots, row, on_row, wide};
  if (format == PlyFormat::kAscii || has_lists(element)) reader.general_rows();
  else reader.fixed_rows();
}

std::uint64_t rest_of_file(PlySource& source, const PlyHeader& header) {
  if (header.format == PlyFormat::kAscii && !source.next_line()) return 0;
  return source.remaining();
}

}  // namespace pipegs
