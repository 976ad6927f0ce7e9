// Text that grows at its end.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <memory>
#include <string_view>

namespace proveout {

/// For writers of many small pieces: appending a literal costs a comparison and a copy of known length.
class TextBuffer {
 public:
  using value_type = char;  ///< for std::back_inserter

  void push_back(char c) {
    *room(1) = c;
    ++size_;
  }
  /// Always inline: the length of a literal is known then.
  [[gnu::always_inline]] void append(const char* text, std::size_t count) {
    std::memcpy(room(count), text, count);
    size_ += count;
  }
  /// Space for `count` characters behind the end; `advance` takes what was written there.
  char* room(std::size_t count) {
    if (capacity_ - size_ < count) grow(count);
    return text_.get() + size_;
  }
  void advance(std::size_t count) { size_ += count; }

  std::string_view view() const { return {text_.get(), size_}; }
  std::size_t size() const { return size_; }
  void clear() { size_ = 0; }

 private:
  void grow(std::size_t count) {
    const std::size_t capacity = std::max(2 * capacity_, size_ + count + kLeast);
    auto larger = std::make_unique_for_overwrite<char[]>(capacity);
    if (size_ > 0) std::memcpy(larger.get(), text_.get(), size_);
    text_ = std::move(larger);
    capacity_ = capacity;
  }

  static constexpr std::size_t kLeast = 256;
  std::unique_ptr<char[]> text_;
  std::size_t size_ = 0, capacity_ = 0;
};

}  // namespace proveout
