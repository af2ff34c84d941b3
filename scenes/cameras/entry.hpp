// SPDX-License-Identifier: Apache-2.0
// entry: one camera of a JSON file: its fields, looked up and checked, with what the line of an error needs.
//
// Idea    A format with many frames says what they share once, above them: a field is taken from the frame, or else
//         from `shared`. Nothing is trusted: type and range of each field are checked where it is read.
// Rule    A rotation within 1e-4 of orthonormal is accepted and brought to the nearest orthonormal matrix in double;
//         what is further off, singular, scaled or mirrored is refused.
// Errors  InputError: "cameras.json: camera 0, fx: found '-50', expected a number above 0".
#pragma once

#include <glm/glm.hpp>
#include <nlohmann/json.hpp>
#include <string>

#include "scenes/camera.hpp"
#include "scenes/text/json.hpp"

namespace pipegs {

struct CameraEntry {
  const std::string& file;
  std::string where;  // "camera 3", "frame 3"
  const nlohmann::json& json;
  const nlohmann::json* shared = nullptr;

  [[noreturn]] void fail(const std::string& field, const std::string& what) const;
  void must_be_object() const;
  const nlohmann::json* find(const std::string& field) const;  // null without it
  const nlohmann::json& at(const std::string& field) const;
  double number(const std::string& field, const RealRange& range = kFinite) const;
  double number_or(const std::string& field, double otherwise, const RealRange& range = kFinite) const;
  int integer(const std::string& field, int lowest, int highest) const;
  std::string text_or(const std::string& field, const std::string& otherwise) const;
  glm::dvec3 triple(const std::string& field) const;
  glm::dvec3 triple(const nlohmann::json& value, const std::string& field) const;
};

// The nearest rotation to a matrix whose columns are the rows of camera-to-world, which is world_to_camera.
glm::dmat3 checked_rotation(const CameraEntry& entry, const std::string& field, const glm::dmat3& world_to_camera);

// Width and height of a view whose file has none.
void take_size(const CameraEntry& entry, const CameraReading& reading, Camera& camera);

}  // namespace pipegs
