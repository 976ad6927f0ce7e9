// Which form of a template a block asks for, and whether its letters are good (digest flexnc, 5.1, 5.2, 12).
#pragma once

#include <optional>
#include <vector>

#include "core/nc/flexnc/cycles/cycle_call.h"
#include "core/nc/flexnc/template/template_profile.h"

namespace proveout::nc {

enum class TemplateForm { kRoughing, kContour };

struct TemplateCheck {
  std::optional<CycleNote> alarm;
  std::vector<CycleNote> warnings;
  TemplateForm form = TemplateForm::kRoughing;
  bool goes_on = false;  ///< contour: K=0
};
/// Looks at letters alone; what geometry forbids, templateProfile() finds.
TemplateCheck checkTemplate(const TemplateRow& row, const CycleArguments& arguments);
/// The letters of a call that checkTemplate() lets pass.
TemplateInput templateInput(const TemplateRow& row, const CycleArguments& arguments, ArcView view);

}  // namespace proveout::nc
