// SPDX-License-Identifier: Apache-2.0
// well_formed.hpp: is a text well-formed XML? Enough of it for the SVG that this project writes.
#pragma once

#include <cctype>
#include <set>
#include <string>
#include <vector>

namespace pipegs {

// Empty when the text is one well-formed element (after an optional declaration), else what is wrong and where.
inline std::string xml_fault(const std::string& text) {
  std::vector<std::string> open;
  size_t i = 0, roots = 0;
  const auto fault = [&](const std::string& what) { return what + " at byte " + std::to_string(i); };
  const auto name_at = [&](size_t& at) {
    const size_t from = at;
    while (at < text.size() && (std::isalnum(static_cast<unsigned char>(text[at])) || text[at] == ':' ||
                                text[at] == '-' || text[at] == '_'))
      ++at;
    return text.substr(from, at - from);
  };
  const auto entity = [&](size_t& at) {  // at '&'
    const size_t end = text.find(';', at);
    if (end == std::string::npos) return false;
    const std::string name = text.substr(at + 1, end - at - 1);
    at = end + 1;
    return name == "amp" || name == "lt" || name == "gt" || name == "quot" || name == "apos";
  };
  if (text.starts_with("<?xml ")) i = text.find("?>") + 2;
  while (i < text.size()) {
    if (text[i] == '&') {
      if (!entity(i)) return fault("an unknown entity");
      continue;
    }
    if (text[i] != '<') {
      if (open.empty() && !std::isspace(static_cast<unsigned char>(text[i]))) return fault("text outside the root");
      ++i;
      continue;
    }
    ++i;
    if (text[i] == '/') {
      ++i;
      const std::string name = name_at(i);
      if (open.empty() || open.back() != name) return fault("an end tag '" + name + "' that nothing opened");
      open.pop_back();
      if (text[i] != '>') return fault("an end tag that does not end");
      ++i;
      continue;
    }
    const std::string name = name_at(i);
    if (name.empty()) return fault("a tag without a name");
    if (open.empty() && ++roots > 1) return fault("a second root");
    std::set<std::string> attributes;
    for (;;) {
      while (i < text.size() && std::isspace(static_cast<unsigned char>(text[i]))) ++i;
      if (i >= text.size()) return fault("a tag that does not end");
      if (text[i] == '>' || text[i] == '/') break;
      const std::string attribute = name_at(i);
      if (attribute.empty()) return fault("an attribute without a name");
      if (!attributes.insert(attribute).second) return fault("attribute '" + attribute + "' twice");
      if (text[i] != '=' || text[i + 1] != '"') return fault("an attribute without a quoted value");
      for (i += 2; i < text.size() && text[i] != '"';) {
        if (text[i] == '<') return fault("'<' in an attribute");
        if (text[i] == '&' && !entity(i)) return fault("an unknown entity");
        else if (text[i] != '"') ++i;
      }
      if (i >= text.size()) return fault("a value that does not end");
      ++i;
    }
    if (text[i] == '/') {
      ++i;
      if (text[i] != '>') return fault("an empty tag that does not end");
    } else {
      open.push_back(name);
    }
    ++i;
  }
  if (!open.empty()) return "'" + open.back() + "' is not closed";
  return roots == 1 ? "" : "no root";
}

}  // namespace pipegs
