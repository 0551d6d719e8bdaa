#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace bspview {

/// Undo and redo of a value that is edited freely: one step per finished edit.
template <class T>
class History {
 public:
  explicit History(T value) : steps_{std::move(value)} {}

  /// Remembers `value` as a step of its own unless it is the present one. Call it whenever no edit
  /// is under way.
  void commit(const T& value) {
    if (value == steps_[present_]) return;
    steps_.resize(present_ + 1, value);
    steps_.push_back(value);
    ++present_;
  }

  bool can_undo() const { return present_ > 0; }
  bool can_redo() const { return present_ + 1 < steps_.size(); }
  const T& undo() { return steps_[present_ -= can_undo() ? 1 : 0]; }
  const T& redo() { return steps_[present_ += can_redo() ? 1 : 0]; }
  const T& present() const { return steps_[present_]; }

 private:
  std::vector<T> steps_;
  std::size_t present_ = 0;  // index into steps_
};

}  // namespace bspview
