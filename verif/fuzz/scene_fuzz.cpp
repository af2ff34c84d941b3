// SPDX-License-Identifier: Apache-2.0
// scene_fuzz: any bytes as a scene, whose content says the format: a scene that holds together, or an InputError.
//
// Idea    What stands behind kBeside lies beside the file, under every name that it asks for. The payload of an .spz
//         may come as it is: it is packed here, since a fuzzer does not find a gzip whose checksum is right.
#include <zlib.h>

#include <cstdlib>

#include "scenes/formats/read_scene.hpp"
#include "scenes/input_error.hpp"
#include "verif/fuzz/keep.hpp"

namespace {

constexpr std::string_view kBeside = "\n[beside]\n", kPayload = "NGSP";
constexpr std::size_t kVersion = 4;

std::string gzip(std::string_view bytes) {
  z_stream stream{};
  deflateInit2(&stream, Z_NO_COMPRESSION, Z_DEFLATED, 31, 8, Z_DEFAULT_STRATEGY);
  std::string out(deflateBound(&stream, bytes.size()) + 32, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  deflate(&stream, Z_FINISH);
  out.resize(stream.total_out);
  deflateEnd(&stream);
  return out;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace pipegs;
  const std::string_view all(reinterpret_cast<const char*>(data), size);
  const std::size_t split = all.find(kBeside);
  const std::string_view main = all.substr(0, split);
  const std::string other(split == std::string_view::npos ? std::string_view{} : all.substr(split + kBeside.size()));
  const InputFile::Beside beside = [&](const std::string& name) { return InputFile(name, other, beside); };
  const bool payload =
      main.starts_with(kPayload) && main.size() > kVersion && (main[kVersion] == 2 || main[kVersion] == 3);
  try {
    SceneFormat format;
    const Scene scene = read_scene(InputFile("fuzz", payload ? gzip(main) : std::string(main), beside), {}, format);
    check_consistent(scene);
    if (format.name.empty() || scene.gaussians.size() > 100 * size + (std::size_t{1} << 16)) std::abort();
    Kept<8> kept;
    for (std::size_t i = 0; i < scene.gaussians.size(); ++i) {
      ActivatedGaussian activated;
      kept.add(cull_name(activate(scene, i, activated)));
    }
  } catch (const InputError&) { return 0; }
  return 0;
}
