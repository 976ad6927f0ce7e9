// The bodies of a STEP file, with names and colours. Only this folder sees OpenCASCADE.
#pragma once

#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace proveout::step_reader {

using Colour = std::array<float, 3>;

struct Body {
  TopoDS_Shape shape;  ///< a solid, placed as in its assembly
  std::string name;
  std::string note;  ///< what was done about it; empty: nothing
};

/// What is said about a file that cannot be used.
struct Refusal {
  std::string message;
};

/// One file while it is read. Throws Refusal.
/// What the library does with shapes as files bring them: it goes over every wire, which takes as long as all
/// the rest. Files that CAD systems write mostly need none of it.
enum class Repair { kNone, kAll };

class StepDocument {
 public:
  StepDocument(const std::string& path, Repair repair);
  ~StepDocument();
  StepDocument(const StepDocument&) = delete;

  /// Closed solids and closed shells, in the order of the file. Throws Refusal where there is none.
  std::vector<Body> bodies() const;
  const std::string& unit() const { return unit_; }
  std::string nameOf(const TopoDS_Face& face) const;
  std::optional<Colour> colourOf(const TopoDS_Face& face, const TopoDS_Shape& body) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
  std::string unit_;
};

}  // namespace proveout::step_reader
