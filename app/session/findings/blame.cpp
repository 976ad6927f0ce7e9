#include "app/session/findings/blame.h"

#include "core/base/assert.h"
#include "core/path/origin_query.h"

namespace proveout {

BlockRef blockRef(const Toolpath& path, const ResolvedOrigin& word, const RecordingSource& texts) {
  SourceRef ref;
  ref.file = word.file;
  ref.line = word.line;
  ref.block = word.block;
  ref.depth = word.depth;
  return blockRef(path, ref, texts);
}

namespace {

/// The innermost call from a program that the user wrote.
std::optional<BlockRef> userCall(const Toolpath& path, MotionId motion, const RecordingSource& texts,
                                 const LineText& text) {
  std::optional<ResolvedOrigin> call = callOf(path, motion, text);
  while (call && !texts.has(path.files[call->file])) {
    if (call->from.empty()) return std::nullopt;
    const ResolvedOrigin outer = call->from.front();
    call = outer;
  }
  if (!call) return std::nullopt;
  return blockRef(path, *call, texts);
}

}  // namespace

WrittenBlock writtenBlock(const Toolpath& path, MotionId motion, const RecordingSource& texts) {
  PROVEOUT_ASSERT(motion < path.motions.size());
  WrittenBlock written;
  const SourceRef& own = path.motions[motion].source;
  written.block = blockRef(path, own, texts);
  const LineText text = lineText(path, texts);
  std::optional<BlockRef> wanted;
  if (const auto contour = originOf(path, motion, OriginKind::kContour, text)) {
    if (contour->line != own.line || contour->file != own.file) wanted = blockRef(path, *contour, texts);
  } else if (!texts.has(written.block.file)) {
    wanted = userCall(path, motion, texts, text);
  }
  if (!wanted) return written;
  written.inside = std::move(written.block);
  written.block = std::move(*wanted);
  return written;
}

void blame(Finding& finding, MotionId motion, const Toolpath& path, const RecordingSource& texts) {
  if (motion >= path.motions.size()) return;
  WrittenBlock written = writtenBlock(path, motion, texts);
  finding.motion = motion;
  finding.source = std::move(written.block);
  finding.inside = std::move(written.inside);
  finding.tool = path.motions[motion].tool;
}

}  // namespace proveout
