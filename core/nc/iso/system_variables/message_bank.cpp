#include "core/nc/iso/system_variables/message_bank.h"

#include <fmt/core.h>

#include <cmath>

#include "core/nc/iso/context/output.h"
#include "core/nc/iso/context/sends.h"

namespace proveout::nc {
namespace {

enum MessageNumber : int { kAlarm = 3000, kStop = 3006, kMessage = 3106, kBox = 3107 };
constexpr int kMaxNumber = 999;
/// Boxes 100 to 199 ask for OK, 200 to 299 for yes or no.
constexpr int kFirstBox = 100, kFirstQuestion = 200, kLastBox = 299;
constexpr int kOk = 1, kYes = 2;

/// The code that the control shows: channel, number of the message, second number; or the number alone.
std::string shown(const IsoContext& c, int number) {
  return c.dialect.rules.channel_in_messages ? fmt::format("01{:04}00", number)
                                             : fmt::format("{:04}", number);
}

}  // namespace

void MessageBank::addTo(VariableStore& store) {
  store.addBank(kAlarm, kAlarm, *this);
  store.addBank(kStop, kStop, *this);
  store.addSymbol({"ALM", kAlarm});
  store.addSymbol({"MSGSTP", kStop});
  if (!boxes_) return;
  store.addBank(kMessage, kBox, *this);
  store.addSymbol({"MSG", kMessage});
  store.addSymbol({"MSGBOX", kBox});
}

VariableStatus MessageBank::read(int number, Value& out) {
  if (number != kBox) return VariableStatus::kUnknown;  // written only
  out = {static_cast<double>(answer_)};
  return VariableStatus::kDone;
}

/// The text between brackets; with values, `\n` breaks lines and #n[cd] is a value as DPRNT writes it.
bool MessageBank::textOf(std::string_view note, bool with_values, std::string& out) {
  const std::size_t open = note.find_first_not_of(" \t");
  if (open == std::string_view::npos || note[open] != '(') return true;
  const std::string_view text = note.substr(open + 1, note.find(')', open) - open - 1);
  for (std::size_t i = 0; i < text.size();) {
    if (with_values && text.substr(i, 2) == "\\n") {
      out += '\n';
      i += 2;
    } else if (with_values && text[i] == '#') {
      if (!printedVariable(c_, text, i, out)) return false;
    } else {
      out += text[i++];
    }
  }
  return true;
}

VariableStatus MessageBank::write(int variable, const Value& value) {
  const double whole = std::round(value.vacant ? 0.0 : value.number);
  if (!(whole >= 0.0 && whole <= kMaxNumber)) return VariableStatus::kLimit;
  const int number = static_cast<int>(whole);
  if (variable == kBox && (number < kFirstBox || number > kLastBox)) return VariableStatus::kLimit;
  std::string text;
  if (!textOf(c_.variables.note(), variable == kBox, text)) return VariableStatus::kReported;
  switch (variable) {
    case kAlarm:
      return raise(number, text);
    case kStop:
      if (!c_.flushPipe()) return VariableStatus::kReported;
      return send("stop", number, shown(c_, c_.dialect.messages.stop + number), text, -1);
    case kMessage:
      return send("message", number, fmt::format("MSG{:03}", number), text, -1);
    default:
      break;
  }
  const auto told = c_.host.person.message_answers.find(number);
  answer_ = told != c_.host.person.message_answers.end() ? told->second
            : number < kFirstQuestion                    ? kOk
                                                         : kYes;
  if (!c_.flushPipe()) return VariableStatus::kReported;
  return send("box", number, shown(c_, c_.dialect.messages.box + number), text, answer_);
}

VariableStatus MessageBank::raise(int number, const std::string& text) {
  const int code = c_.dialect.messages.alarm + number;
  c_.flushPipe();  // the program is carried out up to the block before
  const std::string detail = text.empty() ? "alarm of the program" : text;
  c_.alarms.raise(
      code, c_.dialect.rules.channel_in_messages ? fmt::format("{} ({})", detail, shown(c_, code)) : detail);
  c_.summary.end = ProgramEnd::kAlarm;
  return VariableStatus::kReported;
}

VariableStatus MessageBank::send(const char* kind, int number, std::string code, const std::string& text,
                                 int answer) {
  event::Message told{kind, number, std::move(code), text, {}};
  if (answer >= 0) told.answer = answer;
  return sendEvent(c_, std::move(told)) ? VariableStatus::kDone : VariableStatus::kReported;
}

}  // namespace proveout::nc
