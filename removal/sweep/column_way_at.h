// A place of a way as a column sees it, and steps of the searches there; for the kernels and for the search
// of one column. Included within an unnamed namespace of each, so that no function of it has external
// linkage.
#pragma once

/// A step this short on the way, mm, ends a search: what it leaves is its square.
constexpr double kWayStepMm = 1e-6;

inline double wayMost(double a, double b) { return a > b ? a : b; }
inline double wayRoot(double a) { return __builtin_sqrt(a > 0.0 ? a : 0.0); }

/// A place of the way from a column, level; its height, and both derivatives.
struct WayAt {
  double x, y, z, vx, vy, vz, ax, ay, az;
  double square() const { return x * x + y * y; }
  double toward() const { return x * vx + y * vy; }
  double bend() const { return vx * vx + vy * vy + x * ax + y * ay; }
  /// The same but for what the speed along the way changes, which is nothing where toward() is 0.
  double sideBend() const {
    const double speed2 = vx * vx + vy * vy;
    return speed2 + (x * vy - y * vx) * (ax * vy - ay * vx) / speed2;
  }
};

/// px, py: of the column, from the part's middle. The series are exact within rounding on an eighth of a
/// turn.
inline WayAt wayAt(const proveout::WayPart& w, double px, double py, double a) {
  const double b = a * a;
  double s = -1.0 / 39916800, c = 1.0 / 479001600;
  s = s * b + 1.0 / 362880, c = c * b - 1.0 / 3628800;
  s = s * b - 1.0 / 5040, c = c * b + 1.0 / 40320;
  s = s * b + 1.0 / 120, c = c * b - 1.0 / 720;
  s = s * b - 1.0 / 6, c = c * b + 1.0 / 24;
  const double less = b * (c * b - 0.5), sine = a + a * b * s, cosine = 1.0 + less;
  const double ox = cosine * w.ux + sine * w.vx, oy = cosine * w.uy + sine * w.vy,
               oz = cosine * w.uz + sine * w.vz;
  const double nx = cosine * w.vx - sine * w.ux, ny = cosine * w.vy - sine * w.uy,
               nz = cosine * w.vz - sine * w.uz;
  const double r = w.radius + a * w.growth, g = w.growth, g2 = 2.0 * g;
  // From the middle without the difference of two radii.
  const double more = a * g, mx = less * w.ux + sine * w.vx, my = less * w.uy + sine * w.vy,
               mz = less * w.uz + sine * w.vz;
  return {w.radius * mx + more * ox + a * w.kx - px,
          w.radius * my + more * oy + a * w.ky - py,
          w.radius * mz + more * oz + a * w.kz,
          g * ox + r * nx + w.kx,
          g * oy + r * ny + w.ky,
          g * oz + r * nz + w.kz,
          g2 * nx - r * ox,
          g2 * ny - r * oy,
          g2 * nz - r * oz};
}

/// One step of a search for the root of what grows from low to high.
struct WayStep {
  double low, high, next, moved;
};
inline WayStep wayStep(double value, double slope, double at, double low, double high) {
  const double from = value < 0.0 ? at : low, to = value < 0.0 ? high : at, newton = at - value / slope;
  const bool in = newton > from && newton < to;
  const double next = in ? newton : 0.5 * (from + to), step = newton < at ? at - newton : newton - at;
  return {from, to, next, in ? step : to - from};
}

/// Steps that count as none, rad: what they leave on the way is their square.
inline double wayStill(const proveout::WayPart& w) { return kWayStepMm / wayMost(w.speed, 1e-9); }

/// The slope of boundary + height at a place, times the boundary's own height below its middle.
struct WayRound {
  double value, slope;
};
inline WayRound wayRound(const WayAt& at, double rc, double radius2) {
  const double d = wayMost(wayRoot(at.square()), 1e-300), over = wayMost(d - rc, 0.0);
  const double q = wayRoot(radius2 - over * over), share = rc == 0.0 ? 1.0 : over / d, toward = at.toward();
  const double turns = over > 0.0 ? rc * toward * toward / (d * d * d) : 0.0;
  return {share * toward + at.vz * q,
          share * at.bend() + turns + at.az * q - at.vz * over * toward / (d * wayMost(q, 1e-300))};
}
