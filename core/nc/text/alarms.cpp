#include "core/nc/text/alarms.h"

namespace proveout::nc {

std::string withSubject(std::string_view text, std::string_view subject) {
  const std::size_t mark = text.find("{}");
  if (mark == std::string_view::npos) return std::string(text);
  std::string out(text.substr(0, mark));
  out += subject;
  std::string_view rest = text.substr(mark + 2);
  if (subject.empty()) {
    if (!out.empty() && out.back() == ' ') out.pop_back();
    if (out.empty() && !rest.empty() && rest.front() == ' ') rest.remove_prefix(1);
    if (!out.empty() && out.back() == ':') out.pop_back();
  }
  return out + std::string(rest);
}

std::string withDetail(std::string what, std::string_view detail) {
  if (detail.empty()) return what;
  what += ": ";
  what += detail;
  return what;
}

AlarmTable::AlarmTable(std::string_view control, std::initializer_list<Row> rows)
    : control_(control), rows_(kSharedAlarms), codes_(kSharedAlarms) {
  for (const Row& row : rows) {
    const auto at = static_cast<std::size_t>(row.alarm);
    rows_[at] = row;
    codes_[at] = row.number != 0 ? code(row.number) : control_ + "-" + std::string(row.name);
  }
}

std::string AlarmTable::code(int number) const { return control_ + "-" + std::to_string(number); }

std::string AlarmTable::code(const DiagnosticName& name) const {
  if (name.alarm() != SharedAlarm::kCount) return code(name.alarm());
  return control_ + "-" + std::string(name.name());
}

std::string AlarmTable::message(SharedAlarm alarm, std::string_view subject, std::string_view detail) const {
  return withDetail(withSubject(rows_[static_cast<std::size_t>(alarm)].text, subject), detail);
}

}  // namespace proveout::nc
