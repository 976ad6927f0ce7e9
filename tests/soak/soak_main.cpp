// Random whole jobs for as long as is asked: soak [--minutes M] [--seed FIRST] [--count N] [--wire|--crowded]
// [--print]
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <string>

#include "tests/soak/laws.h"

namespace {

using Clock = std::chrono::steady_clock;

struct Arguments {
  double minutes = 5.0;
  std::uint64_t first = 1, count = ~0ull;
  std::uint64_t kind =
      0;               ///< first seed of the jobs of a wire, or of crowded ones: `first` counts from there
  bool print = false;  ///< the files of the first case, and nothing else
};

bool parse(int argc, char** argv, Arguments& out) {
  for (int i = 1; i < argc; ++i) {
    const std::string name = argv[i];
    if (name == "--print") {
      out.print = true;
      continue;
    }
    if (name == "--wire" || name == "--crowded") {
      out.kind = name == "--wire" ? proveout::soak::kFirstWireSeed : proveout::soak::kFirstCrowdedSeed;
      continue;
    }
    if (i + 1 >= argc) return false;
    const char* value = argv[++i];
    if (name == "--minutes") {
      out.minutes = std::strtod(value, nullptr);
    } else if (name == "--seed") {
      out.first = std::strtoull(value, nullptr, 10);
    } else if (name == "--count") {
      out.count = std::strtoull(value, nullptr, 10);
    } else {
      return false;
    }
  }
  if (out.first < out.kind) out.first += out.kind;
  return out.minutes > 0.0;
}

void printCase(std::uint64_t seed) {
  for (const auto& [name, text] : proveout::soak::makeCase(seed).files)
    std::printf("=== %s\n%s", name.c_str(), text.c_str());
}

}  // namespace

int main(int argc, char** argv) {
  Arguments arguments;
  if (!parse(argc, argv, arguments)) {
    std::fprintf(stderr,
                 "usage: soak [--minutes M] [--seed FIRST] [--count N] [--wire|--crowded] [--print]\n");
    return 2;
  }
  if (arguments.print) {
    printCase(arguments.first);
    return 0;
  }
  const Clock::time_point end = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                                   std::chrono::duration<double>(60.0 * arguments.minutes));
  std::uint64_t runs = 0, refused = 0, bad = 0;
  std::map<std::string, std::uint64_t> reasons;
  for (std::uint64_t seed = arguments.first; Clock::now() < end && runs < arguments.count; ++seed, ++runs) {
    const Clock::time_point start = Clock::now();
    const proveout::soak::Judged judged = proveout::soak::judge(seed);
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    if (!judged.ran) {
      ++refused;
      ++reasons[judged.why.substr(0, 60)];
    }
    if (!judged.broken.empty()) ++bad;
    for (const std::string& law : judged.broken)
      std::printf("seed %llu (%s): %s\n", static_cast<unsigned long long>(seed),
                  proveout::soak::kindName(proveout::soak::makeCase(seed).kind), law.c_str());
    if (seconds > 5.0) std::printf("seed %llu took %.1f s\n", static_cast<unsigned long long>(seed), seconds);
    std::fflush(stdout);
  }
  for (const auto& [why, times] : reasons)
    std::printf("%6llu refused: %s\n", static_cast<unsigned long long>(times), why.c_str());
  std::printf("%llu jobs from seed %llu, %llu refused, %llu break a law\n",
              static_cast<unsigned long long>(runs), static_cast<unsigned long long>(arguments.first),
              static_cast<unsigned long long>(refused), static_cast<unsigned long long>(bad));
  return bad == 0 ? 0 : 1;
}
