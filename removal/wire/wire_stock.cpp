#include "removal/wire/wire_stock.h"

#include <map>
#include <numeric>
#include <variant>

#include "removal/wire/kerf_section.h"
#include "removal/wire/prism_mesh.h"
#include "removal/wire/wire_contacts.h"

namespace proveout {
namespace {

/// Of several heights the contacts of one motion are one.
std::vector<Contact> contactsAtHeights(const PrismBlank& blank, const LeanWork& work, Progress& progress) {
  const HeightSpan span{blank.z_low, blank.z_high};
  std::map<MotionId, Contact> found;
  for (const double share : {0.0, 0.5, 1.0}) {
    const double z = span.low + share * span.length();
    for (Contact contact : rapidContacts(blank, work.atHeight(span, z), progress)) {
      contact.where.z() = z;
      contact.volume_mm3 *= share == 0.5 ? 4.0 / 6.0 : 1.0 / 6.0;
      const auto [known, is_new] = found.emplace(contact.motion, contact);
      if (is_new) continue;
      const double volume = known->second.volume_mm3 + contact.volume_mm3;
      if (contact.depth_mm > known->second.depth_mm) known->second = contact;
      known->second.volume_mm3 = volume;
    }
  }
  std::vector<Contact> out;
  for (const auto& [motion, contact] : found) out.push_back(contact);
  return out;
}

/// What the motions took, estimated from a section.
void addRemoved(const PrismBlank& blank, const std::vector<WireStretch>& cuts, RemovalSummary& summary) {
  const std::vector<double> areas = removedAreas(blank, cuts);
  for (std::size_t i = 0; i < areas.size(); ++i)
    summary.removed_mm3[cuts[i].motion] += static_cast<float>(areas[i] * blank.height());
}

}  // namespace

Result<PrismBlank> prismOf(const StockShape& shape) {
  PrismBlank blank;
  if (const auto* box = std::get_if<BoxShape>(&shape)) {
    blank.loops.push_back(rectangleLoop(box->min.head<2>(), box->max.head<2>()));
    blank.z_low = box->min.z();
    blank.z_high = box->max.z();
    return blank;
  }
  const auto* cylinder = std::get_if<CylinderShape>(&shape);
  if (cylinder == nullptr || cylinder->axis != 2)
    return inputError("a wire cuts boxes, and cylinders and tubes along Z: no other stock");
  blank.loops.push_back(circleLoop(cylinder->base.head<2>(), cylinder->radius, false));
  if (cylinder->inner_radius > 0.0)
    blank.loops.push_back(circleLoop(cylinder->base.head<2>(), cylinder->inner_radius, true));
  blank.z_low = cylinder->base.z();
  blank.z_high = cylinder->base.z() + cylinder->length;
  return blank;
}

WireStock::WireStock(PrismBlank blank) : blank_(std::move(blank)) {
  setSections(cutSection(blank_.loops, {}));
}

Result<RemovalSummary> WireStock::remove(const Toolpath& path, const std::vector<Tool>& tools,
                                         double tolerance, Progress& progress) {
  progress.report("removing", 0.0);
  RemovalSummary summary;
  summary.removed_mm3.assign(path.motions.size(), 0.0F);
  if (standsUpright(path)) {
    const Result<WireWork> work = wireWork(path, tools);
    if (!work) return work.error();
    addRemoved(blank_, work->cuts, summary);
    summary.contacts = rapidContacts(blank_, *work, progress);
    if (progress.cancelled()) return Error{ErrorKind::kInterrupted, "interrupted"};
    setSections(cutSection(blank_.loops, work->cuts));
    return summary;
  }
  const HeightSpan span{blank_.z_low, blank_.z_high};
  const Result<LeanWork> work = leanWork(path, tools, span, tolerance);
  if (!work) return work.error();
  addRemoved(blank_, work->atHeight(span, 0.5 * (span.low + span.high)).cuts, summary);
  summary.contacts = contactsAtHeights(blank_, *work, progress);
  Result<LeanSolid> solid = leanSolid(blank_.loops, span, work->cuts, tolerance, progress);
  if (!solid) return solid.error();
  setSolid(std::move(*solid));
  return summary;
}

void WireStock::setSections(std::vector<PlaneBody> sections) {
  sections_ = std::move(sections);
  bodies_.clear();
  for (const PlaneBody& section : sections_) {
    Box3 bounds = boundsOf(section.loops.front());
    bounds.min.z() = blank_.z_low;
    bounds.max.z() = blank_.z_high;
    bodies_.push_back({section.area_mm2 * blank_.height(), bounds});
  }
}

void WireStock::setSolid(LeanSolid solid) {
  solid_ = std::move(solid);
  sections_.clear();
  bodies_.clear();
  for (const LeanBody& body : solid_->bodies) bodies_.push_back({body.volume_mm3, meshBounds(body.mesh)});
}

TriMesh WireStock::mesh(const std::vector<std::size_t>& bodies, double tolerance) const {
  TriMesh out;
  if (!solid_) {
    std::vector<PlaneBody> sections;
    for (const std::size_t body : bodies) sections.push_back(sections_[body]);
    return prismMesh(sections, blank_.z_low, blank_.z_high, tolerance);
  }
  for (const std::size_t body : bodies) {
    const TriMesh& shell = solid_->bodies[body].mesh;
    const auto first = static_cast<std::uint32_t>(out.positions.size());
    out.positions.insert(out.positions.end(), shell.positions.begin(), shell.positions.end());
    out.motion.insert(out.motion.end(), shell.motion.begin(), shell.motion.end());
    for (const auto& [a, b, c] : shell.triangles) out.triangles.push_back({first + a, first + b, first + c});
  }
  return out;
}

BodyExit WireStock::exit(std::size_t body, std::size_t past) const {
  return solid_ ? exitOf(*solid_, body, past) : BodyExit{};
}

double WireStock::initialVolume() const { return areaOf(blank_.loops) * blank_.height(); }

double WireStock::volume() const {
  return std::accumulate(bodies_.begin(), bodies_.end(), 0.0,
                         [](double sum, const WireBody& body) { return sum + body.volume_mm3; });
}

}  // namespace proveout
