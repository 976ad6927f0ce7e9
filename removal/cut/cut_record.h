// What cut a stock: the solids of its tools and their passes. A stock keeps it until it is cut again or
// moved, since it tells where the surface is between the crossings.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include "core/tool/tool_solid.h"
#include "removal/cut/body_index.h"
#include "removal/cut/pass.h"

namespace proveout {

/// The convex parts of one tool.
struct ToolParts {
  explicit ToolParts(const Tool& tool) : solid(makeToolSolid(tool)) {
    for (const ConvexProfile& p : solid.cutter) add(p, ToolPart::kCutter);
    for (const ConvexProfile& p : solid.shank) add(p, ToolPart::kShank);
    for (const ConvexProfile& p : solid.holder) add(p, ToolPart::kHolder);
  }
  ToolParts(const ToolParts&) = delete;

  struct Envelope;
  struct Part {
    const ConvexProfile* profile;
    ColumnSolid columns;
    ToolPart part;
    // Made where they are asked for.
    std::unique_ptr<Envelope> envelope = nullptr;
    std::unique_ptr<Envelope> lean_envelope = nullptr;  ///< for where the tool leans
  };
  /// A solid that holds all that comes near to a part. It does not cut.
  struct Envelope {
    explicit Envelope(const ConvexProfile& around)
        : profile(around), body{&profile, columnSolid(profile), ToolPart::kShank} {}
    Envelope(const Envelope&) = delete;
    ConvexProfile profile;
    Part body;
  };
  ToolSolid solid;
  std::vector<Part> parts;

 private:
  void add(const ConvexProfile& profile, ToolPart part) {
    parts.push_back({&profile, columnSolid(profile), part});
  }
};

struct CutRecord {
  std::map<int, ToolParts> tools;
  PassTable table;

  /// All cutters; made when first asked for, which any thread may do once the table is whole.
  const CutterIndex& cutters() const {
    std::call_once(indexed_, [&] { index_ = std::make_unique<CutterIndex>(table, kNoMotion); });
    return *index_;
  }

 private:
  mutable std::once_flag indexed_;
  mutable std::unique_ptr<CutterIndex> index_;
};

}  // namespace proveout
