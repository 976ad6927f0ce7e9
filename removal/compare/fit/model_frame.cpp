#include "removal/compare/fit/model_frame.h"

#include <memory>

#include "removal/compare/features/face_fits.h"
#include "removal/compare/features/face_network.h"
#include "removal/compare/features/measured_features.h"
#include "removal/compare/features/recognition.h"
#include "removal/compare/fit/fit.h"
#include "removal/compare/sample_mesh.h"

namespace proveout {

namespace {

/// A part as it is seen from a model that lies elsewhere.
class SeenPart final : public ExactPart {
 public:
  /// `motion`: takes the model onto the part.
  SeenPart(const ExactPart& part, const RigidTransform& motion) : part_(part), motion_(motion) {}

  Sample at(const Vec3& p, double reach) const override {
    Sample out = part_.at(motion_(p), reach);
    out.normal = motion_.rotation.transpose() * out.normal;
    return out;
  }
  double accuracy() const override { return part_.accuracy(); }

 private:
  const ExactPart& part_;
  RigidTransform motion_;
};

}  // namespace

void measureInModelFrame(const TriMesh& nominal, const CadFaces& faces, const RigidTransform& motion,
                         const ExactPart& part, double spacing_mm, Comparison& comparison) {
  constexpr double kSmooth = degToRad(3.0);
  constexpr std::size_t kMostTriangles = 2'000'000;
  const RigidTransform back = motion.inverse();
  TriMesh mesh = nominal;
  moveMesh(back, mesh);
  const auto turned = std::make_shared<CadFaces>(faces);
  for (CadFace& face : turned->faces) face = face.placed(placementOf(back));
  const CadFaces& own = *turned;
  const SeenPart seen(part, motion);
  comparison.face_fits = fitFaces(makeSampleMesh(mesh, spacing_mm, kMostTriangles), own, seen);
  comparison.features = recognizeFeatures(FaceNetwork(mesh, own, kSmooth), FaceAccuracy{});
  measureFeatures(own, comparison.face_fits, seen, comparison.features);
  comparison.nominal_faces = turned;
}

}  // namespace proveout
