#include "io/png.h"

#include <png.h>

#include <cstddef>

#include "io/atomic_file.h"

namespace proveout {

// libpng's simplified interface reports errors by its return value; the longjmp of the full interface would
// skip destructors. It writes no time stamp, and 8-bit data as sRGB, so the bytes depend on the pixels alone.
Result<std::string> encodePng(const Image& image) {
  if (image.width <= 0 || image.height <= 0) return inputError("a picture without pixels cannot be written");
  const std::size_t expected = std::size_t{3} * image.width * image.height;
  if (image.rgb.size() != expected) return inputError("a picture's pixels do not fit its size");

  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(image.width);
  png.height = static_cast<png_uint_32>(image.height);
  png.format = PNG_FORMAT_RGB;
  // Fast: a third of the time for a tenth more bytes. Asked for its size it would encode twice.
  png.flags = PNG_IMAGE_FLAG_FAST;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
  std::string bytes(size, '\0');
  if (png_image_write_to_memory(&png, bytes.data(), &size, 0, image.rgb.data(), 0, nullptr) != 0) {
    bytes.resize(size);
    bytes.shrink_to_fit();
    return bytes;
  }
  Error error{ErrorKind::kInternal, std::string("the picture cannot be encoded: ") + png.message};
  png_image_free(&png);
  return error;
}

Status writePng(const Image& image, const std::string& path) {
  const Result<std::string> bytes = encodePng(image);
  if (!bytes) return Error{bytes.error().kind, path + ": " + bytes.error().message};
  return writeFileAtomically(path, *bytes);
}

}  // namespace proveout
