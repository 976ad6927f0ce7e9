// From the command line to a job: a job file, or a program with options in place of one.
#pragma once

#include <optional>
#include <string>

#include "app/cli_options.h"
#include "core/base/diagnostics.h"
#include "io/job/job.h"

namespace proveout {

/// Names and parameter ranges that job files are checked against, those of pictures among them.
JobNames knownJobNames();

/// True for the names of job files: *.toml.
bool isJobFile(const std::string& path);

/// The job that the options mean. With a program it has no stock yet (see applyRunOptions). Errors go to
/// `diagnostics`; then there is no job.
std::optional<Job> setUpJob(const ProgramOptions& options, Diagnostics& diagnostics);

/// Lets the options of `run` fill or override the job. Returns false after an error.
bool applyRunOptions(const RunOptions& options, Job& job, Diagnostics& diagnostics);

/// The folder for the results: `--out`, or NAME-out beside the job file, or in the current folder.
std::string outputFolder(const RunOptions& options, const Job& job);

/// `name` as a file name: letters, digits, dots, dashes and bytes beyond ASCII stay, all else becomes '_'.
std::string fileName(const std::string& name);

}  // namespace proveout
