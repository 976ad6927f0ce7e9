// The `proveout` program: streams and signals; everything else is in runCommandLine.
#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <iostream>

#include "app/commands.h"
#include "app/exit_codes.h"

namespace {

std::atomic<proveout::Progress*> running{nullptr};

/// The first signal asks the work to stop, a second one ends the process at once.
extern "C" void onSignal(int signal) {
  if (proveout::Progress* progress = running.exchange(nullptr)) {
    progress->cancel();
  } else {
    _exit(signal == SIGINT ? proveout::kExitInterrupted : 128 + signal);
  }
}

/// Where standard streams are closed a file would get their number, and messages would be written into it. A
/// stand-in that cannot be written to makes them fail instead.
void keepStandardStreams() {
  int descriptor = 0;
  do {
    descriptor = ::open("/dev/null", O_RDONLY);
  } while (descriptor >= 0 && descriptor <= STDERR_FILENO);
  if (descriptor > STDERR_FILENO) ::close(descriptor);
}

}  // namespace

int main(int argc, char** argv) {
  keepStandardStreams();
  std::ios::sync_with_stdio(false);
  proveout::Console console{std::cout, std::cerr, isatty(STDERR_FILENO) == 1};
  proveout::ConsoleProgress progress(std::cerr);
  running = &progress;
  std::signal(SIGINT, onSignal);
  std::signal(SIGTERM, onSignal);
#ifdef SIGXFSZ
  std::signal(SIGXFSZ, SIG_IGN);  // a file beyond the limit is an error of that file, told like a full disk
#endif
  const int code = proveout::runCommandLine({argv + 1, argv + argc}, console, progress);
  running = nullptr;
  return code;
}
