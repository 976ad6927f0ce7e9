#include "core/nc/linuxcnc/text/lcn_groups.h"

#include <algorithm>
#include <array>

namespace proveout::nc {
namespace {

struct LcnGroup {
  int first, last;  ///< codes, both counted
  int group;
};
constexpr auto kLcnGroupsG = std::to_array<LcnGroup>({
    {0, 30, 1},    {40, 40, 0},   {50, 53, 1},    {70, 80, 15},   {100, 100, 0},  {170, 191, 2},
    {200, 210, 6}, {280, 301, 0}, {330, 331, 1},  {382, 385, 1},  {400, 421, 7},  {430, 432, 8},
    {490, 490, 8}, {520, 530, 0}, {540, 593, 12}, {610, 611, 13}, {640, 640, 13}, {700, 722, 1},
    {730, 790, 1}, {800, 800, 9}, {810, 890, 1},  {900, 900, 3},  {901, 901, 4},  {910, 910, 3},
    {911, 911, 4}, {920, 920, 0}, {921, 923, 16}, {930, 950, 5},  {960, 970, 14}, {980, 990, 10},
});
constexpr auto kLcnGroupsM = std::to_array<LcnGroup>({
    {0, 2, 4},
    {3, 5, 7},
    {6, 6, 6},
    {7, 9, 8},
    {19, 19, 7},
    {30, 30, 4},
    {48, 53, 9},
    {60, 60, 4},
    {61, 61, 6},
    {62, 68, 5},
    {70, 73, 7},
    {98, 99, 12},
    {100, 199, 10},
});

template <class Rows>
int lcnGroup(const Rows& rows, int code) {
  const auto found = std::find_if(rows.begin(), rows.end(),
                                  [code](const LcnGroup& g) { return code >= g.first && code <= g.last; });
  return found == rows.end() ? -1 : found->group;
}

}  // namespace

int lcnGroupOfG(int code10) { return lcnGroup(kLcnGroupsG, code10); }
int lcnGroupOfM(int code) { return lcnGroup(kLcnGroupsM, code); }

}  // namespace proveout::nc
