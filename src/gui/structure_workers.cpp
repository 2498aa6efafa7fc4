#include "gui/structure_workers.h"

#include "gui/packed.h"
#include "io/scene_file.h"
#include "view/structure/structure.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace raywalk {

namespace {

enum class StructureMessage : std::uint8_t { begin, build, search };

constexpr double longest_hold = 0.035;  // seconds

/// A step of a build without its parts: all that has one size.
struct StepValues {
  BuildStep::Kind kind;
  Bounds<double> box;
  int depth, items, axis;
  double plane, split_cost, leaf_cost;
  LeafReason why;
  std::array<int, 3> cells;
  int primitive;
  std::size_t parts;
};

void put_build(Packer& packer, const WatchedBuild& build) {
  std::vector<StepValues> steps;
  std::vector<BuildStep::Part> parts;
  for (const BuildStep& step : build.steps) {
    steps.push_back({step.kind, step.box, step.depth, step.items, step.axis, step.plane, step.split_cost,
                     step.leaf_cost, step.why, step.cells, step.primitive, step.parts.size()});
    parts.insert(parts.end(), step.parts.begin(), step.parts.end());
  }
  packer.put(steps);
  packer.put(parts);
  packer.put(build.complete);
  packer.put(build.nodes);
  packer.put(build.statistics);
}

WatchedBuild take_build(Unpacker& told) {
  WatchedBuild build;
  const auto steps = told.take_all<StepValues>();
  const auto parts = told.take_all<BuildStep::Part>();
  auto part = parts.begin();
  for (const StepValues& step : steps) {
    const auto end = part + std::min<std::ptrdiff_t>(static_cast<std::ptrdiff_t>(step.parts), parts.end() - part);
    build.steps.push_back({step.kind,
                           step.box,
                           step.depth,
                           step.items,
                           step.axis,
                           step.plane,
                           step.split_cost,
                           step.leaf_cost,
                           step.why,
                           step.cells,
                           step.primitive,
                           {part, end}});
    part = end;
  }
  build.complete = told.take<bool>();
  build.nodes = told.take_all<StructureNode>();
  build.statistics = told.take<AcceleratorStatistics>();
  return build;
}

void put_searches(Packer& packer, const WatchedSearches& searches) {
  for (const WatchedSearch& search : searches) {
    packer.put(search.events);
    packer.put(search.complete);
    packer.put(search.counts);
    packer.put(search.t);
    packer.put(search.primitive);
  }
}

WatchedSearches take_searches(Unpacker& told) {
  WatchedSearches searches;
  for (WatchedSearch& search : searches) {
    search.events = told.take_all<SearchEvent>();
    search.complete = told.take<bool>();
    search.counts = told.take<TestCounts>();
    search.t = told.take<std::optional<double>>();
    search.primitive = told.take<int>();
  }
  return searches;
}

void put_ray(Packer& packer, const AnySearchedRay& any) {
  packer.put(any.index());
  std::visit([&]<class T>(const SearchedRay<T>& ray) { packer.put(std::vector<SearchedRay<T>>{ray}); }, any);
}

template <class T>
SearchedRay<T> one_ray(Unpacker& told) {
  const auto rays = told.take_all<SearchedRay<T>>();
  return rays.empty() ? SearchedRay<T>{} : rays.front();
}

AnySearchedRay take_ray(Unpacker& told) {
  if (told.take<std::size_t>() == 0) return one_ray<float>(told);
  return one_ray<double>(told);
}

}  // namespace

std::string StructureServer::answer(std::string_view message) {
  Unpacker told(message);
  const auto [kind, what, job] = told.take<MessageHead<StructureMessage>>();
  if (what == StructureMessage::begin) {
    const auto precision = told.take<Precision>();
    const std::string path(told.take_text());
    const auto render = told.take<RenderChoices>();
    const auto limits = told.take<TraceLimits>();
    job_ = job;
    structures_.reset();
    worlds_ = {};
    if (auto document = parse_scene(told.take_text(), path)) {
      document->scene.render = render;
      document->scene.limits = limits;
      structures_.emplace(document->scene, precision, worlds_);
    }
    return {};
  }
  Packer answer;
  answer.put(MessageHead{MessageKind::structures, structures_.has_value(), job});
  if (!structures_ || job != job_) return answer.take();
  answer.put(what);
  if (what == StructureMessage::build)
    put_build(answer, structures_->build(told.take<std::size_t>()));
  else
    put_searches(answer, structures_->search(take_ray(told)));
  return answer.take();
}

std::optional<std::string> StructureWorkers::described(const State& state) const {
  const SceneSeen scene = walked_scene(state);
  const Result<std::string> text = format_scene(*scene);
  if (!text) return std::nullopt;
  Packer told;
  told.put(state.structure.walks->precision());
  told.put(state.document.contents.path);
  // Not everything that is looked at is in a scene's file.
  told.put(scene->render);
  told.put(scene->limits);
  told.put(*text);
  return told.take();
}

void StructureWorkers::tell(std::string message) {
  channel_.tell(channel_.count() - 1, std::move(message));  // the last: the first has the Cost panel's tries
}

bool StructureWorkers::do_it_here(State& state) {
  building_ = false;
  asked_.reset();
  timeline_.reset();
  scene_.clear();
  state.structure.most_here = std::numeric_limits<int>::max();
  state.structure.walks.reset();
  StructureRoom::follow(state, {});
  return true;
}

bool StructureWorkers::serve(State& state) {
  StructureRoom& room = state.structure;
  const bool there_are_any = channel_.count() > 0;
  bool shown = false;
  while (const auto heard = channel_.hear(MessageKind::structures)) shown = take(state, heard->message) || shown;
  if (!room.walks || !room.walks->elsewhere()) {
    room.most_here = there_are_any ? most_here : std::numeric_limits<int>::max();
    return shown;
  }
  if (!there_are_any) return do_it_here(state);
  if (room.walks->timeline() != timeline_) {
    const auto scene = described(state);
    if (!scene) return do_it_here(state);
    timeline_ = room.walks->timeline();
    if (*scene != scene_) {
      scene_ = *scene;
      Packer head;
      head.put(MessageHead{MessageKind::structures, StructureMessage::begin, ++job_});
      tell(head.take() + scene_);
      built_ = 0;
      building_ = false;
      asked_.reset();
    }
  }
  if (room.walks->waits() && built_ == watched_count) {
    show_walks(state, room.walks->take(builds_));
    shown = true;
  }
  return ask(state) || shown;
}

// True if there is nothing to ask for after all, which is shown.
bool StructureWorkers::ask(State& state) {
  const StructureRoom& room = state.structure;
  if (building_ || asked_) return false;
  Packer message;
  if (built_ < watched_count) {
    message.put(MessageHead{MessageKind::structures, StructureMessage::build, job_});
    message.put(built_);
    building_ = true;
    tell(message.take());
    return false;
  }
  if (!room.awaited) return false;
  const auto ray = room.walks->searched(room.awaited->ray);
  if (!ray) {
    show_searches(state, nullptr);
    return true;
  }
  message.put(MessageHead{MessageKind::structures, StructureMessage::search, job_});
  put_ray(message, *ray);
  asked_ = Asked{room.walks->timeline(), room.awaited->ray, *ray, std::chrono::steady_clock::now()};
  tell(message.take());
  return false;
}

bool StructureWorkers::take(State& state, std::string_view answer) {
  Unpacker told(answer);
  const auto [kind, known, job] = told.take<MessageHead<bool>>();
  if (job != job_) return false;
  if (!known) return do_it_here(state);
  const StructureRoom& room = state.structure;
  if (told.take<StructureMessage>() == StructureMessage::build) {
    builds_[built_++] = take_build(told);
    building_ = false;
    return false;
  }
  const auto asked = std::exchange(asked_, std::nullopt);
  if (!asked || !room.walks || room.walks->timeline() != asked->timeline) return false;
  if (!room.awaited || room.awaited->ray != asked->ray) return false;
  show_searches(state, room.walks->found(asked->ray, asked->searched, take_searches(told)));
  return true;
}

double StructureWorkers::patience() const {
  if (!asked_) return 0;
  const std::chrono::duration<double> waited = std::chrono::steady_clock::now() - asked_->at;
  return std::max(0.0, longest_hold - waited.count());
}

}  // namespace raywalk
