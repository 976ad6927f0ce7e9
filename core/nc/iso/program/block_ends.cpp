#include "core/nc/iso/program/block_ends.h"

#include <fmt/core.h>

#include "core/nc/text/lexer.h"

namespace proveout::nc {
namespace {

Columns columnsOf(std::size_t from, std::size_t end) {
  return {static_cast<int>(from) + 1, static_cast<int>(end) + 1};
}

}  // namespace

BlockSpan nextSpan(IsoContext& c, CallFrame& frame) {
  const std::string_view line = frame.text->lines()[frame.block];
  if (!c.dialect.lexing.semicolon_ends_block) return {0, line.size()};
  const std::size_t from = frame.more_line == frame.block ? frame.more_from : 0;
  frame.more_from = 0;
  const BlockSpan span{from, blockEnd(line, from)};
  if (span.end >= line.size()) return span;
  const std::size_t rest = span.end + 1;
  const std::string_view behind = line.substr(rest);
  if (readsAsBlock(behind.substr(0, blockEnd(behind, 0)))) {
    frame.more_line = frame.next = frame.block;
    frame.more_from = rest;
  } else if (behind.find_first_not_of(" \t;") != std::string_view::npos && c.firstTime("text behind ;")) {
    c.setBlock(frame.block, -1);
    c.block.clear();
    c.warn("semicolon", "text behind ; that is no block is taken as a comment (told once)",
           columnsOf(rest, line.size()), Severity::kNote);
  }
  return span;
}

void noteComments(IsoContext& c) {
  const Block& block = c.block;
  if (block.nested_at.begin > 0 && c.firstTime("comment in comment")) {
    c.warn("nested-comment", "a ( inside of a comment is text: the first ) closes the comment (told once)",
           block.nested_at, Severity::kNote);
  }
  if (block.open_at.begin > 0 && c.firstTime("open comment")) {
    c.warn("open-comment", "a comment that nobody closes ends with its line (told once)", block.open_at,
           Severity::kNote);
  }
}

}  // namespace proveout::nc
