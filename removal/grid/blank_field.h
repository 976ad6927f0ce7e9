// Blanks with a closed form: signed distance, normal and face number at a point.
#pragma once

#include <memory>
#include <optional>

#include "core/base/result.h"
#include "core/path/toolpath.h"
#include "removal/grid/leaf_bits.h"
#include "removal/grid/stock_shape.h"

namespace proveout {

struct BlankSample {
  double value;  ///< mm, negative inside; exact near the surface, never larger in magnitude than the distance
  Vec3 normal;   ///< unit, outwards
  int face;      ///< 0 to 65,535
  MotionId motion = kNoMotion;  ///< that made the face
};

class BlankField {
 public:
  virtual ~BlankField() = default;
  virtual BlankSample sample(const Vec3& p) const = 0;
  virtual double value(const Vec3& p) const { return sample(p).value; }  ///< of sample(), alone
  virtual Box3 bounds() const = 0;
  virtual double volume() const = 0;  ///< mm3

  /// Sign of the samples first + (x, y, z) * h of a leaf: true where sample() is negative.
  virtual LeafBits material(const Vec3& first, double h) const;
  /// Where the edge from `start` over `length` along `axis` meets the surface. Requires ends on different
  /// sides; `inside`: that of the start.
  struct EdgeHit {
    double t;  ///< fraction of the edge
    Vec3 normal;
    int face;                     ///< 0 to 65,535
    MotionId motion = kNoMotion;  ///< that made the face
  };
  virtual EdgeHit edgeHit(const Vec3& start, int axis, double length, bool inside) const;
  /// Whether that depends on the start's coordinate along the axis alone.
  virtual bool isLevel() const { return false; }

  /// Where a face is between the crossings. `face`: Crossing::face().
  struct FacePoint {
    Vec3 p;
    Vec3 normal;  ///< unit, out of the material
  };
  /// The point of a face, or of what goes on smoothly from it, nearest to `p`; nothing farther than `most`
  /// mm. Null where that is not known.
  virtual std::optional<FacePoint> facePoint(std::uint64_t face, const Vec3& p, double most) const;
  /// Whether a face is part of a plane, a sphere or a round cylinder.
  virtual bool isSimple(std::uint64_t face) const;
};

/// Errors: non-finite or empty shapes.
Result<std::unique_ptr<BlankField>> makeBlankField(const BoxShape& shape);
Result<std::unique_ptr<BlankField>> makeBlankField(const CylinderShape& shape);

}  // namespace proveout
