// Running the program on its virtual control, and the texts that it was made of.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/session/blank.h"
#include "core/nc/interpreter.h"
#include "core/path/origin_query.h"
#include "core/path/toolpath.h"
#include "io/job.h"
#include "io/report.h"

namespace proveout {

struct ProbedStock;

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

struct Interpreted {
  Toolpath path;
  InterpretSummary summary;
  std::map<std::string, std::string> files;  ///< that the program wrote, by name
  std::optional<Error> probe_failure;        ///< the stock could not answer a measuring move
  std::optional<SourceRef> outgrown_at;      ///< block at which the path outgrew its memory; cancelled there
};

/// Settings of the job, with the places that it leaves open taken from a blank that has these bounds; see
/// placeMachine and giveWireHeights.
ControlSettings controlSettings(const Job& job, const Box3& blank);

/// Runs the job's program, or those of its channels.
InterpretSummary interpretJob(const Job& job, ControlId control, const RecordingSource& source,
                              const ControlSettings& settings, MotionSink& sink, Progress& progress,
                              const ControlHost& host);

/// `stock`: what measuring moves meet; null, or with several channels: nothing.
Interpreted interpretProgram(const Job& job, const RecordingSource& source, const ControlSettings& settings,
                             Progress& progress, const ProbedStock* stock = nullptr);

/// False, with an error in the path's diagnostics, if a motion turns the tool or the workpiece: the engine
/// cuts with a tool along +z in a workpiece that stands still.
bool refuseRotaryMotion(Toolpath& path, const RecordingSource& source);

/// Tools that the control calls and the job does not have get the shape that their offset row tells (D of a
/// row with a corner radius, event tool_shape); a note says so. The first row that a tool is used with
/// counts.
void addOffsetTools(Toolpath& path, std::vector<Tool>& tools);

/// Gives motions that name no tool the lowest tool of the job and checks that every tool used is defined.
/// What it finds goes to `path.diagnostics`; false after an error.
bool assignTools(Toolpath& path, const std::vector<Tool>& tools, const RecordingSource& source);

BlockRef blockRef(const Toolpath& path, const SourceRef& source, const RecordingSource& texts);

/// Lines of the path's files. Valid as long as both.
LineText lineText(const Toolpath& path, const RecordingSource& texts);

}  // namespace proveout
