// SPDX-License-Identifier: Apache-2.0
// accuracy_json.hpp: a measured point as JSON, there and back.
//
// Rule    What JSON has no number for is null: the PSNR of equal images, an SSIM of images too small for one.
// Errors  NumberError or nlohmann::json::exception: the JSON is not what to_json writes.
#pragma once

#include <nlohmann/json.hpp>

#include "scenes/text/number.hpp"
#include "sim/studies/accuracy/view.hpp"

namespace pipegs {

nlohmann::ordered_json to_json(const Accuracy& accuracy);
Accuracy accuracy_from_json(const nlohmann::ordered_json& json);

}  // namespace pipegs
