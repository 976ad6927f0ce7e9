// PLY, ASCII and binary of either byte order.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include "io/mesh_formats.h"

namespace proveout::mesh_formats {

namespace {

enum class Scalar : std::uint8_t { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kFloat32, kFloat64 };

struct ScalarName {
  std::string_view name;
  Scalar type;
};
constexpr std::array<ScalarName, 16> kScalarNames = {{{"char", Scalar::kInt8},
                                                      {"int8", Scalar::kInt8},
                                                      {"uchar", Scalar::kUint8},
                                                      {"uint8", Scalar::kUint8},
                                                      {"short", Scalar::kInt16},
                                                      {"int16", Scalar::kInt16},
                                                      {"ushort", Scalar::kUint16},
                                                      {"uint16", Scalar::kUint16},
                                                      {"int", Scalar::kInt32},
                                                      {"int32", Scalar::kInt32},
                                                      {"uint", Scalar::kUint32},
                                                      {"uint32", Scalar::kUint32},
                                                      {"float", Scalar::kFloat32},
                                                      {"float32", Scalar::kFloat32},
                                                      {"double", Scalar::kFloat64},
                                                      {"float64", Scalar::kFloat64}}};

std::optional<Scalar> scalarOf(std::string_view name) {
  for (const ScalarName& entry : kScalarNames) {
    if (entry.name == name) return entry.type;
  }
  return std::nullopt;
}

std::size_t sizeOf(Scalar type) {
  constexpr std::array<std::size_t, 8> kSizes = {1, 1, 2, 2, 4, 4, 4, 8};
  return kSizes[static_cast<std::size_t>(type)];
}

struct Property {
  std::string name;
  bool list = false;
  Scalar count = Scalar::kUint8;  ///< of a list
  Scalar type = Scalar::kFloat32;
};

struct Element {
  std::string name;
  std::uint64_t count = 0;
  std::vector<Property> properties;

  int find(std::string_view wanted) const {
    for (std::size_t i = 0; i < properties.size(); ++i) {
      if (properties[i].name == wanted) return static_cast<int>(i);
    }
    return -1;
  }
  /// Fewest bytes that an entry takes.
  std::size_t minimumSize(bool ascii) const {
    std::size_t size = 0;
    for (const Property& p : properties) size += ascii ? 2 : sizeOf(p.list ? p.count : p.type);
    return size;
  }
};

enum class Encoding : std::uint8_t { kAscii, kLittle, kBig };

struct Header {
  Encoding encoding = Encoding::kAscii;
  std::vector<Element> elements;
  std::size_t size = 0;  ///< bytes up to the data
  int lines = 0;         ///< up to the data
};

class HeaderReader {
 public:
  explicit HeaderReader(std::string_view bytes) : scanner_(bytes), bytes_(bytes) {}

  Result<Header> read() {
    if (scanner_.wordInLine() != "ply") return inputError("is no PLY file: it does not begin with 'ply'");
    bool format_known = false;
    for (scanner_.skipLine(); !scanner_.atEnd(); scanner_.skipLine()) {
      const std::string_view word = scanner_.wordInLine();
      if (word == "end_header") {
        scanner_.skipLine();
        header_.size = bytes_.size() - scanner_.rest().size();
        header_.lines = scanner_.line();
        if (!format_known) return inputError("its header states no format");
        return header_;
      }
      if (word == "format") format_known = true;
      const std::string error = readLine(word);
      if (!error.empty()) return inputError(fmt::format("line {}: {}", scanner_.line(), error));
    }
    return inputError("is cut short: its header has no end");
  }

 private:
  std::string readLine(std::string_view word) {
    if (word == "comment" || word == "obj_info" || word.empty()) return {};
    if (word == "format") return readFormat();
    if (word == "element") return readElement();
    if (word == "property") return readProperty();
    return fmt::format("'{}' is not known in a header", word.substr(0, 32));
  }

  std::string readFormat() {
    const std::string_view name = scanner_.wordInLine();
    if (name == "ascii") {
      header_.encoding = Encoding::kAscii;
    } else if (name == "binary_little_endian") {
      header_.encoding = Encoding::kLittle;
    } else if (name == "binary_big_endian") {
      header_.encoding = Encoding::kBig;
    } else {
      return fmt::format("format '{}' is not known", name.substr(0, 32));
    }
    return scanner_.wordInLine() == "1.0" ? "" : "the format's version must be 1.0";
  }

  std::string readElement() {
    Element element;
    element.name = scanner_.wordInLine();
    const std::string_view digits = scanner_.wordInLine();
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), element.count);
    const bool good = error == std::errc{} && end == digits.data() + digits.size() && !digits.empty();
    if (!good || element.name.empty()) return "an element has a name and a count";
    header_.elements.push_back(std::move(element));
    return {};
  }

  std::string readProperty() {
    if (header_.elements.empty()) return "a property before the first element";
    Property property;
    std::string_view type = scanner_.wordInLine();
    if (type == "list") {
      property.list = true;
      const auto count = scalarOf(scanner_.wordInLine());
      if (!count || *count == Scalar::kFloat32 || *count == Scalar::kFloat64) {
        return "a list's count must be a whole number type";
      }
      property.count = *count;
      type = scanner_.wordInLine();
    }
    const auto scalar = scalarOf(type);
    if (!scalar) return fmt::format("type '{}' is not known", type.substr(0, 32));
    property.type = *scalar;
    property.name = scanner_.wordInLine();
    if (property.name.empty()) return "a property has a type and a name";
    header_.elements.back().properties.push_back(std::move(property));
    return {};
  }

  TextScanner scanner_;
  std::string_view bytes_;
  Header header_;
};

/// Takes numbers off the data, whatever the encoding.
class DataReader {
 public:
  DataReader(std::string_view data, Encoding encoding) : data_(data), scanner_(data), encoding_(encoding) {}

  /// None: the data ends, or is no number.
  std::optional<double> number(Scalar type) {
    if (encoding_ == Encoding::kAscii) return parseReal(scanner_.word());
    const std::size_t size = sizeOf(type);
    if (data_.size() < size) return std::nullopt;
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < size; ++i) {
      const std::size_t at = encoding_ == Encoding::kLittle ? size - 1 - i : i;
      bits = bits << 8 | static_cast<unsigned char>(data_[at]);
    }
    data_.remove_prefix(size);
    return decode(type, bits);
  }
  std::size_t bytesLeft() const {
    return encoding_ == Encoding::kAscii ? scanner_.rest().size() : data_.size();
  }
  /// Numbers of a text that stand behind those read, in the same line; none in binary data.
  std::size_t skipRestOfLine() {
    std::size_t words = 0;
    if (encoding_ == Encoding::kAscii) {
      while (!scanner_.wordInLine().empty()) ++words;
    }
    return words;
  }
  int line() const { return scanner_.line(); }  ///< of a text's data, from 1
  /// Only blanks may stand behind the last element of a text.
  bool finished() { return encoding_ == Encoding::kAscii ? scanner_.word().empty() : data_.empty(); }

 private:
  static double decode(Scalar type, std::uint64_t bits) {
    switch (type) {
      case Scalar::kInt8:
        return static_cast<std::int8_t>(bits);
      case Scalar::kInt16:
        return static_cast<std::int16_t>(bits);
      case Scalar::kInt32:
        return static_cast<std::int32_t>(bits);
      case Scalar::kFloat32:
        return std::bit_cast<float>(static_cast<std::uint32_t>(bits));
      case Scalar::kFloat64:
        return std::bit_cast<double>(bits);
      case Scalar::kUint8:
      case Scalar::kUint16:
      case Scalar::kUint32:
        break;
    }
    return static_cast<double>(bits);
  }

  std::string_view data_;
  TextScanner scanner_;
  Encoding encoding_;
};

/// Values of one entry: scalars by property, and the list that was asked for.
struct Row {
  std::vector<double> scalars;
  std::vector<double> list;
};

class PlyReader {
 public:
  PlyReader(const Header& header, std::string_view data, MeshBuilder& out)
      : header_(header), data_(data, header.encoding), out_(out) {}

  Status read() {
    for (const Element& element : header_.elements) {
      const std::string error = readElement(element);
      if (!error.empty()) return inputError(error);
    }
    if (!data_.finished()) return inputError("has more data than its header counts");
    return Done{};
  }

 private:
  std::string readElement(const Element& element) {
    if (element.count == 0) return {};
    const std::size_t smallest = element.minimumSize(header_.encoding == Encoding::kAscii);
    if (smallest == 0) return fmt::format("element '{}' has no properties", element.name);
    // Before any memory is taken: a text's last number has no blank behind it, hence the one more.
    if (element.count > (data_.bytesLeft() + 1) / smallest) {
      return fmt::format("is cut short: its header counts {} entries of '{}', more than the file can hold",
                         element.count, element.name);
    }
    if (element.name == "vertex") return readVertices(element);
    if (element.name == "face") return readFaces(element);
    if (element.name == "edge") return "has edges: points and lines are not a surface";
    if (element.name == "tristrips") return "has triangle strips, which are not supported";
    return skip(element);
  }

  /// Reads one entry; `list` is the property whose list is kept, or -1. Returns what is wrong, or "".
  std::string readEntry(const Element& element, std::uint64_t index, int list, Row& row) {
    if (!readRow(element, list, row)) {
      return fmt::format("is cut short or damaged at {} {} of {}", element.name, index + 1, element.count);
    }
    // Whoever reads on would take them for the next entry.
    const std::size_t extra = data_.skipRestOfLine();
    if (extra == 0) return {};
    return fmt::format(
        "line {}: {} extra number{} behind {} {}: the line has more values than the header declares "
        "for a {}; export the mesh again, as binary PLY or without colours and texture",
        header_.lines + data_.line() - 1, extra, extra == 1 ? "" : "s", element.name, index + 1,
        element.name);
  }

  /// False: cut short or no number.
  bool readRow(const Element& element, int list, Row& row) {
    row.scalars.assign(element.properties.size(), 0.0);
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      const Property& property = element.properties[i];
      const auto value = data_.number(property.list ? property.count : property.type);
      if (!value) return false;
      row.scalars[i] = *value;
      if (property.list && !readList(property, *value, static_cast<int>(i) == list ? &row.list : nullptr))
        return false;
    }
    return true;
  }

  bool readList(const Property& property, double count, std::vector<double>* keep) {
    const bool possible =
        count >= 0.0 && count <= static_cast<double>(data_.bytesLeft()) && std::floor(count) == count;
    if (!possible) return false;
    if (keep != nullptr) keep->clear();
    for (auto left = static_cast<std::uint64_t>(count); left > 0; --left) {
      const auto value = data_.number(property.type);
      if (!value) return false;
      if (keep != nullptr) keep->push_back(*value);
    }
    return true;
  }

  std::string skip(const Element& element) {
    Row row;
    for (std::uint64_t i = 0; i < element.count; ++i) {
      std::string error = readEntry(element, i, -1, row);
      if (!error.empty()) return error;
    }
    return {};
  }

  std::string readVertices(const Element& element) {
    std::array<int, 3> at{};
    for (int k = 0; k < 3; ++k) {
      at[k] = element.find(std::string_view("xyz").substr(k, 1));
      if (at[k] < 0 || element.properties[at[k]].list) return "its vertices have no x, y and z";
    }
    if (!out_.mesh.positions.empty()) return "has two elements 'vertex'";
    if (element.count >= 0xFFFFFFFEu) return "has too many vertices";
    out_.mesh.positions.reserve(element.count);
    Row row;
    for (std::uint64_t i = 0; i < element.count; ++i) {
      std::string error = readEntry(element, i, -1, row);
      if (!error.empty()) return error;
      if (!out_.addPosition(row.scalars[at[0]], row.scalars[at[1]], row.scalars[at[2]])) {
        return fmt::format("vertex {} has a coordinate that is not a finite number", i + 1);
      }
    }
    return {};
  }

  std::string readFaces(const Element& element) {
    int list = element.find("vertex_indices");
    if (list < 0) list = element.find("vertex_index");
    if (list < 0 || !element.properties[list].list) return "its faces have no list of vertex indices";
    const int motion = element.find("motion");
    const bool has_motion =
        motion >= 0 && !element.properties[motion].list && element.properties[motion].type == Scalar::kUint32;
    out_.mesh.triangles.reserve(out_.mesh.triangles.size() + element.count);
    Row row;
    for (std::uint64_t i = 0; i < element.count; ++i) {
      std::string error = readEntry(element, i, list, row);
      if (!error.empty()) return error;
      error = addFace(row.list);
      if (!error.empty()) return fmt::format("face {}: {}", i + 1, error);
      if (has_motion) {
        out_.mesh.motion.resize(out_.mesh.triangles.size(), static_cast<std::uint32_t>(row.scalars[motion]));
      }
    }
    return {};
  }

  std::string addFace(const std::vector<double>& indices) {
    corners_.clear();
    for (const double index : indices) {
      const bool good = index >= 0.0 && index < static_cast<double>(out_.mesh.positions.size()) &&
                        std::floor(index) == index;
      if (!good) return fmt::format("{} is no vertex of this file", index);
      corners_.push_back(static_cast<std::uint32_t>(index));
    }
    return out_.addPolygon(corners_);
  }

  const Header& header_;
  DataReader data_;
  MeshBuilder& out_;
  std::vector<std::uint32_t> corners_;
};

}  // namespace

Status readPly(std::string_view bytes, MeshBuilder& out) {
  const Result<Header> header = HeaderReader(bytes).read();
  if (!header) return header.error();
  return PlyReader(*header, bytes.substr(header->size), out).read();
}

}  // namespace proveout::mesh_formats
