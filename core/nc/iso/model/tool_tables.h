// Tool management of the nct control: which tools there are, where they are, how long they live (manual 12.3
// to 12.5).
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>

namespace proveout::nc {

/// Life of a tool. Unmanaged tools have no life.
enum class ToolStatus : std::uint8_t { kUnmanaged, kNew, kUsed, kExpired, kBroken };

inline constexpr int kToolUserValues = 20;

/// A row of the tool management table.
struct ToolRow {
  /// Info bits.
  static constexpr unsigned kValid = 1, kByTime = 2, kLarge = 4, kLocked = 8, kSearchable = 16;

  int type = 0;  ///< T number that calls it; 0: no tool
  unsigned info = 0;
  int shape = 0;
  ToolStatus status = ToolStatus::kUnmanaged;
  double counter = 0.0, limit = 0.0, warning = 0.0;  ///< uses, or seconds; limit 0: none
  int length_row = 0, radius_row = 0;                ///< rows of the offset table, H and D
  int geometry_row = 0, wear_row = 0;                ///< of turning channels
  double speed = 0.0;                                ///< S, rpm
  double feed = 0.0;                                 ///< F, as a program would write it
  unsigned user_bits = 0;
  std::array<double, kToolUserValues> user{};

  bool has(unsigned bit) const { return (info & bit) != 0; }
};

/// A row of the shape table: room in half pockets to each side.
struct ToolShape {
  int left = 0, right = 0, up = 0, down = 0;
  bool round = false;
};

/// Where G10 L75 P1 and P2 are.
struct ToolInput {
  int row = 0;          ///< that blocks fill; 0: none named yet
  bool clears = false;  ///< a row named starts empty
};

/// Where a tool stands: magazines 1 to 4 have pockets; 10, 20, ... are spindles, 11, 21, ... wait beside
/// them.
struct ToolPlace {
  int magazine = 0, pocket = 0;
  auto operator<=>(const ToolPlace&) const = default;
};

/// All tables are common to the channels of a control. Rows count from 1.
class ToolTables {
 public:
  /// Without any row the control has no tool management: T is the tool.
  bool managed() const { return !rows_.empty(); }

  const ToolRow* row(int number) const;
  ToolRow* row(int number);
  ToolRow& addRow(int number) { return rows_[number] = ToolRow{}; }
  void removeRow(int number);

  /// The row of a tool of that type that may be used: of those with life left the one that has used most of
  /// it, then the lower number (manual 12.3.1). Nothing: there is none.
  std::optional<int> select(int type) const;

  /// Row 0 empties the place.
  void place(const ToolPlace& at, int row);
  /// Row at the place, 0: empty.
  int at(const ToolPlace& place) const;

  /// Counts `amount` uses or seconds of a row's life. True: its warning has come up with it.
  bool use(int row, double amount);

  void setShape(int number, const ToolShape& shape) { shapes_[number] = shape; }
  const ToolShape* shape(int number) const;

 private:
  std::map<int, ToolRow> rows_;
  std::map<ToolPlace, int> places_;
  std::map<int, ToolShape> shapes_;
};

}  // namespace proveout::nc
