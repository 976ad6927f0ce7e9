// A part that only turned.
#pragma once

#include "removal/process/part_form.h"

namespace proveout {

class TurnedForm final : public PartForm {
 public:
  /// Its bodies, the part first.
  explicit TurnedForm(TurnedShape shape) : shape_(std::move(shape)) {}

  const TurnedShape& shape() const { return shape_; }
  const std::vector<SectionLoop>* profile() const override {
    return shape_.bodies.empty() ? nullptr : &shape_.bodies.front().loops;
  }
  bool revolved() const override { return shape_.threads.empty(); }
  std::optional<Vec2> pictureAxis() const override { return Vec2(0.0, 0.0); }
  std::optional<Result<std::unique_ptr<ExactPart>>> exactPart() const override;
  std::optional<StockShape> asBlank(const RigidTransform& moved) const override;
  bool closedForm() const override { return true; }
  std::optional<double> gridChords(double resolution_mm) const override;
  std::vector<Parted> parted() const override;

 private:
  std::shared_ptr<const TurnedShape> partAlone() const;
  TurnedShape shape_;
};

}  // namespace proveout
