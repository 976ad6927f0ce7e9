// What trials may take together: about as much as the run itself, told in its own size, so that how many
// there are does not depend on the machine.
#pragma once

#include <algorithm>
#include <cstddef>

#include "core/path/toolpath.h"

namespace proveout {

/// In motions: what a trial takes for each, and besides them. Motions that turn the tool are searched.
double trialSize(const Toolpath& path);

class TrialBudget {
 public:
  /// `trials` of the size of the run, `size`.
  TrialBudget(std::size_t trials, double size) : left_(static_cast<double>(trials)), size_(size) {}

  bool isSpent() const { return left_ < 1.0; }
  /// One trial, whatever it turns out to be.
  void takeOne() { left_ -= 1.0; }
  /// A trial for which one was taken has this size. False: it is too large for what is left, and is not to be
  /// run.
  bool takeRest(double size) {
    const double more = std::max(0.0, size / size_ - 1.0);
    if (more > left_) {
      ++refused_;
      return false;
    }
    left_ -= more;
    return true;
  }
  /// Trials that were too large.
  std::size_t refused() const { return refused_; }

 private:
  double left_, size_;
  std::size_t refused_ = 0;
};

}  // namespace proveout
