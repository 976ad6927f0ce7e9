// Cutter compensation of nct as a stage of the motion pipe.
#pragma once

#include <string>

#include "core/nc/compensation_stage.h"

namespace proveout::nc {

struct NctContext;

/// Says what is wrong, and slows feeds at arcs inside.
class CompStage final : public CompensationStage {
 public:
  explicit CompStage(NctContext& context);

  /// Compensation begins with the next item; the last one ended at `start`, (u, v, w).
  void engage(const Vec3& start);

 private:
  void note(const CompNote& told) override;
  void failed(const CompStatus& status) override;
  bool send(const CompPiece& piece, const PathItem& item, PathItem& out) override;
  void report(Severity severity, const char* code, const std::string& message, std::uint64_t tag);

  NctContext& c_;
};

}  // namespace proveout::nc
