#include "io/exchange/zip_archive.h"

#include <minizip/unzip.h>
#include <minizip/zip.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <utility>

#include "core/base/assert.h"

namespace proveout {

/// A file in memory, as the functions of minizip see it.
struct MemoryFile {
  std::string* grown = nullptr;  ///< written; null: only read
  std::string_view bytes;        ///< read
  std::uint64_t at = 0;

  std::uint64_t size() const { return grown != nullptr ? grown->size() : bytes.size(); }
};

namespace {

constexpr uLong kZipEpoch = 0x210000;  ///< 1 January 1980, 0:00, in MS-DOS form
constexpr std::size_t kLargestZipPiece = std::size_t{1} << 30;

MemoryFile& memoryFile(voidpf stream) { return *static_cast<MemoryFile*>(stream); }

voidpf openMemory(voidpf opaque, const void*, int) { return opaque; }

uLong readMemory(voidpf, voidpf stream, void* to, uLong size) {
  MemoryFile& file = memoryFile(stream);
  if (file.at >= file.size()) return 0;
  const std::string_view all = file.grown != nullptr ? std::string_view(*file.grown) : file.bytes;
  const std::string_view piece = all.substr(static_cast<std::size_t>(file.at), size);
  std::memcpy(to, piece.data(), piece.size());
  file.at += piece.size();
  return static_cast<uLong>(piece.size());
}

uLong writeMemory(voidpf, voidpf stream, const void* from, uLong size) {
  MemoryFile& file = memoryFile(stream);
  if (file.grown == nullptr) return 0;
  const auto at = static_cast<std::size_t>(file.at);
  if (at + size > file.grown->size()) file.grown->resize(at + size);
  std::memcpy(file.grown->data() + at, from, size);
  file.at += size;
  return size;
}

ZPOS64_T tellMemory(voidpf, voidpf stream) { return memoryFile(stream).at; }

long seekMemory(voidpf, voidpf stream, ZPOS64_T offset, int origin) {
  MemoryFile& file = memoryFile(stream);
  const std::uint64_t from = origin == ZLIB_FILEFUNC_SEEK_END   ? file.size()
                             : origin == ZLIB_FILEFUNC_SEEK_CUR ? file.at
                                                                : 0;
  if (offset > file.size() - std::min(from, file.size())) return -1;
  file.at = from + offset;
  return 0;
}

int closeMemory(voidpf, voidpf) { return 0; }
int testMemory(voidpf, voidpf) { return 0; }

zlib_filefunc64_def memoryFunctions(MemoryFile& file) {
  zlib_filefunc64_def out;
  out.zopen64_file = openMemory;
  out.zread_file = readMemory;
  out.zwrite_file = writeMemory;
  out.ztell64_file = tellMemory;
  out.zseek64_file = seekMemory;
  out.zclose_file = closeMemory;
  out.zerror_file = testMemory;
  out.opaque = &file;
  return out;
}

/// Whether the bytes end with the end of an archive's directory; minizip would overlook a part of it.
bool endsAsZip(std::string_view bytes) {
  constexpr std::string_view kEnd = "PK\x05\x06";
  constexpr std::size_t kEndBytes = 22;
  const std::size_t at = bytes.rfind(kEnd);
  if (at == std::string_view::npos || bytes.size() - at < kEndBytes) return false;
  const auto low = static_cast<unsigned char>(bytes[at + 20]),
             high = static_cast<unsigned char>(bytes[at + 21]);
  return at + kEndBytes + low + 256u * high == bytes.size();
}

Error zipFailed() { return {ErrorKind::kInternal, "the archive cannot be packed"}; }

}  // namespace

struct ZipWriter::State {
  std::string bytes;
  MemoryFile file;
  zipFile zip = nullptr;
  bool open = false;
  bool failed = false;

  void note(int code) { failed = failed || code != ZIP_OK; }
  void endFile() {
    if (open) note(zipCloseFileInZip(zip));
    open = false;
  }
};

ZipWriter::ZipWriter() : state_(std::make_unique<State>()) {
  state_->file.grown = &state_->bytes;
  zlib_filefunc64_def functions = memoryFunctions(state_->file);
  state_->zip = zipOpen2_64("", APPEND_STATUS_CREATE, nullptr, &functions);
  state_->failed = state_->zip == nullptr;
}

ZipWriter::~ZipWriter() {
  if (state_->zip != nullptr) zipClose(state_->zip, nullptr);
}

void ZipWriter::begin(const std::string& name, bool large) {
  state_->endFile();
  if (state_->failed) return;
  zip_fileinfo info = {};
  info.dosDate = kZipEpoch;
  state_->note(zipOpenNewFileInZip64(state_->zip, name.c_str(), &info, nullptr, 0, nullptr, 0, nullptr,
                                     Z_DEFLATED, Z_BEST_SPEED, large ? 1 : 0));
  state_->open = !state_->failed;
}

void ZipWriter::write(std::string_view bytes) {
  while (!bytes.empty() && !state_->failed) {
    const std::string_view piece = bytes.substr(0, kLargestZipPiece);
    state_->note(zipWriteInFileInZip(state_->zip, piece.data(), static_cast<unsigned>(piece.size())));
    bytes.remove_prefix(piece.size());
  }
}

Result<std::string> ZipWriter::finish() {
  state_->endFile();
  if (state_->zip != nullptr) state_->note(zipClose(std::exchange(state_->zip, nullptr), nullptr));
  if (state_->failed) return zipFailed();
  return std::move(state_->bytes);
}

struct ZipReader::State {
  MemoryFile file;
  unzFile zip = nullptr;
  ~State() {
    if (zip != nullptr) unzClose(zip);
  }
};

ZipReader::ZipReader(std::unique_ptr<State> state) : state_(std::move(state)) {}
ZipReader::ZipReader(ZipReader&&) noexcept = default;
ZipReader::~ZipReader() = default;

Result<ZipReader> ZipReader::open(std::string_view bytes) {
  auto state = std::make_unique<State>();
  state->file.bytes = bytes;
  zlib_filefunc64_def functions = memoryFunctions(state->file);
  state->zip = unzOpen2_64("", &functions);
  if (state->zip == nullptr || !endsAsZip(bytes))
    return inputError("is no ZIP archive, as 3MF files are, or one that is cut short");
  return ZipReader(std::move(state));
}

std::int64_t ZipReader::sizeOf(const std::string& name) {
  constexpr int kAnyCase = 2;
  unz_file_info64 info;
  if (unzLocateFile(state_->zip, name.c_str(), kAnyCase) != UNZ_OK ||
      unzGetCurrentFileInfo64(state_->zip, &info, nullptr, 0, nullptr, 0, nullptr, 0) != UNZ_OK)
    return -1;
  return info.uncompressed_size > INT64_MAX ? INT64_MAX : static_cast<std::int64_t>(info.uncompressed_size);
}

Status ZipReader::read(const std::string& name, const std::function<Status(std::string_view)>& take) {
  const std::int64_t size = sizeOf(name);
  if (size < 0) return inputError("has no part '" + name + "'");
  unz_file_info64 info;
  unzGetCurrentFileInfo64(state_->zip, &info, nullptr, 0, nullptr, 0, nullptr, 0);
  if ((info.flag & 1) != 0) return inputError("'" + name + "' is encrypted");
  const Error damaged = inputError("'" + name + "' is damaged, or packed in a way that is not known");
  if (unzOpenCurrentFile(state_->zip) != UNZ_OK) return damaged;
  std::string piece(std::size_t{1} << 16, '\0');
  Status taken = Done{};
  std::int64_t done = 0;
  int count = 0;
  while (taken) {
    count = unzReadCurrentFile(state_->zip, piece.data(), static_cast<unsigned>(piece.size()));
    if (count <= 0) break;
    done += count;
    taken = take(std::string_view(piece.data(), static_cast<std::size_t>(count)));
  }
  const int closed = unzCloseCurrentFile(state_->zip);
  if (!taken) return taken;
  if (count < 0 || closed != UNZ_OK || done != size) return damaged;
  return Done{};
}

}  // namespace proveout
