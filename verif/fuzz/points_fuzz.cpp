// SPDX-License-Identifier: Apache-2.0
// points_fuzz: any bytes as a kept measurement: a point that comes back as it was written, or an error that load()
// knows.
#include <cstdlib>

#include "scenes/input_error.hpp"
#include "scenes/text/json.hpp"
#include "sim/studies/accuracy/accuracy_json.hpp"
#include "verif/fuzz/keep.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace pipegs;
  using Json = nlohmann::ordered_json;
  try {
    const Json json = parse_json<Json>("fuzz.json", {reinterpret_cast<const char*>(data), size});
    const Json written = to_json(accuracy_from_json(json.at("measured")));
    if (to_json(accuracy_from_json(parse_json<Json>("written.json", json_text(written)))) != written) std::abort();
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
