#include "tests/soak/second/second_soak.h"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>

#include "tests/soak/second/relations.h"

namespace proveout::soak::second {
namespace {

void writeAll(const std::filesystem::path& folder, const Files& files) {
  for (const auto& [name, text] : files) {
    std::filesystem::create_directories((folder / name).parent_path());
    std::ofstream(folder / name, std::ios::binary) << text;
  }
}

/// The job, the other one in "other", and a line that says why.
void keepCase(const std::string& keep, std::uint64_t seed, const Ran& job, const Relation& relation,
              const Answer& answer) {
  std::string name = fmt::format("{} {} {}", job.plan.process, relation.name, seed);
  for (char& c : name)
    if (c == ' ' || c == '>') c = '-';
  const std::filesystem::path folder = std::filesystem::path(keep) / name;
  writeAll(folder, job.files);
  if (answer.other) writeAll(folder / "other", answer.other->files);
  std::ofstream(folder / "REASON.txt")
      << relation.name << " (" << relation.law << "): " << answer.broken << "\n";
}

}  // namespace

Verdict judgePlan(std::uint64_t seed, const std::string& only, const std::string& keep) {
  Verdict verdict;
  const Ran job = runPlan(makePlan(seed));
  verdict.process = job.plan.process;
  verdict.ran = job.run.ok();
  if (!verdict.ran) {
    verdict.why = job.run.error().message;
    return verdict;
  }
  std::uint64_t number = 0;
  for (const Relation& relation : relations()) {
    Dice dice(seed, 100 + number++);
    if (!only.empty() && only != relation.name) continue;
    const Answer answer = relation.ask(job, dice);
    if (answer.asked) verdict.asked.emplace_back(relation.name);
    if (!answer.broken.empty()) {
      verdict.broken.push_back({relation.name, verdict.process, answer.broken});
      if (!keep.empty()) keepCase(keep, seed, job, relation, answer);
    } else if (!answer.beyond.empty()) {
      verdict.beyond.push_back({relation.name, verdict.process, answer.beyond});
    }
  }
  return verdict;
}

void Tally::add(const Verdict& verdict) {
  ++jobs_;
  if (!verdict.ran) ++refused_[verdict.process + ": " + verdict.why.substr(0, 90)];
  if (!verdict.broken.empty()) ++bad_;
  for (const std::string& relation : verdict.asked) ++cells_[relation][verdict.process].asked;
  for (const Broken& b : verdict.broken) ++cells_[b.relation][b.process].broken;
  for (const Broken& b : verdict.beyond) ++cells_[b.relation][b.process].beyond;
}

std::string Tally::table() const {
  std::string text;
  std::uint64_t refused = 0;
  for (const auto& [relation, row] : cells_) {
    for (const auto& [process, cell] : row)
      text += fmt::format("{:14} {:14} {:6} asked {:5} broken {:5} by thin_feature alone\n", relation,
                          process, cell.asked, cell.broken, cell.beyond);
  }
  for (const auto& [why, times] : refused_) {
    refused += times;
    text += fmt::format("{:6} refused: {}\n", times, why);
  }
  return text + fmt::format("{} jobs, {} refused, {} break a law\n", jobs_, refused, bad_);
}

}  // namespace proveout::soak::second
