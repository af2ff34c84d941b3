// SPDX-License-Identifier: Apache-2.0
// points_fuzz: any bytes as a stored measurement: a point that comes back as it was written, or an error that load()
// knows.
#include <cstdlib>

#include "scenes/input_error.hpp"
#include "scenes/text/json.hpp"
#include "sim/studies/explore/figures.hpp"
#include "verif/fuzz/keep.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace pipegs;
  using Json = nlohmann::ordered_json;
  try {
    const Json json = parse_json<Json>("fuzz.json", {reinterpret_cast<const char*>(data), size});
    const auto again = [](const Json& point) {
      return to_json(figures_from_json(point, Measured::kErrors), Measured::kErrors);
    };
    const Json written = again(json.at("measured"));
    if (again(parse_json<Json>("written.json", json_text(written))) != written) std::abort();
    Kept<255> kept;
    for (const auto& [key, value] : json.at("measured").items()) {
      kept.add(key);
      kept.add(json_text(value));
    }
  } catch (const InputError&) { return 0; } catch (const NumberError&) {
    return 0;
  } catch (const Json::exception&) { return 0; }
  return 0;
}
