#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/math/vec.h"

namespace bspview {

/// Takes a text apart into tokens: runs of characters between white space. `#` starts a comment,
/// which ends with its line. Lines end with LF, CR LF or CR. The locale plays no part.
///
/// A read_ function takes the next token. When that is not what was asked for it returns false and
/// keeps the sentence that error() gives; nothing is read after that. `what` names the thing in
/// that sentence: "scene.nff:12: expected the radius of a sphere, found `x`".
class TokenReader {
 public:
  TokenReader(std::string_view text, std::string file_name);

  /// Takes the next token; empty at the end.
  std::string_view take();

  /// The next token, which stays.
  std::string_view peek();

  /// Whether the next token starts as a number does.
  bool number_follows();

  /// A finite float. Too small for a float is 0, too large an error.
  [[nodiscard]] bool read_float(float& value, std::string_view what);
  [[nodiscard]] bool read_vec3(Vec3& value, std::string_view what);

  /// A whole number, at least `smallest`.
  [[nodiscard]] bool read_count(std::int64_t& value, std::int64_t smallest, std::string_view what);

  /// Keeps "file:line: sentence", the line being that of the token taken last; false.
  bool fail(std::string sentence);

  /// The same, the sentence being that the token taken last is not `what` was expected.
  bool fail_expecting(std::string_view what);

  /// Of the first failure.
  const Error& error() const { return error_; }

  /// Bytes from the end of the token taken last to the end of the text.
  std::size_t bytes_left() const { return text_.size() - position_; }

 private:
  void skip_space();

  std::string_view text_;
  std::string file_name_;
  std::size_t position_ = 0;
  std::string_view token_;  // the one taken last
  Error error_;
};

}  // namespace bspview
