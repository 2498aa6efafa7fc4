#include "gui/try_workers.h"

#include "gui/packed.h"
#include "io/scene_file.h"

#include <utility>

namespace raywalk {

namespace {

enum class TryMessage : std::uint8_t { begin, try_out, go_on };

constexpr double milliseconds_a_message = 30;  // an edit waits no longer

}  // namespace

std::string TryServer::answer(std::string_view message) {
  Unpacker told(message);
  const auto [kind, what, job] = told.take<MessageHead<TryMessage>>();
  if (what == TryMessage::begin) {
    const auto size = told.take<ImageSize>();
    const auto setups = told.take_all<study::Setup>();
    const std::string path(told.take_text());
    job_ = 0;
    images_told_ = 0;
    samples_told_ = 0;
    const auto document = parse_scene(told.take_text(), path);
    if (!document) return {};
    bench_.reset(document->scene, size, setups);
    job_ = job;
    return {};
  }
  if (what == TryMessage::try_out) {
    if (job == job_) bench_.try_out(told.take<study::Setup>());
    return {};
  }
  Packer answer;
  answer.put(MessageHead{MessageKind::tries, job == job_, job});
  if (job != job_) return answer.take();
  bench_.work(milliseconds_a_message);
  answer.put(bench_.floor());
  answer.put(bench_.reference_samples());
  const bool new_reference = bench_.reference_samples() != samples_told_;
  samples_told_ = bench_.reference_samples();
  answer.put(new_reference ? bench_.reference() : Image());
  // Attempts are made in their order, and so are their images.
  const auto& attempts = bench_.attempts();
  for (std::size_t i = 0; i < attempts.size(); ++i) {
    const study::Attempt& attempt = attempts[i];
    answer.put(attempt.done);
    answer.put(attempt.cost);
    answer.put(attempt.error);
    const bool is_new = attempt.done >= 1 && i >= images_told_;
    if (is_new) images_told_ = i + 1;
    answer.put(is_new ? attempt.image : Image());
  }
  return answer.take();
}

bool TryWorkers::begin(const Scene& scene, const std::string& path, ImageSize size,
                       const std::vector<study::Setup>& setups) {
  at_work_ = false;
  if (channel_.count() == 0) return false;
  const Result<std::string> text = format_scene(scene);
  if (!text) return false;
  Packer message;
  message.put(MessageHead{MessageKind::tries, TryMessage::begin, ++job_});
  message.put(size);
  message.put(setups);
  message.put(path);
  message.put(*text);
  channel_.tell(0, message.take());
  return at_work_ = true;
}

void TryWorkers::try_out(const study::Setup& setup) {
  if (!at_work_) return;
  Packer message;
  message.put(MessageHead{MessageKind::tries, TryMessage::try_out, job_});
  message.put(setup);
  channel_.tell(0, message.take());
}

bool TryWorkers::serve(study::Workbench& bench, bool more) {
  const auto lost = [&] {
    asked_ = 0;
    return at_work_ = false;
  };
  if (channel_.count() == 0) return lost();
  while (const auto heard = channel_.hear(MessageKind::tries)) {
    --asked_;
    Unpacker told(heard->message);
    const auto [kind, known, job] = told.take<MessageHead<bool>>();
    if (job != job_) continue;
    if (!known) return lost();
    study::Findings found;
    found.floor = told.take<double>();
    found.reference_samples = told.take<int>();
    found.reference = told.take_image();
    while (!told.at_end()) {
      study::Attempt& attempt = found.attempts.emplace_back();
      attempt.done = told.take<double>();
      attempt.cost = told.take<study::Cost>();
      attempt.error = told.take<double>();
      attempt.image = told.take_image();
    }
    bench.show(std::move(found));
  }
  if (!more || asked_ > 0 || bench.finished()) return true;
  Packer message;
  message.put(MessageHead{MessageKind::tries, TryMessage::go_on, job_});
  channel_.tell(0, message.take());
  ++asked_;
  return true;
}

}  // namespace raywalk
