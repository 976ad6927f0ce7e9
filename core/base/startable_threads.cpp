#include "core/base/startable_threads.h"

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace proveout {

int startableThreads(int wanted) {
  std::mutex mutex;
  std::condition_variable counted;
  bool over = false;
  std::vector<std::thread> threads;
  threads.reserve(static_cast<std::size_t>(std::max(wanted, 0)));
  try {
    // They stay until all are there: it is their number at one time that is limited.
    for (int k = 0; k < wanted; ++k) {
      threads.emplace_back([&] {
        std::unique_lock<std::mutex> lock(mutex);
        counted.wait(lock, [&] { return over; });
      });
    }
  } catch (const std::system_error&) {
    // what there is has to do
  }
  {
    const std::lock_guard<std::mutex> lock(mutex);
    over = true;
  }
  counted.notify_all();
  for (std::thread& thread : threads) thread.join();
  return static_cast<int>(threads.size());
}

}  // namespace proveout
