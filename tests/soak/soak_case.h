// A random whole job of the soak: its files by name, made from a seed. Nothing here knows the engine.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace proveout::soak {

/// The same numbers on every machine: std distributions differ between libraries.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) { state_ = next() ^ 0x632BE59BD9B4E019ull; }
  /// In [0, 1).
  double unit() { return static_cast<double>(next() >> 11) * 0x1p-53; }
  double number(double low, double high) { return low + (high - low) * unit(); }
  int whole(int low, int high) { return low + static_cast<int>(unit() * (high - low + 1)); }
  bool chance(double part) { return unit() < part; }

 private:
  std::uint64_t next() {  // SplitMix64
    std::uint64_t z = state_ += 0x9E3779B97F4A7C15ull;
    z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9ull;
    z = (z ^ z >> 27) * 0x94D049BB133111EBull;
    return z ^ z >> 31;
  }
  std::uint64_t state_;
};

enum class Kind {
  kMill,
  kSetups,
  kFixtures,
  kSavedStock,
  kMeshBlank,
  kThinBlank,
  kHelix,
  kLathe,
  kLatheSetups,
  kWire,
  kTaperedWire,
  kCrowded
};
inline constexpr int kKinds = 12;
const char* kindName(Kind kind);
/// From here on seeds make jobs of a wire, and between these two milled jobs whose faces meet below the size
/// of a cell; below they make the others.
inline constexpr std::uint64_t kFirstWireSeed = 4'000'000'000, kFirstCrowdedSeed = 3'000'000'000;
/// From here on, counted from kFirstCrowdedSeed, crowded jobs have all kinds of cutters, blanks and arcs.
inline constexpr int kFirstWideSeed = 100'000;
/// From here on they have spirals, conical helices and helices about X and Y as well.
inline constexpr int kFirstCurvedSeed = 200'000;

struct SoakCase {
  std::uint64_t seed = 0;
  Kind kind = Kind::kMill;
  /// "job.toml" and what it names. A saved stock is what the job "before.toml" leaves, as "before.vdb".
  std::map<std::string, std::string> files;
  /// The same job with programs that stay away from the blank: job file "idle.toml".
  bool turns = false;
  std::vector<int> stops;  ///< lines of the last program at which a run may stop, growing
  std::string last_setup;  ///< name of the last clamping; empty without setups

  bool cutsWithWire() const { return kind == Kind::kWire || kind == Kind::kTaperedWire; }
};

/// A program and the lines at which it may stop.
struct Program {
  std::string text;
  int lines = 0;
  std::vector<int> stops;
  void add(const std::string& line) {
    text += line + "\n";
    ++lines;
  }
};

/// The case of a seed.
SoakCase makeCase(std::uint64_t seed);

/// Parts of it: what is common to milled jobs, crowded ones, turned jobs, jobs of a wire.
void makeMilled(Random& random, SoakCase& out);
void makeCrowded(Random& random, SoakCase& out);
void makeTurned(Random& random, SoakCase& out);
void makeWire(Random& random, SoakCase& out);

/// The table of a milling tool of this diameter, mm.
std::string randomTool(Random& random, int number, double diameter);

}  // namespace proveout::soak
