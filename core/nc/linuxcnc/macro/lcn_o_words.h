// The O-words of a text: where subs, branches and loops begin and end.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/nc/linuxcnc/text/lcn_line.h"

namespace proveout::nc {

enum class LcnKeyword : std::uint8_t {
  kLabel,  ///< nothing behind the label: called by M98
  kSub,
  kEndSub,
  kReturn,
  kCall,
  kIf,
  kElseIf,
  kElse,
  kEndIf,
  kWhile,
  kEndWhile,
  kDo,
  kRepeat,
  kEndRepeat,
  kBreak,
  kContinue,
  kUnknown
};
inline constexpr const char* kUnknownLcnCommand = "Unknown control command in o word";
std::string_view lcnKeywordName(LcnKeyword keyword);  ///< "endsub"

/// An O-word line, taken apart as far as no values are needed.
struct LcnOWord {
  LcnKeyword keyword = LcnKeyword::kUnknown;
  std::string_view label;    ///< "100", "<name>", "#1", "[#1+1]", small letters
  std::size_t behind = 0;    ///< index behind the keyword
  std::size_t label_at = 0;  ///< index of the label
  bool computed = false;     ///< the label has a value
};
/// `pos` is behind the o of `text`. False: there is no label.
bool takeLcnOWord(std::string_view text, std::size_t pos, LcnOWord& out);
/// "100" for "0100": labels that mean the same are the same.
std::string lcnLabel(std::string_view label);

class LcnOWords {
 public:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  struct Statement {
    std::size_t line = 0;  ///< index
    LcnKeyword keyword = LcnKeyword::kLabel;
    std::string label;
    std::uint32_t scope = 0;  ///< labels count inside of one: that of a sub, or 0, outside of all
    /// if, elseif, else: the next branch; sub, while, repeat, do: their ends, and these: their heads. kNone:
    /// there is none.
    std::size_t partner = kNone;
    std::size_t head = kNone;  ///< of branches, ends, break and continue: the statement that opened
    bool closes_do = false;    ///< while: it ends a do
    /// A head whose label has one in the same scope already, a sub of a name that the text has, or one inside
    /// another sub: index of the other statement.
    std::size_t clash = kNone;
  };
  explicit LcnOWords(const std::vector<std::string_view>& lines);

  /// A line that cannot be read even where the control passes over it on its way to a label.
  struct Unreadable {
    std::size_t line = 0;  ///< index
    const char* name = nullptr;
    std::string message;
  };
  /// The first one from line `from` up to `to`; null: there is none.
  const Unreadable* unreadable(std::size_t from, std::size_t to) const;

  /// The statement on a line, or kNone.
  std::size_t on(std::size_t line) const;
  const Statement& at(std::size_t index) const { return statements_[index]; }
  /// The sub of that label, or the bare label; kNone: there is none.
  std::size_t sub(const std::string& label) const { return find(subs_, label); }
  std::size_t label(const std::string& label) const { return find(labels_, label); }

 private:
  using ByLabel = std::map<std::string, std::size_t, std::less<>>;
  static std::size_t find(const ByLabel& labels, const std::string& label);
  void take(std::size_t line, const LcnOWord& word);
  void pair();
  void openScope(std::size_t k);
  void closeSub(std::size_t k);
  void openHead(std::size_t k);
  void pairBranch(std::size_t k);
  void pairLoop(std::size_t k);

  std::vector<Statement> statements_;   ///< by line
  std::vector<Unreadable> unreadable_;  ///< by line
  ByLabel subs_, labels_;
  // While the text is read.
  std::uint32_t scope_ = 0, scopes_ = 0;
  std::size_t sub_ = kNone;  ///< that is open
  ByLabel heads_, outside_;  ///< what opened in the scope; the same outside of the sub
};

}  // namespace proveout::nc
