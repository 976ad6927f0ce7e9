// Random whole jobs for as long as is asked: soak [--minutes M] [--seed FIRST] [--count N | --jobs N]
// [--wire|--crowded] [--print], or soak --second with [--only LAW] [--keep FOLDER]
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <string>

#include "tests/soak/laws.h"
#include "tests/soak/second/plan.h"
#include "tests/soak/second/second_soak.h"

namespace {

using Clock = std::chrono::steady_clock;

struct Arguments {
  double minutes = 5.0;
  std::uint64_t first = 1, count = ~0ull;
  std::uint64_t kind =
      0;                ///< first seed of the jobs of a wire, or of crowded ones: `first` counts from there
  bool print = false;   ///< the files of the first case, and nothing else
  bool second = false;  ///< the other generator and its relations
  std::string only;     ///< one relation
  std::string keep;     ///< folder for the jobs that break one
};

/// Words without a value.
bool isSwitch(const std::string& name, Arguments& out) {
  if (name == "--print") {
    out.print = true;
  } else if (name == "--second") {
    out.second = true;
  } else if (name == "--wire" || name == "--crowded") {
    out.kind = name == "--wire" ? proveout::soak::kFirstWireSeed : proveout::soak::kFirstCrowdedSeed;
  } else {
    return false;
  }
  return true;
}

bool take(const std::string& name, const char* value, Arguments& out) {
  if (name == "--minutes") {
    out.minutes = std::strtod(value, nullptr);
  } else if (name == "--seed") {
    out.first = std::strtoull(value, nullptr, 10);
  } else if (name == "--count" || name == "--jobs") {
    out.count = std::strtoull(value, nullptr, 10);
  } else if (name == "--only") {
    out.only = value;
  } else if (name == "--keep") {
    out.keep = value;
  } else {
    return false;
  }
  return true;
}

bool parse(int argc, char** argv, Arguments& out) {
  for (int i = 1; i < argc; ++i) {
    if (isSwitch(argv[i], out)) continue;
    if (i + 1 >= argc || !take(argv[i], argv[i + 1], out)) return false;
    ++i;
  }
  if (out.second && out.kind != 0) return false;
  if (out.first < out.kind) out.first += out.kind;
  return out.minutes > 0.0;
}

void printCase(const Arguments& arguments) {
  const auto files = arguments.second
                         ? proveout::soak::second::filesOf(proveout::soak::second::makePlan(arguments.first))
                         : proveout::soak::makeCase(arguments.first).files;
  for (const auto& [name, text] : files) std::printf("=== %s\n%s", name.c_str(), text.c_str());
}

/// Calls `one` for seed after seed while there is time; tells of those that take long.
template <typename One>
std::uint64_t forSeeds(const Arguments& arguments, double long_s, const One& one) {
  const Clock::time_point end = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                                   std::chrono::duration<double>(60.0 * arguments.minutes));
  std::uint64_t runs = 0;
  for (std::uint64_t seed = arguments.first; Clock::now() < end && runs < arguments.count; ++seed, ++runs) {
    const Clock::time_point start = Clock::now();
    one(seed);
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    if (seconds > long_s)
      std::printf("seed %llu took %.1f s\n", static_cast<unsigned long long>(seed), seconds);
    std::fflush(stdout);
  }
  return runs;
}

int runSecond(const Arguments& arguments) {
  proveout::soak::second::Tally tally;
  forSeeds(arguments, 20.0, [&](std::uint64_t seed) {
    const auto verdict = proveout::soak::second::judgePlan(seed, arguments.only, arguments.keep);
    tally.add(verdict);
    for (const auto& broken : verdict.broken)
      std::printf("seed %llu (%s): %s: %s\n", static_cast<unsigned long long>(seed), broken.process.c_str(),
                  broken.relation.c_str(), broken.why.c_str());
  });
  std::printf("%s", tally.table().c_str());
  return tally.bad() == 0 ? 0 : 1;
}

int runFirst(const Arguments& arguments) {
  std::uint64_t refused = 0, bad = 0;
  std::map<std::string, std::uint64_t> reasons;
  const std::uint64_t runs = forSeeds(arguments, 5.0, [&](std::uint64_t seed) {
    const proveout::soak::Judged judged = proveout::soak::judge(seed);
    if (!judged.ran) {
      ++refused;
      ++reasons[judged.why.substr(0, 60)];
    }
    if (!judged.broken.empty()) ++bad;
    for (const std::string& law : judged.broken)
      std::printf("seed %llu (%s): %s\n", static_cast<unsigned long long>(seed),
                  proveout::soak::kindName(proveout::soak::makeCase(seed).kind), law.c_str());
  });
  for (const auto& [why, times] : reasons)
    std::printf("%6llu refused: %s\n", static_cast<unsigned long long>(times), why.c_str());
  std::printf("%llu jobs from seed %llu, %llu refused, %llu break a law\n",
              static_cast<unsigned long long>(runs), static_cast<unsigned long long>(arguments.first),
              static_cast<unsigned long long>(refused), static_cast<unsigned long long>(bad));
  return bad == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  Arguments arguments;
  if (!parse(argc, argv, arguments)) {
    std::fprintf(stderr,
                 "usage: soak [--minutes M] [--seed FIRST] [--jobs N] [--wire|--crowded] [--print]\n"
                 "       soak --second [--minutes M] [--seed FIRST] [--jobs N] [--only LAW] [--keep FOLDER] "
                 "[--print]\n");
    return 2;
  }
  if (arguments.print) {
    printCase(arguments);
    return 0;
  }
  return arguments.second ? runSecond(arguments) : runFirst(arguments);
}
