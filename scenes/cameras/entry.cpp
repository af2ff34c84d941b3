// SPDX-License-Identifier: Apache-2.0
// entry: see entry.hpp.
//
// Idea    The rotation is brought to the nearest orthonormal matrix by Newton's iteration R <- (R + R^-T) / 2, which
//         favours no axis (Gram-Schmidt would put the whole error on the last one).
#include "scenes/cameras/entry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scenes/input_error.hpp"

namespace pipegs {
namespace {

using Json = nlohmann::json;
constexpr double kOrthonormalTolerance = 1e-4;

glm::dmat3 nearest_rotation(glm::dmat3 m) {
  for (int i = 0; i < 6; ++i) m = (m + glm::transpose(glm::inverse(m))) * 0.5;
  return m;
}

}  // namespace

void CameraEntry::fail(const std::string& field, const std::string& what) const {
  throw InputError(file, fmt::format("{}, {}", where, field), what);
}

void CameraEntry::must_be_object() const {
  if (!json.is_object()) fail("entry", fmt::format("found {}, expected an object", quote(json_text(json))));
}

const Json* CameraEntry::find(const std::string& field) const {
  if (const auto found = json.find(field); found != json.end()) return &*found;
  if (shared == nullptr) return nullptr;
  const auto found = shared->find(field);
  return found == shared->end() ? nullptr : &*found;
}

const Json& CameraEntry::at(const std::string& field) const {
  const Json* found = find(field);
  if (found == nullptr) fail(field, "missing, expected a value");
  return *found;
}

double CameraEntry::number(const std::string& field, const RealRange& range) const {
  try {
    return json_real(at(field), range);
  } catch (const NumberError& error) { fail(field, error.what()); }
}

double CameraEntry::number_or(const std::string& field, double otherwise, const RealRange& range) const {
  return find(field) == nullptr ? otherwise : number(field, range);
}

int CameraEntry::integer(const std::string& field, int lowest, int highest) const {
  try {
    return json_integer(at(field), lowest, highest);
  } catch (const NumberError& error) { fail(field, error.what()); }
}

std::string CameraEntry::text_or(const std::string& field, const std::string& otherwise) const {
  const Json* found = find(field);
  if (found == nullptr) return otherwise;
  if (!found->is_string()) fail(field, fmt::format("found {}, expected a string", quote(json_text(*found))));
  return found->get<std::string>();
}

glm::dvec3 CameraEntry::triple(const std::string& field) const { return triple(at(field), field); }

glm::dvec3 CameraEntry::triple(const Json& value, const std::string& field) const {
  if (!value.is_array() || value.size() != 3)
    fail(field, fmt::format("found {}, expected 3 numbers", quote(json_text(value))));
  glm::dvec3 numbers;
  for (int i = 0; i < 3; ++i) {
    try {
      numbers[i] = json_real(value[static_cast<std::size_t>(i)]);
    } catch (const NumberError& error) { fail(field, error.what()); }
  }
  return numbers;
}

glm::dmat3 checked_rotation(const CameraEntry& entry, const std::string& field, const glm::dmat3& m) {
  double worst = 0;
  for (int r = 0; r < 3; ++r) {
    for (int s = 0; s < 3; ++s) {
      const double off = std::abs(glm::dot(m[r], m[s]) - (r == s ? 1 : 0));
      worst = off > worst || std::isnan(off) ? off : worst;
      if (std::isnan(worst)) break;
    }
  }
  if (!(worst <= kOrthonormalTolerance))
    entry.fail(field, fmt::format("rows are orthonormal to {:.3g}, expected {:g}", worst, kOrthonormalTolerance));
  if (!(glm::determinant(m) > 0)) entry.fail(field, "determinant is -1 (a mirrored frame), expected +1");
  return nearest_rotation(m);
}

void take_size(const CameraEntry& entry, const CameraReading& reading, Camera& camera) {
  if (reading.width == 0) entry.fail("size", "the file has none, expected --size WxH");
  camera.width = reading.width;
  camera.height = reading.height;
}

}  // namespace pipegs
