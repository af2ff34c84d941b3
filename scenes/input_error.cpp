// input_error: composes the one-line messages of input_error.hpp.
//
// Idea    join, then replace whatever would break the line; long quotations are cut, because a
//         hostile header can hold a megabyte in one word.
#include "scenes/input_error.hpp"

namespace pipegs {
namespace {

constexpr std::size_t kLongestQuotation = 60;

std::string one_line(std::string text) {
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  }
  return text;
}

std::string compose(std::string_view file, std::string_view where, std::string_view what) {
  std::string text(file);
  text += ": ";
  if (!where.empty()) {
    text += where;
    text += ": ";
  }
  text += what;
  return one_line(std::move(text));
}

}  // namespace

InputError::InputError(std::string_view file, std::string_view where, std::string_view what)
    : std::runtime_error(compose(file, where, what)) {}

std::string quote(std::string_view text) {
  std::string out = "'";
  out += text.substr(0, kLongestQuotation);
  if (text.size() > kLongestQuotation) out += "...";
  out += "'";
  return one_line(std::move(out));
}

}  // namespace pipegs
