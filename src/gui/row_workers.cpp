#include "gui/row_workers.h"

#include "gui/packed.h"
#include "io/scene_file.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <utility>

namespace raywalk {

namespace {

enum class RowMessage : std::uint8_t { begin, trace };

constexpr int messages_ahead = 2;
constexpr double seconds_a_message = 0.016;
constexpr int most_rows = 64;

}  // namespace

std::string RowServer::answer(std::string_view message) {
  Unpacker told(message);
  const auto [kind, what, job] = told.take<MessageHead<RowMessage>>();
  if (what == RowMessage::begin) {
    const auto settings = told.take<PreviewSettings>();
    const std::string path(told.take_text());
    job_ = job;
    tracer_.reset();
    worlds_ = {};
    const auto render = told.take<RenderChoices>();
    const auto limits = told.take<TraceLimits>();
    if (auto document = parse_scene(told.take_text(), path)) {
      document->scene.render = render;
      document->scene.limits = limits;
      tracer_.emplace(document->scene, settings, worlds_);
    }
    return {};
  }
  Packer answer;
  answer.put(MessageHead{MessageKind::rows, tracer_.has_value(), job});
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
  message.put(MessageHead{MessageKind::rows, RowMessage::begin, ++job_});
  message.put(settings);
  message.put(path);
  // Not everything that is looked at is in a scene's file.
  message.put(scene.render);
  message.put(scene.limits);
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
  const auto lost = [&] {
    workers_.clear();
    return at_work_ = false;
  };
  if (channel_.count() == 0) return lost();
  while (const auto heard = channel_.hear(MessageKind::rows)) {
    auto some = take(heard->worker, heard->message);
    if (!some) return lost();
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
      message.put(MessageHead{MessageKind::rows, RowMessage::trace, job_});
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
  if (index >= workers_.size()) return std::nullopt;
  --workers_[index].messages;
  Unpacker told(answer);
  const auto [kind, known, job] = told.take<MessageHead<bool>>();
  if (!known && job == job_) return std::nullopt;
  std::vector<TracedRow> rows;
  if (job != job_ || told.at_end()) return rows;
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
