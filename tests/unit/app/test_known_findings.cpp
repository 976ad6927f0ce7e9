// Findings held against a baseline: what is the same, what is worse, what is gone.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/session/findings/acceptance.h"
#include "app/session/findings/known_findings.h"
#include "io/baseline.h"

namespace proveout {
namespace {

using ::testing::HasSubstr;

Finding found(FindingKind kind, Vec3 where, double depth, std::string text = "G1 X15",
              std::uint32_t line = 12) {
  Finding finding(kind);
  finding.where = where;
  finding.depth_mm = depth;
  finding.source = BlockRef{"plate.nc", line, -1, 0, std::move(text)};
  finding.message = "found";
  return finding;
}
Finding gouge(double x, double depth, std::string text = "G1 X15", std::uint32_t line = 12) {
  return found(FindingKind::kGouge, {x, 0, 0}, depth, std::move(text), line);
}

std::vector<KnownFinding> baselineOf(const std::vector<Finding>& findings) {
  const auto read = parseBaseline(baselineText(findings), "known");
  EXPECT_TRUE(read);
  return read ? *read : std::vector<KnownFinding>();
}

/// Which of the findings are known, as text: "k" known, "w" worse, "n" new.
std::string marks(const std::vector<Finding>& before, std::vector<Finding>& now, std::size_t gone) {
  EXPECT_EQ(markKnown(baselineOf(before), {}, now).size(), gone);
  std::string text;
  for (const Finding& finding : now) text += finding.known ? 'k' : finding.worse.empty() ? 'n' : 'w';
  return text;
}

TEST(KnownFindings, TheSameIsKnownWhereverItsLineIs) {
  std::vector<Finding> now = {gouge(5, 0.1, "N55 G1 X15", 40)};
  EXPECT_EQ(marks({gouge(5, 0.1, "N40 G1 X15", 12)}, now, 0), "k");
}

TEST(KnownFindings, OtherPlacesBlocksKindsAndSetupsAreNew) {
  const std::vector<Finding> before = {gouge(5, 0.1)};
  std::vector<Finding> now = {gouge(7, 0.1)};
  EXPECT_EQ(marks(before, now, 1), "n");
  now = {gouge(5, 0.1, "G1 X16")};
  EXPECT_EQ(marks(before, now, 1), "n");
  now = {found(FindingKind::kExcess, {5, 0, 0}, 0.1)};
  EXPECT_EQ(marks(before, now, 1), "n");
  now = {gouge(5, 0.1)};
  now[0].setup = "bottom";
  EXPECT_EQ(marks(before, now, 1), "n");
  now = {gouge(5.5, 0.1)};
  EXPECT_EQ(marks(before, now, 0), "k") << "within 1 mm";
  now = {gouge(5, 0.1)};
  now[0].where.reset();
  EXPECT_EQ(marks(before, now, 1), "n");
}

TEST(KnownFindings, AnEntryStandsForOneFinding) {
  std::vector<Finding> now = {gouge(5.4, 0.1), gouge(5, 0.1)};
  EXPECT_EQ(marks({gouge(5, 0.1)}, now, 0), "nk") << "the one that lies where it lay";
  now = {gouge(5, 0.1), gouge(5.4, 0.1)};
  EXPECT_EQ(marks({gouge(5, 0.1), gouge(5.4, 0.1)}, now, 0), "kk");
}

TEST(KnownFindings, WhatHasAnAreaMayLieAnywhereInIt) {
  Finding wide = gouge(5, 0.1);
  wide.area_mm2 = 400;
  std::vector<Finding> now = {gouge(20, 0.1)};
  now[0].area_mm2 = 400;
  EXPECT_EQ(marks({wide}, now, 0), "k");
  now = {gouge(30, 0.1)};
  EXPECT_EQ(marks({wide}, now, 1), "n");
}

TEST(KnownFindings, WhatGrewBeyondATenthAndTheToleranceIsWorse) {
  std::vector<Finding> now = {gouge(5, 0.115)};
  EXPECT_EQ(marks({gouge(5, 0.1)}, now, 0), "k") << "within the tolerance of 0.02";
  now = {gouge(5, 0.13)};
  EXPECT_EQ(marks({gouge(5, 0.1)}, now, 0), "w") << "worse, and not gone";
  EXPECT_EQ(now[0].worse, "depth 0.13 mm was 0.1");
  now = {gouge(5, 1.05)};
  EXPECT_EQ(marks({gouge(5, 1.0)}, now, 0), "k") << "within a tenth";
  now = {gouge(5, 0.02)};
  EXPECT_EQ(marks({gouge(5, 1.0)}, now, 0), "k") << "better";
}

TEST(KnownFindings, MoreAreaVolumePlacesOrSeverityIsWorse) {
  const auto judge = [](auto before, auto after) {
    std::vector<Finding> old = {found(FindingKind::kRapidContact, {1, 2, 3}, 0.5)}, now = old;
    before(old[0]);
    after(now[0]);
    return marks(old, now, 0);
  };
  const auto nothing = [](Finding&) {};
  EXPECT_EQ(judge(nothing, nothing), "k");
  EXPECT_EQ(judge([](Finding& f) { f.area_mm2 = 10; }, [](Finding& f) { f.area_mm2 = 14; }), "k");
  EXPECT_EQ(judge([](Finding& f) { f.area_mm2 = 10; }, [](Finding& f) { f.area_mm2 = 16; }), "w");
  EXPECT_EQ(judge([](Finding& f) { f.volume_mm3 = 10; }, [](Finding& f) { f.volume_mm3 = 16; }), "w");
  EXPECT_EQ(judge([](Finding& f) { f.spots = 3; }, [](Finding& f) { f.spots = 4; }), "w");
  EXPECT_EQ(judge([](Finding& f) { f.spots = 3; }, [](Finding& f) { f.spots = 2; }), "k");
  EXPECT_EQ(judge([](Finding& f) { f.severity = Severity::kNote; }, nothing), "w");
  EXPECT_EQ(judge(nothing, [](Finding& f) { f.severity = Severity::kNote; }), "k");
}

TEST(KnownFindings, OneOfSeveralBlocksIsMetByItsFirstOrLast) {
  const auto dive = [](double x, const std::string& text) {
    return found(FindingKind::kRapidContact, {x, 0, 0}, 1.0, text);
  };
  Finding both = dive(50, "G0 Z-1");
  both.last_source = BlockRef{"plate.nc", 30, -1, 0, "G0 Z-2"};
  both.spots = 2;
  std::vector<Finding> now = {dive(5, "G0 Z-1")};
  EXPECT_EQ(marks({both}, now, 0), "k") << "the deepest one is gone";
  now = {dive(50, "G0 Z-2")};
  EXPECT_EQ(marks({both}, now, 0), "k") << "the first one is gone";
  now = {dive(50, "G0 Z-3")};
  EXPECT_EQ(marks({both}, now, 1), "n");
  now = {both};
  EXPECT_EQ(marks({dive(5, "G0 Z-1")}, now, 0), "w");
  EXPECT_EQ(now[0].worse, "2 places were 1");
}

TEST(KnownFindings, WithoutDepthTheVolumeCounts) {
  Finding loose(FindingKind::kLoosePiece);
  loose.volume_mm3 = 100;
  std::vector<Finding> now = {loose};
  now[0].volume_mm3 = 108;
  EXPECT_EQ(marks({loose}, now, 0), "k");
  now[0].known = false;
  now[0].volume_mm3 = 112;
  EXPECT_EQ(marks({loose}, now, 0), "w");
}

TEST(KnownFindings, WhatSaysThatAResultIsMissingIsNever) {
  std::vector<Finding> now = {Finding(FindingKind::kUndecided), Finding(FindingKind::kNoPart)};
  EXPECT_EQ(marks(now, now, 0), "nn");
}

TEST(KnownFindings, ManyOfOneBlockAreMatchedOneByOne) {
  std::vector<Finding> before, now;
  for (int k = 0; k < 3000; ++k) before.push_back(gouge(2.0 * k, 0.1));
  now.assign(before.rbegin(), before.rend());
  now.push_back(gouge(-10, 0.1));
  EXPECT_EQ(marks(before, now, 0), std::string(3000, 'k') + "n");
}

// What counts: severities, kinds, baseline.

Job jobWith(SeverityChoice severities) {
  Job job;
  job.severities = std::move(severities);
  return job;
}

std::vector<Finding> three() {
  return {gouge(5, 0.1), found(FindingKind::kRapidContact, {1, 1, 1}, 1), Finding(FindingKind::kThinFeature)};
}

TEST(Acceptance, TheJobChangesSeveritiesAndTurnsOff) {
  std::vector<Finding> findings = three();
  const ReportAcceptance done =
      accept(jobWith({{FindingKind::kGouge, Severity::kWarning}, {FindingKind::kThinFeature, std::nullopt}}),
             {}, true, findings);
  ASSERT_EQ(findings.size(), 2u);
  EXPECT_EQ(findings[0].severity, Severity::kWarning);
  EXPECT_EQ(findings[1].severity, Severity::kError);
  ASSERT_EQ(done.left_out.size(), 1u);
  EXPECT_EQ(done.left_out[0].kind, FindingKind::kThinFeature);
  EXPECT_EQ(done.left_out[0].count, 1u);
  EXPECT_EQ(done.left_out[0].by, "the job");
}

TEST(Acceptance, SelectedKindsAndBindingOnesStay) {
  std::vector<Finding> findings = three();
  findings.emplace_back(FindingKind::kUndecided);
  const ReportAcceptance done = accept(Job(), {{{FindingKind::kGouge}, {}}, {}}, true, findings);
  ASSERT_EQ(findings.size(), 2u);
  EXPECT_EQ(findings[0].kind, FindingKind::kGouge);
  EXPECT_EQ(findings[1].kind, FindingKind::kUndecided);
  EXPECT_EQ(done.left_out.size(), 2u);
  findings = three();
  accept(Job(), {{{}, {FindingKind::kGouge, FindingKind::kRapidContact}}, {}}, true, findings);
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].kind, FindingKind::kThinFeature);
}

TEST(Acceptance, GoneIsOnlyWhatWasLookedFor) {
  const AcceptanceWish::File file{"known.json", "", baselineOf(three())};
  const auto gone = [&](const Job& job, const KindFilter& filter, bool compared,
                        std::vector<Finding> findings) {
    const ReportAcceptance done = accept(job, {filter, file}, compared, findings);
    return done.baseline->gone.size();
  };
  EXPECT_EQ(gone(Job(), {}, true, {}), 3u);
  EXPECT_EQ(gone(Job(), {}, false, {}), 2u) << "nothing was compared: the gouge may still be there";
  EXPECT_EQ(gone(jobWith({{FindingKind::kThinFeature, std::nullopt}}), {}, true, {}), 2u);
  EXPECT_EQ(gone(Job(), {{FindingKind::kGouge}, {}}, true, {}), 1u);
  EXPECT_EQ(gone(Job(), {{}, {FindingKind::kGouge}}, true, {}), 2u);
  EXPECT_EQ(gone(Job(), {}, true, {Finding(FindingKind::kPartial)}), 0u);
}

TEST(Acceptance, ListsOfKinds) {
  const auto refusal = [](const std::vector<std::string>& select, const std::vector<std::string>& ignore) {
    const auto filter = parseKindFilter(select, ignore);
    return filter ? std::string("taken") : filter.error().message;
  };
  EXPECT_EQ(refusal({"gouge,excess", "alarm"}, {"thin_feature"}), "taken");
  EXPECT_THAT(refusal({"gauge"}, {}), HasSubstr("did you mean 'gouge'?"));
  EXPECT_THAT(refusal({""}, {}), HasSubstr("no kind of finding ''"));
  EXPECT_THAT(refusal({"gouge,"}, {}), HasSubstr("no kind of finding ''"));
  EXPECT_THAT(refusal({"gouge", "gouge"}, {}), HasSubstr("twice"));
  EXPECT_THAT(refusal({"gouge"}, {"gouge"}), HasSubstr("in --select and in --ignore"));
  EXPECT_THAT(refusal({}, {"alarm"}), HasSubstr("would hide"));
}

}  // namespace
}  // namespace proveout
