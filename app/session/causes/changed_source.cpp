#include "app/session/causes/changed_source.h"

#include <utility>

#include "core/nc/text/source_text.h"

namespace proveout {

ChangedSource::ChangedSource(const ProgramSource& inner, TextEncoding encoding, TextChange change)
    : inner_(inner), encoding_(encoding), change_(std::move(change)) {}

Result<ProgramText> ChangedSource::changed(Result<ProgramText> text) const {
  if (!text) return text;
  const Result<std::string> utf8 = nc::decodeText(text->bytes, encoding_);
  if (!utf8) return utf8.error();
  text->bytes = *utf8;
  if (text->name != change_.file) return text;
  const nc::SourceText source(text->name, text->path, *utf8);
  std::string out;
  for (std::size_t k = 0; k < source.lines().size(); ++k) {
    std::string line(source.lines()[k]);
    if (k + 1 == change_.line && change_.begin >= 1 && change_.begin - 1 + change_.length <= line.size())
      line.replace(change_.begin - 1, change_.length, change_.text);
    out += line + '\n';
  }
  text->bytes = std::move(out);
  return text;
}

}  // namespace proveout
