#include "removal/process/part_form.h"

namespace proveout {

const std::shared_ptr<const PartForm>& PartForm::plain() {
  static const std::shared_ptr<const PartForm> kPlain = std::make_shared<PartForm>();
  return kPlain;
}

}  // namespace proveout
