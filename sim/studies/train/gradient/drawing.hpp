// SPDX-License-Identifier: Apache-2.0
// drawing: a picture of the Gaussians of a camera, and the way back from a loss of the picture to their fields.
//
// Paper   Eq. 1 and 2, in the order of Sec. 3.2 if there are layers.
// Idea    The truth (kExact of cpp_model/float/truth.hpp) with its cuts, so that what is trained is what the machine
//         draws. Gaussians are projected and their gradients taken back in double, once each. Pixels are float32 in
//         lanes of 16: a weight of a pixel is used once and summed, so its rounding averages out.
//         Scalar = double compiles the same code for the tests.
// Order   Ascending view depth, ties by index; with a grid first by layer, as the golden model with order = 0.
// Rule    Nothing depends on the number of threads: tiles share nothing, and what they add to a Gaussian is summed in
//         the order of the tiles. Cuts have no gradient: a Gaussian counts or does not, alpha at its cap, a colour at 0
//         and x/z beyond the guard band stand still. The parameters must live, unchanged, as long as the drawing.
#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <vector>

#include "scenes/camera.hpp"
#include "sim/layers/layer_grid.hpp"
#include "sim/layers/parameters.hpp"

namespace pipegs {

struct DrawOptions {
  const LayerGrid* layers = nullptr;  // null: exact order; must live as long as the drawing is made
  int sh_degree = 3;                  // cap below the parameters' own
  glm::vec3 background{0};
  double near_plane = 0.2;
  unsigned threads = 0;  // 0: as many as the machine has
};

// What INRIA's densification asks of a view, per Gaussian.
struct Seen {
  std::vector<float> mean_gradient;  // |d loss / d mean2d|, the picture 2 wide and 2 high; 0 where not seen
  std::vector<float> radius;         // pixels, three standard deviations; 0: not seen
};

template <class Scalar>
class BasicDrawing {
 public:
  using Color = glm::vec<3, Scalar>;

  // std::invalid_argument for parameters that contradict themselves, or a camera without pixels.
  BasicDrawing(const Parameters& parameters, const Camera& camera, const DrawOptions& options);
  ~BasicDrawing();
  BasicDrawing(BasicDrawing&&) noexcept;

  int width() const;
  int height() const;
  const std::vector<Color>& picture() const;  // row by row, over the background

  // Adds to `sum`, which has the shape of the parameters; `seen` (may be null) is overwritten.
  void backward(const std::vector<Color>& d_picture, Gradient& sum, Seen* seen) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

using Drawing = BasicDrawing<float>;
extern template class BasicDrawing<float>;
extern template class BasicDrawing<double>;

}  // namespace pipegs
