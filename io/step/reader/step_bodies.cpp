#include "io/step/reader/step_bodies.h"

#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepLib.hxx>
#include <BRep_Tool.hxx>
#include <Interface_Static.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <StepShape_Face.hxx>
#include <TColStd_SequenceOfAsciiString.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Solid.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <XSAlgo.hxx>
#include <XSAlgo_AlgoContainer.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>
#include <algorithm>
#include <unordered_map>

namespace proveout::step_reader {
namespace {

std::string nameOfLabel(const TDF_Label& label) {
  Handle(TDataStd_Name) name;
  if (!label.FindAttribute(TDataStd_Name::GetID(), name)) return {};
  const TCollection_ExtendedString& text = name->Get();
  std::string out(static_cast<std::size_t>(text.LengthOfCString()) + 1, '\0');
  Standard_PCharacter into = out.data();
  out.resize(static_cast<std::size_t>(text.ToUTF8CString(into)));
  return out;
}

/// Leaves shapes as they are.
class NoRepair : public XSAlgo_AlgoContainer {
 public:
  TopoDS_Shape ProcessShape(const TopoDS_Shape& shape, Standard_Real, Standard_Real, Standard_CString,
                            Standard_CString, Handle(Standard_Transient) &, const Message_ProgressRange&,
                            Standard_Boolean) const override {
    return shape;
  }
};

}  // namespace

struct StepDocument::Impl {
  STEPCAFControl_Reader reader;
  Handle(TDocStd_Document) document;
  Handle(XCAFDoc_ShapeTool) shapes;
  Handle(XCAFDoc_ColorTool) colours;
  std::unordered_map<const void*, std::string> face_names;  ///< by TShape; those that have one

  void nameFaces();
  void gather(const TDF_Label& label, const TopLoc_Location& place, const std::string& name,
              std::vector<Body>& out) const;
  void add(const TopoDS_Shape& shape, const std::string& name, std::vector<Body>& out) const;
};

StepDocument::StepDocument(const std::string& path, Repair repair) : impl_(std::make_unique<Impl>()) {
  if (repair == Repair::kNone) XSAlgo::SetAlgoContainer(new NoRepair);
  XCAFApp_Application::GetApplication()->NewDocument("BinXCAF", impl_->document);
  impl_->reader.SetNameMode(true);
  impl_->reader.SetColorMode(true);
  Interface_Static::SetCVal("xstep.cascade.unit", "MM");
  if (impl_->reader.ReadFile(path.c_str()) != IFSelect_RetDone)
    throw Refusal{"is no STEP file that can be read: it is damaged or cut short; export it again"};
  TColStd_SequenceOfAsciiString lengths, angles, solid_angles;
  impl_->reader.ChangeReader().FileUnits(lengths, angles, solid_angles);
  if (!lengths.IsEmpty()) unit_ = lengths.First().ToCString();
  if (!impl_->reader.Transfer(impl_->document))
    throw Refusal{"holds no shape: export the part as a solid (AP203, AP214 or AP242 with its geometry)"};
  impl_->shapes = XCAFDoc_DocumentTool::ShapeTool(impl_->document->Main());
  impl_->colours = XCAFDoc_DocumentTool::ColorTool(impl_->document->Main());
  impl_->nameFaces();
}

StepDocument::~StepDocument() = default;

/// A part by its name in the assembly, and else by its own.
void StepDocument::Impl::gather(const TDF_Label& label, const TopLoc_Location& place, const std::string& name,
                                std::vector<Body>& out) const {
  if (XCAFDoc_ShapeTool::IsAssembly(label)) {
    TDF_LabelSequence components;
    XCAFDoc_ShapeTool::GetComponents(label, components);
    for (const TDF_Label& component : components) {
      TDF_Label part;
      if (!XCAFDoc_ShapeTool::GetReferredShape(component, part)) continue;
      std::string own = nameOfLabel(part);
      if (own.empty()) own = nameOfLabel(component);
      gather(part, place * XCAFDoc_ShapeTool::GetLocation(component), own, out);
    }
    return;
  }
  add(XCAFDoc_ShapeTool::GetShape(label).Moved(place), name, out);
}

void StepDocument::Impl::add(const TopoDS_Shape& shape, const std::string& name,
                             std::vector<Body>& out) const {
  const auto named = [&](const TopoDS_Shape& body, const std::string& note) {
    out.push_back({body, name, note});
  };
  TopTools_MapOfShape in_solids;
  for (TopExp_Explorer solid(shape, TopAbs_SOLID); solid.More(); solid.Next()) {
    named(solid.Current(), {});
    for (TopExp_Explorer shell(solid.Current(), TopAbs_SHELL); shell.More(); shell.Next())
      in_solids.Add(shell.Current());
  }
  for (TopExp_Explorer shell(shape, TopAbs_SHELL); shell.More(); shell.Next()) {
    if (in_solids.Contains(shell.Current()) || !BRep_Tool::IsClosed(shell.Current())) continue;
    TopoDS_Solid solid = BRepBuilderAPI_MakeSolid(TopoDS::Shell(shell.Current())).Solid();
    BRepLib::OrientClosedSolid(solid);
    named(solid, "is a closed surface and no solid in the file: it is taken as a solid");
  }
}

std::vector<Body> StepDocument::bodies() const {
  std::vector<Body> out;
  TDF_LabelSequence free;
  impl_->shapes->GetFreeShapes(free);
  for (const TDF_Label& label : free) impl_->gather(label, TopLoc_Location(), nameOfLabel(label), out);
  if (!out.empty()) return out;
  std::size_t faces = 0;
  for (const TDF_Label& label : free)
    for (TopExp_Explorer face(XCAFDoc_ShapeTool::GetShape(label), TopAbs_FACE); face.More(); face.Next())
      ++faces;
  throw Refusal{faces == 0
                    ? "has no solid: there is no face in it (wires and points bound nothing)"
                    : "has no solid: its " + std::to_string(faces) +
                          " faces leave openings; close the surface in the CAD system and export a solid"};
}

std::string StepDocument::nameOf(const TopoDS_Face& face) const {
  const auto found = impl_->face_names.find(face.TShape().get());
  return found == impl_->face_names.end() ? std::string() : found->second;
}

/// Once for all faces: to ask the library for the entity of one face takes a look at all.
void StepDocument::Impl::nameFaces() {
  const Handle(Transfer_TransientProcess) process =
      reader.Reader().WS()->TransferReader()->TransientProcess();
  for (int k = 1; k <= process->NbMapped(); ++k) {
    const Handle(StepShape_Face) entity = Handle(StepShape_Face)::DownCast(process->Mapped(k));
    if (entity.IsNull() || entity->Name().IsNull() || entity->Name()->IsEmpty()) continue;
    const TopoDS_Shape shape = TransferBRep::ShapeResult(process, entity);
    if (!shape.IsNull()) face_names.emplace(shape.TShape().get(), entity->Name()->ToCString());
  }
}

std::optional<Colour> StepDocument::colourOf(const TopoDS_Face& face, const TopoDS_Shape& body) const {
  Quantity_Color colour;
  for (const TopoDS_Shape& shape : {TopoDS_Shape(face), body}) {
    for (const XCAFDoc_ColorType type : {XCAFDoc_ColorSurf, XCAFDoc_ColorGen}) {
      for (const TopoDS_Shape& at : {shape, shape.Located(TopLoc_Location())}) {
        if (!impl_->colours->GetColor(at, type, colour)) continue;
        return Colour{static_cast<float>(colour.Red()), static_cast<float>(colour.Green()),
                      static_cast<float>(colour.Blue())};
      }
    }
  }
  return std::nullopt;
}

}  // namespace proveout::step_reader
