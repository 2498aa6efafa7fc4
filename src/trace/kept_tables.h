#pragma once
// Tables that take a while to prepare are kept as long as they are asked for now and then.

#include <algorithm>
#include <cstddef>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace raywalk::detail {

/// The last `most` that were asked for. May be asked from any thread.
template <class Key, class Table, std::size_t most = 32>
class KeptTables {
 public:
  /// The one of a key; `make` makes it where it is not kept.
  template <class Make>
  std::shared_ptr<const Table> of(const Key& key, Make make) {
    const std::lock_guard lock(looking_);
    const auto found = std::find_if(kept_.begin(), kept_.end(), [&](const auto& one) { return one.first == key; });
    if (found != kept_.end()) {
      std::rotate(found, found + 1, kept_.end());
    } else {
      if (kept_.size() == most) kept_.erase(kept_.begin());
      kept_.emplace_back(key, make());
    }
    return kept_.back().second;
  }

 private:
  std::mutex looking_;
  std::vector<std::pair<Key, std::shared_ptr<const Table>>> kept_;  // the last asked for is the last
};

}  // namespace raywalk::detail
