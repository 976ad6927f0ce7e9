// Result<T>: a value or the reason why there is none. Expected failures (bad program, bad file,
// cancelled, too large) are values; exceptions are for bugs and for foreign libraries, and are caught
// once at the boundary of the library that throws them.
#pragma once

#include <string>
#include <utility>
#include <variant>

namespace proveout {

/// What kind of failure it is; the command line derives its exit code from it (docs: exit codes).
enum class ErrorKind {
  kInput,          ///< bad file, bad option, bad job: exit 2
  kResourceLimit,  ///< memory guard, time limit: exit 3
  kInterrupted,    ///< Ctrl-C: exit 130
  kInternal,       ///< a bug or a library failure: exit 2, says so
};

struct Error {
  ErrorKind kind = ErrorKind::kInput;
  std::string message;  ///< one sentence with file, place and what to do
};

template <typename T>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::move(value)) {}      // NOLINT: implicit on purpose
  Result(Error error) : state_(std::move(error)) {}  // NOLINT: implicit on purpose

  bool ok() const { return state_.index() == 0; }
  explicit operator bool() const { return ok(); }
  T& value() & { return std::get<0>(state_); }
  const T& value() const& { return std::get<0>(state_); }
  T&& value() && { return std::get<0>(std::move(state_)); }
  T& operator*() & { return value(); }
  const T& operator*() const& { return value(); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }
  const Error& error() const { return std::get<1>(state_); }

 private:
  std::variant<T, Error> state_;
};

/// Result of an operation that returns nothing.
struct Done {};
using Status = Result<Done>;

inline Error inputError(std::string message) { return {ErrorKind::kInput, std::move(message)}; }

}  // namespace proveout
