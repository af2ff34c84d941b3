// SPDX-License-Identifier: Apache-2.0
// scene_fuzz: any bytes as a scene, whose content says the format: a scene that holds together, or an InputError.
//
// Idea    What stands behind kBeside lies beside the file, under every name that it asks for. The payload of an .spz
//         may come as it is: it is packed here, since a fuzzer does not find a gzip whose checksum is right. JSON may
//         be large (repeated.hpp).
#include <cstdlib>

#include "scenes/formats/read_scene.hpp"
#include "scenes/input_error.hpp"
#include "verif/formats/packed_bytes.hpp"
#include "verif/fuzz/keep.hpp"
#include "verif/fuzz/repeated.hpp"

namespace {

constexpr std::string_view kBeside = "\n[beside]\n", kPayload = "NGSP";
constexpr std::size_t kVersion = 4;
constexpr int kGzip = 31, kStored = 0;  // of zlib: what is stored is as long as before, so no limit refuses it

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace pipegs;
  const std::string_view all(reinterpret_cast<const char*>(data), size);
  const std::size_t split = all.find(kBeside);
  const std::string whole = repeated(all.substr(0, split));
  const std::string_view main = whole;
  const std::string other(split == std::string_view::npos ? std::string_view{} : all.substr(split + kBeside.size()));
  const InputFile::Beside beside = [&](const std::string& name) { return InputFile(name, other, beside); };
  const bool payload =
      main.starts_with(kPayload) && main.size() > kVersion && (main[kVersion] == 2 || main[kVersion] == 3);
  try {
    SceneFormat format;
    const std::string file = payload ? deflated(std::string(main), kGzip, kStored) : std::string(main);
    const Scene scene = read_scene(InputFile("fuzz", file, beside), {}, format);
    check_consistent(scene);
    if (format.name.empty() || scene.gaussians.size() > 100 * (size + whole.size()) + (std::size_t{1} << 16))
      std::abort();
    Kept<18> kept;  // two Gaussians, drawn or not
    for (std::size_t i = 0; i < scene.gaussians.size(); ++i) {
      ActivatedGaussian activated;
      kept.add(activate(scene, i, activated) == Cull::kNone ? "drawn" : "not drawn");
    }
  } catch (const InputError& error) { refused(error); }
  return 0;
}
