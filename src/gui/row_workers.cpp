#include "gui/row_workers.h"

#include "io/scene_file.h"

#include <algorithm>
#include <chrono>
#include <cstring>
#include <iterator>
#include <type_traits>
#include <utility>

namespace raywalk {

namespace {

class Packer {
 public:
  template <class Value>
    requires std::is_trivially_copyable_v<Value>
  void put(const Value& value) {
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  void put(std::string_view text) {
    put(text.size());
    bytes_.append(text);
  }
  template <class Value>
  void put(const std::vector<Value>& values) {
    static_assert(
        std::is_standard_layout_v<Value>);  // GLM's vectors are not trivially copyable, though their bytes are
    put(std::string_view(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Value)));
  }
  [[nodiscard]] std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

class Unpacker {
 public:
  explicit Unpacker(std::string_view bytes) : bytes_(bytes) {}
  [[nodiscard]] bool at_end() const { return bytes_.empty(); }

  template <class Value>
    requires std::is_trivially_copyable_v<Value>
  [[nodiscard]] Value take() {
    Value value{};
    const std::size_t size = std::min(sizeof value, bytes_.size());
    std::memcpy(&value, bytes_.data(), size);
    bytes_.remove_prefix(size);
    return value;
  }
  [[nodiscard]] std::string_view take_text() {
    const auto size = std::min(take<std::size_t>(), bytes_.size());
    const std::string_view text = bytes_.substr(0, size);
    bytes_.remove_prefix(size);
    return text;
  }
  template <class Value>
  [[nodiscard]] std::vector<Value> take_all() {
    const std::string_view bytes = take_text();
    std::vector<Value> values(bytes.size() / sizeof(Value));
    if (!values.empty()) std::memcpy(static_cast<void*>(values.data()), bytes.data(), values.size() * sizeof(Value));
    return values;
  }

 private:
  std::string_view bytes_;
};

enum class Told : std::uint8_t { scene, rows };

constexpr int messages_ahead = 2;
constexpr double seconds_a_message = 0.016;
constexpr int most_rows = 64;

}  // namespace

std::string RowServer::answer(std::string_view message) {
  Unpacker told(message);
  const auto what = told.take<Told>();
  const auto job = told.take<std::uint64_t>();
  if (what == Told::scene) {
    const auto settings = told.take<PreviewSettings>();
    const std::string path(told.take_text());
    job_ = job;
    tracer_.reset();
    worlds_ = {};
    if (const auto document = parse_scene(told.take_text(), path)) tracer_.emplace(document->scene, settings, worlds_);
    return {};
  }
  Packer answer;
  answer.put(job);
  answer.put(tracer_.has_value());
  if (!tracer_ || job != job_) return answer.take();
  const auto begun = std::chrono::steady_clock::now();
  std::vector<TracedRow> rows;
  for (const PreviewRow& row : told.take_all<PreviewRow>()) rows.push_back(tracer_->trace(row));
  answer.put(std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count());
  for (const TracedRow& row : rows) {
    answer.put(row.of);
    answer.put(row.statistics);
    answer.put(row.shades);
    answer.put(row.costs);
  }
  return answer.take();
}

bool RowWorkers::begin(const Scene& scene, const std::string& path, const PreviewSettings& settings) {
  at_work_ = false;
  const int count = channel_.count();
  if (count == 0) return false;
  const Result<std::string> text = format_scene(scene);
  if (!text) return false;
  Packer message;
  message.put(Told::scene);
  message.put(++job_);
  message.put(settings);
  message.put(path);
  message.put(*text);
  const std::string bytes = message.take();
  workers_.resize(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    workers_[static_cast<std::size_t>(i)].seconds_a_row = seconds_a_message;  // not known: one row at first
    channel_.tell(i, bytes);
  }
  return at_work_ = true;
}

bool RowWorkers::serve(Preview& preview, bool more) {
  std::vector<TracedRow> rows;
  while (const auto heard = channel_.hear()) {
    auto some = take(heard->worker, heard->message);
    if (!some) {
      workers_.clear();
      at_work_ = false;
      return false;
    }
    std::move(some->begin(), some->end(), std::back_inserter(rows));
  }
  if (!rows.empty()) preview.take(std::move(rows));
  if (!more) return true;
  // In turns, so that all have something to do at the end.
  for (int ahead = 1; ahead <= messages_ahead; ++ahead)
    for (std::size_t i = 0; i < workers_.size(); ++i) {
      Worker& worker = workers_[i];
      if (worker.messages >= ahead) continue;
      const double wanted = std::clamp(seconds_a_message / worker.seconds_a_row, 1.0, double{most_rows});
      const std::vector<PreviewRow> next = preview.hand_out(static_cast<int>(wanted));
      if (next.empty()) return true;
      Packer message;
      message.put(Told::rows);
      message.put(job_);
      message.put(next);
      channel_.tell(static_cast<int>(i), message.take());
      ++worker.messages;
    }
  return true;
}

bool RowWorkers::waits() const {
  return at_work_ &&
         std::any_of(workers_.begin(), workers_.end(), [](const Worker& each) { return each.messages > 0; });
}

std::optional<std::vector<TracedRow>> RowWorkers::take(int worker, std::string_view answer) {
  const auto index = static_cast<std::size_t>(worker);
  if (answer.empty() || index >= workers_.size()) return std::nullopt;
  --workers_[index].messages;
  Unpacker told(answer);
  const bool of_this = told.take<std::uint64_t>() == job_;
  if (!told.take<bool>() && of_this) return std::nullopt;
  std::vector<TracedRow> rows;
  if (!of_this || told.at_end()) return rows;
  const auto seconds = told.take<double>();
  while (!told.at_end()) {
    TracedRow row;
    row.of = told.take<PreviewRow>();
    row.statistics = told.take<Statistics>();
    row.shades = told.take_all<Rgbd>();
    row.costs = told.take_all<double>();
    rows.push_back(std::move(row));
  }
  if (!rows.empty()) workers_[index].seconds_a_row = std::max(seconds / static_cast<double>(rows.size()), 1e-6);
  return rows;
}

}  // namespace raywalk
