#pragma once

#include "scene/scene.h"
#include "trace/kernel.h"

#include <algorithm>

namespace raywalk {

/// One of `of` shares of a picture that are about equally large: number `part`, from 1.
struct Share {
  int part = 1, of = 1;
  friend bool operator==(const Share&, const Share&) = default;
};

/// The rectangles of a picture that threads, or machines, take in turn: large enough that taking one is cheap, small
/// enough that all finish together.
class Tiles {
 public:
  explicit Tiles(ImageSize size) : size_(size), across_((size.width + edge - 1) / edge) {}

  [[nodiscard]] int count() const { return across_ * ((size_.height + edge - 1) / edge); }
  [[nodiscard]] PixelBlock block(int tile) const {
    const int column = tile % across_ * edge, row = tile / across_ * edge;
    return {column, std::min(column + edge, size_.width), row, std::min(row + edge, size_.height)};
  }
  /// Calls `take(block)` for each tile of a share. Each row of tiles begins elsewhere, so that no share is a column.
  template <class Take>
  void for_share(const Share& share, Take take) const {
    const int shift = std::max(share.of * 3 / 8, 1);
    for (int tile = 0; tile < count(); ++tile)
      if ((tile % across_ + tile / across_ % share.of * shift) % share.of == share.part - 1) take(block(tile));
  }
  /// Calls `take(row, first column, columns)` for each row of each of these.
  template <class Take>
  void for_rows(const Share& share, Take take) const {
    for_share(share, [&](const PixelBlock& tile) {
      for (int row = tile.row_begin; row < tile.row_end; ++row)
        take(row, tile.column_begin, tile.column_end - tile.column_begin);
    });
  }

 private:
  static constexpr int edge = 32;
  ImageSize size_;
  int across_;
};

}  // namespace raywalk
