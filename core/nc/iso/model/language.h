// What a control of the ISO family does with its lines in a way of its own: reading them, statements, calls
// by other words. A dialect without a language has the shared lexer and macro language.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "core/nc/iso/model/call_stack.h"
#include "core/nc/text/block.h"
#include "core/nc/text/lexer.h"

namespace proveout::nc {

enum class Go : std::uint8_t;  // flow/run_loop.h

/// What statements ask of the run.
class StatementFlow {
 public:
  virtual ~StatementFlow() = default;
  /// Opens a program so many times; `frame` has its text, first and end. kCalls; kOn: no time at all.
  virtual Go openCall(const CallFrame& frame, int times) = 0;
  /// The program ends here; `code` is the word that says so.
  virtual Go endRun(const std::string& code) = 0;
  /// Behind an error that was reported. `nowhere`: the run cannot go on, whatever the job allows.
  virtual Go failed(bool nowhere) = 0;
  /// The block in hand is done: before a statement that calls, jumps or returns.
  virtual void statementDone() = 0;
  /// Plans the words of the block in hand and carries them out. False: reported.
  virtual bool carryOutWords() = 0;
};

class IsoLanguage {
 public:
  virtual ~IsoLanguage() = default;

  /// Fills `block` with what a line of the program in hand says: words with their values, and `kind` kOwn for
  /// statements. Nothing takes effect yet, as the line may be one to be left out. False: `error` says why.
  virtual bool read(const SourceText& text, std::size_t line, Block& block, LexError& error) = 0;
  /// The line that was read is carried out, but for its words. Nothing: the words are to be planned.
  virtual std::optional<Go> statement(StatementFlow& flow) = 0;
  /// Behind the last line of the innermost program. Nothing: as in the shared code.
  virtual std::optional<Go> endOfText(StatementFlow& flow) = 0;
  /// A called program was left for good; its caller is in hand again.
  virtual void left(const CallFrame& frame) = 0;
  /// The same while all that statements depend on has the same values.
  virtual std::uint64_t fingerprint() const = 0;
};

}  // namespace proveout::nc
