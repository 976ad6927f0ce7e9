#include "core/nc/services/stroke_font.h"

#include <array>
#include <cstddef>

namespace proveout {
namespace {

/// Points on a grid 4 wide and 6 high, two digits each; a blank lifts the tool.
struct Glyph {
  char letter;
  std::string_view strokes;
};
constexpr auto kGlyphs = std::to_array<Glyph>({
    {'A', "002640 1333"},
    {'B', "00063645443303 3342413000"},
    {'C', "4536160501103041"},
    {'D', "00062644422000"},
    {'E', "46060040 0333"},
    {'F', "460600 0333"},
    {'G', "45361605011030414323"},
    {'H', "0006 4640 0343"},
    {'I', "1030 1636 2620"},
    {'J', "3631201001"},
    {'K', "0006 4602 1340"},
    {'L', "060040"},
    {'M', "0006234640"},
    {'N', "00064046"},
    {'O', "160501103041453616"},
    {'P', "00063645443303"},
    {'Q', "160501103041453616 2240"},
    {'R', "00063645443303 2340"},
    {'S', "453616050413334241301001"},
    {'T', "0646 2620"},
    {'U', "060110304146"},
    {'V', "062046"},
    {'W', "0610243046"},
    {'X', "0046 0640"},
    {'Y', "062346 2320"},
    {'Z', "06460040"},
    {'0', "160501103041453616 0145"},
    {'1', "152620 1030"},
    {'2', "05163645440040"},
    {'3', "05163645443313 334241301001"},
    {'4', "30360242"},
    {'5', "460604344341301001"},
    {'6', "453616050110304142331302"},
    {'7', "064610"},
    {'8', "13040516364544331302011030414233"},
    {'9', "011030414536160504133344"},
    {'-', "1333"},
    {'+', "0343 2521"},
    {'.', "2021"},
    {',', "2110"},
    {':', "2021 2425"},
    {';', "2110 2425"},
    {'/', "0046"},
    {'=', "0242 0444"},
    {'*', "1135 1531 0343"},
    {'#', "1016 3036 0242 0444"},
    {'!', "2622 2120"},
    {'?', "05163645442322 2120"},
    {'\'', "2624"},
    {'"', "1614 3634"},
    {'<', "450341"},
    {'>', "054301"},
    {'_', "0040"},
    {'%', "0046 051615 314130"},
    {'$', "453616050413334241301001 2620"},
    {'[', "36161030"},
    {']', "16363010"},
});
constexpr double kGrid = 6.0;         ///< steps of the grid in the height of a capital
constexpr double kAdvance = 6.0;      ///< from letter to letter
constexpr double kSmall = 2.0 / 3.0;  ///< height of small letters, which are small capitals

const Glyph* glyphOf(char letter) {
  for (const Glyph& g : kGlyphs) {
    if (g.letter == letter) return &g;
  }
  return nullptr;
}

}  // namespace

std::vector<Stroke> strokesOf(std::string_view text, char* unknown) {
  std::vector<Stroke> all;
  double at = 0.0;
  if (unknown != nullptr) *unknown = '\0';
  for (const char c : text) {
    const bool small = c >= 'a' && c <= 'z';
    const double scale = (small ? kSmall : 1.0) / kGrid;
    const Glyph* glyph = glyphOf(small ? static_cast<char>(c - 'a' + 'A') : c);
    if (glyph == nullptr && c != ' ' && unknown != nullptr && *unknown == '\0') *unknown = c;
    Stroke stroke;
    const auto lift = [&] {
      if (stroke.size() > 1) all.push_back(stroke);
      stroke.clear();
    };
    const std::string_view points = glyph != nullptr ? glyph->strokes : std::string_view();
    for (std::size_t i = 0; i + 1 < points.size();) {
      if (points[i] == ' ') {
        lift();
        ++i;
        continue;
      }
      stroke.push_back(Vec2(at + scale * (points[i] - '0'), scale * (points[i + 1] - '0')));
      i += 2;
    }
    lift();
    at += kAdvance * scale;
  }
  return all;
}

}  // namespace proveout
