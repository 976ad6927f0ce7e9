// The files that a job reads, with what they are to it.
#pragma once

#include <string>
#include <vector>

#include "app/session/programs/interpretation.h"
#include "io/job/job.h"
#include "io/output_guard.h"

namespace proveout {

struct InputFile {
  std::string role;  ///< "job", "machine", "program", "subprogram", "template", "stock", "fixture", "nominal"
  std::string path;  ///< as it is opened
};

/// What the job names, known before anything is read. Folders of subprograms are not among them.
std::vector<InputFile> namedInputs(const Job& job);

/// The templates and sets that the job fills in, with the templates that sets name.
std::vector<InputFile> templatesOf(const Job& job);

/// Carries out what a killed command left half done in the folders of these files, which may be results (see
/// result_moves.h). Errors: it cannot be.
Status settleInputs(const std::vector<InputFile>& files);

void protectAll(const std::vector<InputFile>& files, OutputGuard& guard);

/// The programs that were read of a clamping, the main programs of its channels first.
std::vector<InputFile> programsRead(const RecordingSource& source);

}  // namespace proveout
