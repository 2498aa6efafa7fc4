#pragma once
// An animation of the window for WindowExport, frame by frame.

#include "image/gif.h"
#include "view/state.h"

#include <memory>
#include <string>
#include <vector>

namespace raywalk {

class WalkAnimation {
 public:
  /// Of the walk from here: animation_positions of view/export/export.h, at the speed of AUTO.
  explicit WalkAnimation(const State& state);

  /// The position of the next frame.
  [[nodiscard]] int position() const { return positions_[next_]; }
  [[nodiscard]] std::size_t taken() const { return next_; }
  [[nodiscard]] std::size_t frames() const { return positions_.size(); }
  [[nodiscard]] int begun_at() const { return positions_.front(); }
  /// Takes the window at position(). Returns whether another frame follows; a window of another size ends the
  /// animation.
  bool take(const Image& window);
  /// Writes the frames taken so far.
  [[nodiscard]] Result<void> write(const std::string& path);

 private:
  std::vector<int> positions_;
  std::size_t next_ = 0;
  double seconds_;  ///< of a frame
  ImageSize size_{0, 0};
  std::unique_ptr<GifAnimation> gif_;
};

}  // namespace raywalk
