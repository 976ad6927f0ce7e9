// Errors of the contour stages as alarms of the channel.
#pragma once

#include "core/nc/contour_stage.h"

namespace proveout::nc {

struct NctContext;

/// Errors of the contour stages become alarms.
class ContourAlarms final : public ContourReport {
 public:
  explicit ContourAlarms(NctContext& context) : c_(context) {}
  bool contourError(SharedAlarm alarm, std::string_view subject, std::string_view detail,
                    const PathItem& at) override;

 private:
  NctContext& c_;
};

}  // namespace proveout::nc
