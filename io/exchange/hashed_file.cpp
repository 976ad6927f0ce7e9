#include "io/exchange/hashed_file.h"

namespace proveout {

Result<HashedFile> HashedFile::create(const std::string& path) {
  Result<AtomicFile> file = AtomicFile::create(path);
  if (!file) return file.error();
  return HashedFile(std::move(*file));
}

Result<std::string> HashedFile::commit() {
  if (const Status done = file_.commit(); !done) return done.error();
  return hash_.finish();
}

Result<std::string> writeHashed(const std::string& path, std::string_view bytes) {
  Result<HashedFile> file = HashedFile::create(path);
  if (!file) return file.error();
  file->write(bytes);
  return file->commit();
}

}  // namespace proveout
