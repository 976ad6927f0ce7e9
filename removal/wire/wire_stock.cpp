#include "removal/wire/wire_stock.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <variant>

#include "core/mesh/shells.h"
#include "removal/wire/kerf_section.h"
#include "removal/wire/prism_mesh.h"
#include "removal/wire/wire_contacts.h"
#include "removal/wire/wire_handling.h"

namespace proveout {
namespace {

/// Of several heights the contacts of one motion are one.
void addContact(Contact contact, double z, double share, std::map<MotionId, Contact>& found) {
  contact.where.z() = z;
  contact.volume_mm3 *= share;
  const auto [known, is_new] = found.emplace(contact.motion, contact);
  if (is_new) return;
  const double volume = known->second.volume_mm3 + contact.volume_mm3;
  if (contact.depth_mm > known->second.depth_mm) known->second = contact;
  known->second.volume_mm3 = volume;
}

/// What a leaning wire does besides cutting, seen at its bottom, half way and at its top.
class LeanHandling {
 public:
  LeanHandling(const PrismBlank& blank, const Toolpath& path, const std::vector<Tool>& tools)
      : blank_(blank), path_(path), tools_(tools) {}

  void look(const WireWork& work, const WireHolding& holding, double z, double share, Progress& progress) {
    std::vector<Contact> contacts = rapidContacts(blank_, work, holding, progress);
    tellByHand(path_, contacts);
    const std::vector<ThreadingPlace> places = threadingPlaces(path_, tools_, work, contacts, z);
    for (const ThreadingFault& fault : threadingFaults(blank_, work, places, holding, progress))
      faults_.emplace(fault.next, fault);
    for (const Contact& contact : contacts) addContact(contact, z, share, contacts_);
  }

  void tell(RemovalSummary& summary) const {
    for (const auto& [motion, contact] : contacts_) summary.contacts.push_back(contact);
    for (const auto& [motion, fault] : faults_) summary.threading.push_back(fault);
  }

 private:
  const PrismBlank& blank_;
  const Toolpath& path_;
  const std::vector<Tool>& tools_;
  std::map<MotionId, Contact> contacts_;
  std::map<MotionId, ThreadingFault> faults_;
};

/// What the motions took, estimated from a section.
void addRemoved(const PrismBlank& blank, const std::vector<WireStretch>& cuts,
                const std::vector<FreePiece>& fallen, RemovalSummary& summary) {
  const std::vector<double> areas = removedAreas(blank, cuts, fallen);
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
    return inputError("start holes are for boxes, and cylinders and tubes along Z");
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
  const Status done = standsUpright(path) ? cutUpright(path, tools, &summary, progress)
                                          : cutLeaning(path, tools, tolerance, &summary, progress);
  if (!done) return done.error();
  return summary;
}

Status WireStock::cut(const Toolpath& path, const std::vector<Tool>& tools, double tolerance,
                      Progress& progress) {
  progress.report("removing", 0.0);
  return standsUpright(path) ? cutUpright(path, tools, nullptr, progress)
                             : cutLeaning(path, tools, tolerance, nullptr, progress);
}

Status WireStock::cutUpright(const Toolpath& path, const std::vector<Tool>& tools, RemovalSummary* summary,
                             Progress& progress) {
  const Result<WireWork> work = wireWork(path, tools);
  if (!work) return work.error();
  std::vector<PlaneBody> last = cutSection(blank_.loops, work->cuts);
  const WireHolding holding(blank_.held_at, blank_.loops, last);
  WireFalls falls = findFalls(blank_.loops, work->cuts, std::move(last), holding);
  if (summary != nullptr && !progress.cancelled()) {
    addRemoved(blank_, work->cuts, falls.pieces, *summary);
    summary->contacts = rapidContacts(blank_, *work, holding, progress);
    tellByHand(path, summary->contacts);
    const std::vector<ThreadingPlace> places =
        threadingPlaces(path, tools, *work, summary->contacts, blank_.z_low);
    summary->threading = threadingFaults(blank_, *work, places, holding, progress);
    summary->fallen = fallenPieces(path, *work, blank_.height(), falls.pieces);
  }
  if (progress.cancelled()) return Error{ErrorKind::kInterrupted, "interrupted"};
  setSections(std::move(falls.bodies));
  return Done{};
}

Status WireStock::cutLeaning(const Toolpath& path, const std::vector<Tool>& tools, double tolerance,
                             RemovalSummary* summary, Progress& progress) {
  const HeightSpan span{blank_.z_low, blank_.z_high};
  const Result<LeanWork> work = leanWork(path, tools, span, tolerance);
  if (!work) return work.error();
  if (summary != nullptr) handleLeaning(path, tools, *work, *summary, progress);
  if (progress.cancelled()) return Error{ErrorKind::kInterrupted, "interrupted"};
  Result<LeanSolid> solid = leanSolid(blank_.loops, span, work->cuts, tolerance, progress);
  if (!solid) return solid.error();
  setSolid(std::move(*solid));
  return Done{};
}

void WireStock::handleLeaning(const Toolpath& path, const std::vector<Tool>& tools, const LeanWork& work,
                              RemovalSummary& summary, Progress& progress) const {
  const HeightSpan span{blank_.z_low, blank_.z_high};
  LeanHandling handling(blank_, path, tools);
  const auto edge = [&](double z) {
    const WireWork level = work.atHeight(span, z);
    const WireHolding holding(blank_.held_at, blank_.loops,
                              [&] { return cutSection(blank_.loops, level.cuts); });
    handling.look(level, holding, z, 1.0 / 6.0, progress);
  };
  edge(span.low);
  const double z = span.low + 0.5 * span.length();
  const WireWork level = work.atHeight(span, z);
  std::vector<PlaneBody> last = cutSection(blank_.loops, level.cuts);
  const WireHolding holding(blank_.held_at, blank_.loops, last);
  handling.look(level, holding, z, 4.0 / 6.0, progress);
  addRemoved(blank_, level.cuts, {}, summary);
  const WireFalls falls = findFalls(blank_.loops, level.cuts, std::move(last), holding);
  summary.fallen = fallenPieces(path, level, blank_.height(), falls.pieces);
  edge(span.high);
  handling.tell(summary);
}

std::vector<PlanePolygons> WireStock::outlinesAt(double z) const {
  constexpr double kOutlineChordMm = 1e-4;
  std::vector<PlanePolygons> out(bodies_.size());
  if (z < blank_.z_low || z > blank_.z_high) return out;
  if (!solid_) {
    for (std::size_t k = 0; k < sections_.size(); ++k)
      out[k] = polygonsOf(sections_[k].loops, kOutlineChordMm);
    return out;
  }
  const std::vector<LevelSection>& levels = solid_->levels;
  const auto nearest = std::min_element(levels.begin(), levels.end(), [&](const auto& a, const auto& b) {
    return std::abs(a.z - z) < std::abs(b.z - z);
  });
  const std::vector<std::uint32_t>& body_of =
      solid_->body_of[static_cast<std::size_t>(nearest - levels.begin())];
  for (std::size_t region = 0; region < nearest->regions.size(); ++region) {
    for (const std::uint32_t loop : nearest->regions[region].loops)
      out[body_of[region]].push_back(nearest->loops[loop].points);
  }
  return out;
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
  for (const std::size_t body : bodies) append(out, solid_->bodies[body].mesh);
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
