// SPDX-License-Identifier: Apache-2.0
// generate_builder: collects the Gaussians of the generated scene in the stored form.
//
// Idea    Whoever makes a thing says position, axes, sizes, opacity and colour; logarithm, logit,
//         quaternion and the rounding to a grid happen here only.
// Colour  color[0] is the constant, color[1..15] are in the order of f_rest; display colours minus 0.5. They are fitted
//         as training fits them: asked for from a ring of cameras around the scene, views from which the surface faces
//         the camera weighted more, solved by regularised least squares. Like those of a trained scene they are sharp
//         where cameras were and undefined elsewhere.
// Stats   surface() draws opacity and size from the mixture that training leaves behind: a solid
//         layer, a softer one, and many faint Gaussians that merely correct the colour.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <glm/glm.hpp>

#include "scenes/generate/generate_random.hpp"
#include "scenes/scene.hpp"

namespace pipegs::generate {

using ShColor = std::array<glm::dvec3, 16>;

// seen(v): display colour toward `v`, the unit direction from the point to a camera. A zero normal
// means visible from all sides.
ShColor fit_color(const glm::dvec3& point, const glm::dvec3& normal,
                  const std::function<glm::dvec3(const glm::dvec3&)>& seen);

// The same colour from everywhere.
ShColor plain_color(const glm::dvec3& color);

// Adds `amount` * dot(direction from camera, axis): what shines through leaves and haze.
void add_gradient(ShColor& color, const glm::dvec3& axis, const glm::dvec3& amount);

// Columns: tangent, bitangent, normal; right-handed and orthonormal.
glm::dmat3 frame_of(const glm::dvec3& normal, const glm::dvec3& tangent_hint);

class Builder {
 public:
  Builder(std::uint64_t seed, std::size_t count);

  void add(const glm::dvec3& mean, const glm::dmat3& axes, const glm::dvec3& scale, double opacity, ShColor color);
  // A flat splat on a surface; `size` is the distance to its neighbours, `stretch` its ratio of
  // tangent to bitangent, `solid` the probability of belonging to the solid layer.
  void surface(const glm::dvec3& mean, const glm::dmat3& axes, double size, double stretch, double solid,
               const ShColor& color);
  // A needle from a to b.
  void needle(const glm::dvec3& a, const glm::dvec3& b, double width, double opacity, const ShColor& color);

  std::size_t share(double fraction) const { return static_cast<std::size_t>(fraction * static_cast<double>(count_)); }
  std::size_t left() const { return count_ - scene_.gaussians.size(); }
  Scene take() { return std::move(scene_); }

  Random random;

 private:
  std::size_t count_;
  Scene scene_;
};

// Probability of a Gaussian at `point`: 1 where one of the generated cameras looks, little elsewhere,
// as training puts its Gaussians where photographs are.
double attention(const glm::dvec3& point);

// The parts of the scene; each adds at most `count` Gaussians.
void add_sky(Builder& builder, std::size_t count);
void add_clouds(Builder& builder, std::size_t count);
void add_mountains(Builder& builder, std::size_t count);
void add_ground(Builder& builder, std::size_t count);
void add_haze(Builder& builder, std::size_t count);
void add_pebbles(Builder& builder, std::size_t count);
void add_grass(Builder& builder, std::size_t count);
void add_trees(Builder& builder, std::size_t count);
void add_veil(Builder& builder, std::size_t count);
void add_flowers(Builder& builder, std::size_t count);
void add_balls(Builder& builder, std::size_t count);
void add_shell(Builder& builder, std::size_t count);
void add_spines(Builder& builder, std::size_t count);
void add_motes(Builder& builder, std::size_t count);

}  // namespace pipegs::generate
