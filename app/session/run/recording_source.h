// The texts that a run was made of.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/nc/control/program_source.h"
#include "core/path/origin_query.h"
#include "core/path/toolpath.h"
#include "io/job/job.h"
#include "io/report.h"

namespace proveout {

/// Passes programs on and keeps what it has passed, for source lines and hashes. One thread.
class RecordingSource : public ProgramSource {
 public:
  RecordingSource(const ProgramSource& inner, TextEncoding encoding) : inner_(inner), encoding_(encoding) {}
  Result<ProgramText> mainProgram() const override;
  Result<ProgramText> subprogram(const SubprogramQuery& query) const override;
  bool finds(const SubprogramQuery& query) const override { return inner_.finds(query); }

  /// Channels besides the one whose program is the main program, in the order of their numbers: their
  /// programs are kept here too. `inner` must outlive this.
  void addChannel(const ProgramSource& inner);
  /// Of all channels, this one first.
  std::vector<const ProgramSource*> channels() const;

  /// Where the lines of the text with that name come from; null: they are its own.
  const TextOrigins* origins(const std::string& file) const;
  /// Text of a line of the file with that name, UTF-8; empty where there is none. Of a text that was made of
  /// several files, by the names and lines of these.
  std::string line(const std::string& file, std::uint32_t number) const;
  /// Is it a file of the user's, none of the control's own programs?
  bool has(const std::string& file) const;
  /// Every text once, the main program first.
  const std::vector<ProgramText>& texts() const { return texts_; }

 private:
  /// Passes on the programs of another channel.
  struct Channel : ProgramSource {
    Channel(const RecordingSource& owner, const ProgramSource& inner_source)
        : recording(owner), inner(inner_source) {}
    Result<ProgramText> mainProgram() const override { return recording.keep(inner.mainProgram()); }
    Result<ProgramText> subprogram(const SubprogramQuery& query) const override {
      return recording.keep(inner.subprogram(query));
    }
    bool finds(const SubprogramQuery& query) const override { return inner.finds(query); }
    const RecordingSource& recording;
    const ProgramSource& inner;
  };
  Result<ProgramText> keep(Result<ProgramText> text) const;
  void readLines(const ProgramText& text) const;

  const ProgramSource& inner_;
  TextEncoding encoding_;
  std::vector<std::unique_ptr<Channel>> channels_;
  mutable std::vector<ProgramText> texts_;
  mutable std::map<std::string, std::vector<std::string>> lines_;  ///< by name, decoded on demand
};

/// The program files of a job, one recording source a clamping.
class JobSources {
 public:
  explicit JobSources(const Job& job);
  JobSources(const JobSources&) = delete;
  /// In the order of the clampings; valid as long as this object.
  const std::vector<const RecordingSource*>& all() const { return all_; }

 private:
  std::vector<std::unique_ptr<ProgramSource>> files_;
  std::vector<std::unique_ptr<RecordingSource>> sources_;
  std::vector<const RecordingSource*> all_;
};

BlockRef blockRef(const Toolpath& path, const SourceRef& source, const RecordingSource& texts);

/// Lines of the path's files. Valid as long as both.
LineText lineText(const Toolpath& path, const RecordingSource& texts);

}  // namespace proveout
