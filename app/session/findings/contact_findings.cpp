#include "app/session/findings/contact_findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "app/session/findings/blame.h"
#include "app/session/findings/standing_spindle.h"
#include "io/report_text.h"

namespace proveout {
namespace {

using report_text::figure;

/// Contacts of one mistake: so many motions at most lie between them, or so far apart are their places, mm.
constexpr MotionId kFewMotions = 4;
constexpr double kBeside = 3.0;

/// What a contact of a kind is found as, and what is said of it.
struct ContactTerms {
  FindingKind kind;
  std::string_view text;
  std::optional<Severity> severity = {};  ///< none: that of the kind
};

ContactTerms termsOf(ContactKind kind) {
  switch (kind) {
    case ContactKind::kRapid:
      break;
    case ContactKind::kShank:
      return {FindingKind::kShankContact, "the tool's shank runs into the stock"};
    case ContactKind::kHolder:
      return {FindingKind::kHolderContact, "the tool holder runs into the stock"};
    case ContactKind::kSpindleOff:
      return {FindingKind::kSpindleOff, "the tool cuts while the spindle stands still"};
    case ContactKind::kFixture:
      return {FindingKind::kFixtureContact, "the tool runs into a fixture"};
    case ContactKind::kInsertBack:
      return {
          FindingKind::kInsertContact,
          "a side of the insert that does not cut here, or what lies behind its edge, runs into the part"};
    case ContactKind::kAxis:
      return {FindingKind::kAxisCrossing, "the tool cuts beyond the spindle axis (a drill or mill: off it)"};
    case ContactKind::kPartedOff:
      return {FindingKind::kCutOffPiece,
              "the tool is to cut a piece that was cut off before and is not held any more"};
    case ContactKind::kWire:
      return {FindingKind::kFixtureContact, "the wire runs into a fixture"};
    case ContactKind::kByHand:
      return {FindingKind::kRapidContact,
              "the way leads through the stock: the operator has to cut the wire at the stop before it and "
              "thread it again behind it",
              Severity::kNote};
  }
  return {FindingKind::kRapidContact, "rapid motion cuts into the stock"};
}

std::string_view partName(ContactKind kind) {
  if (kind == ContactKind::kShank) return "the tool's shank";
  if (kind == ContactKind::kHolder) return "the tool holder";
  if (kind == ContactKind::kWire) return "the wire";
  return "the tool";
}

/// Contacts that belong together.
struct Group {
  Contact deepest;
  MotionId first = kNoMotion, last = kNoMotion;
  BlockRef call;  ///< of the cycle that moved, where there is one
  Vec3 latest = Vec3::Zero();
  std::size_t count = 0;
};

class Grouping {
 public:
  Grouping(const Toolpath& path, const RecordingSource& texts) : path_(path), texts_(texts) {}

  void add(const Contact& contact) {
    const WrittenBlock written = writtenBlock(path_, contact.motion, texts_);
    const BlockRef call = !written.inside                    ? BlockRef()
                          : texts_.has(written.inside->file) ? *written.inside
                                                             : written.block;
    const auto same = std::find_if(groups_.rbegin(), groups_.rend(),
                                   [&](const Group& group) { return belongs(group, contact, call); });
    if (same == groups_.rend()) {
      groups_.push_back({contact, contact.motion, contact.last, call, contact.where, 1});
      return;
    }
    Group& group = *same;
    const double volume = group.deepest.volume_mm3 + contact.volume_mm3;
    if (contact.depth_mm > group.deepest.depth_mm) group.deepest = contact;
    group.deepest.volume_mm3 = volume;
    group.last = contact.last;
    group.latest = contact.where;
    ++group.count;
  }
  const std::vector<Group>& groups() const { return groups_; }

 private:
  bool belongs(const Group& group, const Contact& contact, const BlockRef& call) const {
    const Contact& other = group.deepest;
    if (other.kind != contact.kind || path_.motions[other.motion].tool != path_.motions[contact.motion].tool)
      return false;
    return contact.motion <= group.last + kFewMotions || (group.latest - contact.where).norm() < kBeside ||
           (call.line != 0 && call.line == group.call.line && call.file == group.call.file);
  }

  const Toolpath& path_;
  const RecordingSource& texts_;
  std::vector<Group> groups_;
};

Finding findingOf(FindingKind kind, const Group& group, const Toolpath& path, const RecordingSource& texts) {
  Finding finding(kind);
  finding.where = group.deepest.where;
  finding.depth_mm = group.deepest.depth_mm;
  finding.volume_mm3 = group.deepest.volume_mm3;
  finding.spots = group.count;
  blame(finding, group.first, path, texts);
  const WrittenBlock last = writtenBlock(path, group.last, texts);
  if (finding.source && (last.block.line != finding.source->line || last.block.file != finding.source->file))
    finding.last_source = last.block;
  return finding;
}

std::string figures(const Group& group) {
  std::string text = fmt::format("{} mm deep", figure(group.deepest.depth_mm));
  if (group.deepest.volume_mm3 > 0.0)
    text += fmt::format(", {} mm3 in the way", figure(group.deepest.volume_mm3));
  if (group.count > 1) text += fmt::format(", in {} blocks", group.count);
  return text;
}

}  // namespace

void addContacts(const std::vector<Contact>& contacts, double least_mm, const Toolpath& path,
                 const RecordingSource& texts, std::vector<Finding>& findings) {
  StandingSpindle spindle(path, texts);
  Grouping grouping(path, texts);
  bool operators_told = false;
  for (const Contact& contact : contacts) {
    if (contact.depth_mm < least_mm) continue;
    const bool operators = contact.kind == ContactKind::kSpindleOff && spindle.isOperators() &&
                           path.motions[contact.motion].kind != MotionKind::kThread;
    if (!operators) {
      grouping.add(contact);
      continue;
    }
    if (operators_told) continue;
    operators_told = true;
    Finding finding(FindingKind::kSpindleOff);
    finding.severity = Severity::kWarning;
    finding.where = contact.where;
    finding.depth_mm = contact.depth_mm;
    finding.volume_mm3 = contact.volume_mm3;
    finding.message =
        "the program never starts the spindle: M3 is missing, and the tool cuts from here on while it stands "
        "still";
    blame(finding, contact.motion, path, texts);
    findings.push_back(std::move(finding));
  }
  for (const Group& group : grouping.groups()) {
    const ContactTerms terms = termsOf(group.deepest.kind);
    Finding finding = findingOf(terms.kind, group, path, texts);
    if (terms.severity) finding.severity = *terms.severity;
    const std::string why =
        terms.kind == FindingKind::kSpindleOff ? spindle.reason(group.first) : std::string();
    finding.message = fmt::format("{}{}: {}", terms.text, why, figures(group));
    findings.push_back(std::move(finding));
  }
}

void addFixtureContacts(const std::vector<Contact>& contacts, const std::string& fixture, double least_mm,
                        const Toolpath& path, const RecordingSource& texts, std::vector<Finding>& findings) {
  Grouping grouping(path, texts);
  for (const Contact& contact : contacts) {
    if (contact.depth_mm >= least_mm) grouping.add(contact);
  }
  for (const Group& group : grouping.groups()) {
    Finding finding = findingOf(FindingKind::kFixtureContact, group, path, texts);
    finding.message =
        fmt::format("{} runs into fixture '{}': {}", partName(group.deepest.kind), fixture, figures(group));
    findings.push_back(std::move(finding));
  }
}

}  // namespace proveout
