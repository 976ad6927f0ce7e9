// SHA-256 (FIPS 180-4), for the hashes of inputs and part in the report.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/mesh/tri_mesh.h"

namespace proveout {

class Sha256 {
 public:
  Sha256();
  Sha256(Sha256&&) noexcept;
  ~Sha256();
  void update(const void* data, std::size_t size);
  /// 64 lower-case hex digits. Ends the computation: call once.
  std::string finish();

 private:
  struct State;  ///< the library's
  std::unique_ptr<State> state_;
};

std::string sha256Hex(std::string_view bytes);
/// Hash of a regular file's bytes.
Result<std::string> sha256OfFile(const std::string& path);
/// Hash of a mesh: counts, positions and triangles as little-endian 32-bit words. Provenance is not part of
/// it.
std::string sha256OfMesh(const TriMesh& mesh);

}  // namespace proveout
