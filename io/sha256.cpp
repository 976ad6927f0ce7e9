// The rounds are those of GNU Nettle, which uses the processor's SHA instructions where it has them; it needs
// no start-up work, and is small to load.
#include "io/sha256.h"

#include <nettle/sha2.h>

#include <array>
#include <bit>
#include <cstdint>
#include <fstream>
#include <vector>

#include "io/atomic_file.h"

namespace proveout {

namespace {

/// Adds `count` 32-bit words in little-endian order, so that the hash is the same on any machine.
void addWords(Sha256& hash, const void* words, std::size_t count) {
  if constexpr (std::endian::native == std::endian::little) {
    hash.update(words, 4 * count);
  } else {
    const auto* p = static_cast<const std::uint8_t*>(words);
    for (std::size_t i = 0; i < count; ++i, p += 4) {
      const std::uint8_t turned[4] = {p[3], p[2], p[1], p[0]};
      hash.update(turned, sizeof turned);
    }
  }
}

}  // namespace

struct Sha256::State {
  sha256_ctx context;
};

Sha256::Sha256() : state_(std::make_unique<State>()) { sha256_init(&state_->context); }
Sha256::Sha256(Sha256&&) noexcept = default;
Sha256::~Sha256() = default;

void Sha256::update(const void* data, std::size_t size) {
  sha256_update(&state_->context, size, static_cast<const std::uint8_t*>(data));
}

std::string Sha256::finish() {
  std::array<std::uint8_t, SHA256_DIGEST_SIZE> digest;
  sha256_digest(&state_->context, digest.size(), digest.data());
  std::string hex;
  for (const std::uint8_t byte : digest) {
    hex += "0123456789abcdef"[byte >> 4];
    hex += "0123456789abcdef"[byte & 15];
  }
  return hex;
}

std::string sha256Hex(std::string_view bytes) {
  Sha256 hash;
  hash.update(bytes.data(), bytes.size());
  return hash.finish();
}

Result<std::string> sha256OfFile(const std::string& path) {
  const Status readable = checkRegularFile(path);
  if (!readable) return readable.error();
  std::ifstream in(path, std::ios::binary);
  if (!in) return inputError(path + ": cannot be opened for reading");
  Sha256 hash;
  std::vector<char> buffer(1u << 18);
  while (in.read(buffer.data(), static_cast<std::streamsize>(buffer.size())), in.gcount() > 0) {
    hash.update(buffer.data(), static_cast<std::size_t>(in.gcount()));
  }
  if (in.bad()) return inputError(path + ": reading failed");
  return hash.finish();
}

std::string sha256OfMesh(const TriMesh& mesh) {
  static_assert(sizeof(mesh.positions[0]) == 12 && sizeof(mesh.triangles[0]) == 12);
  Sha256 hash;
  for (const std::uint64_t count : {mesh.positions.size(), mesh.triangles.size()}) {
    const std::uint32_t halves[2] = {static_cast<std::uint32_t>(count),
                                     static_cast<std::uint32_t>(count >> 32)};
    addWords(hash, halves, 2);
  }
  addWords(hash, mesh.positions.data(), 3 * mesh.positions.size());
  addWords(hash, mesh.triangles.data(), 3 * mesh.triangles.size());
  return hash.finish();
}

}  // namespace proveout
