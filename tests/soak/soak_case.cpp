#include "tests/soak/soak_case.h"

namespace proveout::soak {

const char* kindName(Kind kind) {
  constexpr const char* kNames[kKinds] = {"mill",         "setups",     "fixtures",     "saved stock",
                                          "mesh blank",   "thin blank", "helix",        "lathe",
                                          "lathe setups", "wire",       "tapered wire", "crowded"};
  return kNames[static_cast<int>(kind)];
}

SoakCase makeCase(std::uint64_t seed) {
  SoakCase out;
  out.seed = seed;
  Random random(seed);
  if (seed >= kFirstWireSeed) {
    out.kind = random.chance(0.25) ? Kind::kTaperedWire : Kind::kWire;
    makeWire(random, out);
    return out;
  }
  if (seed >= kFirstCrowdedSeed) {
    out.kind = Kind::kCrowded;
    makeCrowded(random, out);
    return out;
  }
  // Thin blanks and several clampings are where faults were: they come twice as often.
  constexpr Kind kOrder[] = {Kind::kMill,       Kind::kThinBlank, Kind::kSetups,    Kind::kFixtures,
                             Kind::kSavedStock, Kind::kMeshBlank, Kind::kThinBlank, Kind::kSetups,
                             Kind::kHelix,      Kind::kLathe,     Kind::kLathe,     Kind::kLatheSetups};
  out.kind = kOrder[random.whole(0, static_cast<int>(std::size(kOrder)) - 1)];
  out.turns = out.kind == Kind::kLathe || out.kind == Kind::kLatheSetups;
  if (out.turns) {
    makeTurned(random, out);
  } else {
    makeMilled(random, out);
  }
  return out;
}

}  // namespace proveout::soak
