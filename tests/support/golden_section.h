// The slow and sure search for least values that references in tests use.
#pragma once

#include <cmath>
#include <functional>

namespace proveout::test {

/// Place of the least value of a convex f between a and b, to `within`.
inline double leastAt(const std::function<double(double)>& f, double a, double b, double within = 1e-13) {
  const double golden = 0.5 * (std::sqrt(5.0) - 1.0);
  double c = b - golden * (b - a), d = a + golden * (b - a), fc = f(c), fd = f(d);
  for (int i = 0; i < 90 && b - a > within; ++i) {
    if (fc < fd) {
      b = d, d = c, fd = fc, c = b - golden * (b - a), fc = f(c);
    } else {
      a = c, c = d, fc = fd, d = a + golden * (b - a), fd = f(d);
    }
  }
  return 0.5 * (a + b);
}

}  // namespace proveout::test
