// Saved stocks whose bytes are forged below the level of grids: the input is a list of changes to the bytes
// of a good file, at the places where its fields and packed values stand, or the bytes of a whole file. The
// checksum is always right. Either it is refused with a reason, or what is taken is sound, as in fuzz_stock.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "tests/fuzz/stock_laws.h"

namespace {

using namespace proveout;
using namespace proveout::stocks;

constexpr std::size_t kTrailerBytes = 24;

/// A good file without its checksum, and where in it something stands: most of it is zeros of masks.
struct Base {
  std::string bytes;
  std::vector<std::size_t> places;
};

Base baseOf(std::string bytes) {
  bytes.resize(bytes.size() - kTrailerBytes);
  Base base{std::move(bytes), {}};
  std::size_t zeros = 8;
  for (std::size_t k = 0; k < base.bytes.size(); ++k) {
    if (base.bytes[k] == 0) {
      ++zeros;
      continue;
    }
    if (zeros >= 3) base.places.push_back(k);
    zeros = 0;
  }
  return base;
}

const std::vector<Base>& bases() {
  static const std::vector<Base> bases = [] {
    std::vector<Base> out;
    for (std::string& bytes : goodFiles()) out.push_back(baseOf(std::move(bytes)));
    return out;
  }();
  return bases;
}

/// Some place of the file: a little before or behind where something stands, or anywhere.
std::size_t placeIn(const Base& base, Bytes& input) {
  const auto number = input.take<std::uint16_t>();
  const auto step = input.take<std::int8_t>();
  if (step == -128) return (std::size_t{number} * 4) % base.bytes.size();
  const auto at = static_cast<std::ptrdiff_t>(base.places[number % base.places.size()]) + step;
  return static_cast<std::size_t>(
      std::clamp<std::ptrdiff_t>(at, 0, static_cast<std::ptrdiff_t>(base.bytes.size()) - 1));
}

template <typename Number>
void put(std::string& bytes, std::size_t at, Number number) {
  std::memcpy(bytes.data() + at, &number, std::min(sizeof number, bytes.size() - at));
}

void change(const Base& base, Bytes& input, std::string& bytes) {
  const auto what = input.take<std::uint8_t>();
  const std::size_t at = std::min(placeIn(base, input), bytes.size() - 1);
  switch (what % 8) {
    case 0:
      bytes[at] = static_cast<char>(bytes[at] ^ static_cast<char>(input.take<std::uint8_t>()));
      return;
    case 1:
      return put(bytes, at, input.take<std::uint8_t>());
    case 2:
      return put(bytes, at, input.take<std::uint32_t>());
    case 3:
      return put(bytes, at, input.take<std::uint64_t>());
    case 4:
      return put(bytes, at, std::int64_t{input.take<std::int16_t>()});
    case 5:
      bytes.insert(at, 1 + input.take<std::uint8_t>() % 32, static_cast<char>(input.take<std::uint8_t>()));
      return;
    case 6:
      bytes.erase(at, 1 + input.take<std::uint8_t>() % 32);
      return;
    default:
      bytes.resize(at + 1);
  }
}

std::string forge(Bytes& input) {
  const auto how = input.take<std::uint8_t>();
  if (how >= 224) return std::string(input.rest());
  const Base& base = bases()[how % bases().size()];
  std::string bytes = base.bytes;
  for (int k = 0; k < 16 && !input.empty() && !bytes.empty(); ++k) change(base, input, bytes);
  return bytes;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Bytes input({reinterpret_cast<const char*>(data), size});
  const bool cut_again = size % 8 == 0;
  const std::string bytes = forge(input);
  Result<Stock> stock = load(folder().write("stock.vdb", bytes + trailer(bytes)));
  if (stock) checkSound(*stock, cut_again);
  require(stock.ok() || !stock.error().message.empty(), "a refusal has a reason");
  require(stock.ok() || stock.error().kind != ErrorKind::kInternal, "a refusal is no bug");
  return 0;
}
