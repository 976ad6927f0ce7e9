// Rounding to float that the compiler keeps. GCC 12.2 takes two doubles side by side that go to float and
// back for what they were, once its superword vectorizer has made one vector of them: what is rounded here it
// cannot join.
#pragma once

#include <Eigen/Core>
#include <concepts>
#include <type_traits>

namespace proveout {

/// The float nearest to `value`.
[[gnu::always_inline]] constexpr float toFloat(double value) {
  float rounded = static_cast<float>(value);
  if (!std::is_constant_evaluated()) {
#if defined(__GNUC__) && defined(__SSE2__)
    asm("" : "+x"(rounded));
#elif defined(__GNUC__) && defined(__aarch64__)
    asm("" : "+w"(rounded));
#elif defined(__GNUC__)
    asm("" : "+m"(rounded));
#endif
  }
  return rounded;
}
constexpr float toFloat(std::integral auto value) { return static_cast<float>(value); }
constexpr float toFloat(float value) { return value; }

/// The same of each coordinate.
template <typename Derived>
auto toFloat(const Eigen::MatrixBase<Derived>& values) {
  Eigen::Matrix<float, Derived::RowsAtCompileTime, Derived::ColsAtCompileTime> rounded;
  for (Eigen::Index i = 0; i < rounded.size(); ++i) rounded[i] = toFloat(values.derived().coeff(i));
  return rounded;
}

}  // namespace proveout
