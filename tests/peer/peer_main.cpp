// peer COUNT SEED FOLDER: random programs here and in LinuxCNC's interpreter. A program that both refuse is
// run again without the line that was refused, until it runs.
// peer --files FOLDER FILE...: these programs.
#include <fmt/core.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "tests/peer/comparison.h"
#include "tests/peer/language_programs.h"
#include "tests/peer/programs.h"

namespace proveout::peer {
namespace {

using Counts = std::map<Verdict, int>;

void print(const Counts& counts) {
  const auto of = [&](Verdict v) { return counts.contains(v) ? counts.at(v) : 0; };
  fmt::print("same {}, same refusal {}, known faults {}, different {}\n", of(Verdict::kSame),
             of(Verdict::kSameRefusal), of(Verdict::kFault), of(Verdict::kDifferent));
}

/// A random program on its way: it lives while both refuse the same line.
struct Trial {
  std::vector<std::string> lines;
  std::string path;
  bool open = true;
};

void write(const Trial& trial) {
  std::ofstream out(trial.path);
  for (const std::string& line : trial.lines) out << line << '\n';
}

void round(std::vector<Trial>& trials, const std::string& folder, Counts& counts, Counts& ends) {
  std::vector<std::string> paths;
  for (const Trial& t : trials) {
    if (!t.open) continue;
    write(t);
    paths.push_back(t.path);
  }
  const std::vector<PeerRun> theirs = runInterpreter(paths, tableOf(peerTools()), folder);
  auto run = theirs.begin();
  for (Trial& t : trials) {
    if (!t.open) continue;
    const Ours ours = runHere(t.path);
    std::string what;
    const Verdict verdict = compare(*run++, ours, what);
    ++counts[verdict];
    const bool again =
        verdict == Verdict::kSameRefusal && ours.line > 0 && ours.line < static_cast<int>(t.lines.size());
    if (verdict == Verdict::kDifferent)
      fmt::print("{}: {}\n", t.path, what);
    else if (!again)
      std::filesystem::remove(t.path);
    if (again) t.lines.erase(t.lines.begin() + ours.line - 1);
    if (!again) ++ends[verdict];
    t.open = again;
  }
}

int compareRandom(int count, std::uint64_t seed, const std::string& folder) {
  constexpr int kAtOnce = 500;
  Counts counts, ends;
  for (int from = 0; from < count; from += kAtOnce) {
    std::vector<Trial> trials;
    for (int k = from; k < std::min(count, from + kAtOnce); ++k) {
      const std::uint64_t own = seed * 1000003u + static_cast<std::uint64_t>(k);
      trials.push_back({k % 4 == 3 ? randomLanguageProgram(own) : randomProgram(own),
                        fmt::format("{}/different-{}-{}.ngc", folder, seed, k)});
    }
    for (int k = 0; k < 40; ++k) round(trials, folder, counts, ends);
    for (const Trial& t : trials)
      if (t.open) ++ends[Verdict::kSameRefusal];
  }
  fmt::print("programs as they end: ");
  print(ends);
  fmt::print("with the rounds before: ");
  print(counts);
  return counts[Verdict::kDifferent] == 0 ? 0 : 1;
}

/// The tool table beside a program, as LinuxCNC's own tests have one.
std::string tableBeside(const std::string& file) {
  std::ifstream in(std::filesystem::path(file).parent_path() / "test.tbl");
  std::ostringstream all;
  all << in.rdbuf();
  return all.str().empty() ? tableOf(peerTools()) : all.str();
}

int compareFiles(const std::string& folder, const std::vector<std::string>& files) {
  Counts counts;
  for (const std::string& file : files) {
    const std::string table = tableBeside(file);
    std::string what;
    const Verdict verdict =
        compare(runInterpreter({file}, table, folder).front(), runHere(file, table), what);
    ++counts[verdict];
    fmt::print("{} {}: {}\n", verdict == Verdict::kDifferent ? "DIFFERENT" : "same", file, what);
  }
  print(counts);
  return counts[Verdict::kDifferent] == 0 ? 0 : 1;
}

}  // namespace
}  // namespace proveout::peer

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  if (!proveout::peer::hasInterpreter()) {
    fmt::print("LinuxCNC (linuxcnc-uspace) is not installed: nothing to compare with\n");
    return 0;
  }
  if (words.size() > 2 && words[0] == "--files")
    return proveout::peer::compareFiles(words[1], {words.begin() + 2, words.end()});
  const int count = !words.empty() ? std::atoi(words[0].c_str()) : 200;
  const std::uint64_t seed = words.size() > 1 ? std::strtoull(words[1].c_str(), nullptr, 10) : 1;
  const std::string folder = words.size() > 2 ? words[2] : "out/peer";
  std::filesystem::create_directories(folder);
  return proveout::peer::compareRandom(count, seed, folder);
}
