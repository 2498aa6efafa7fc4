#include "view/ink/ink.h"

#include "math/overloaded.h"
#include "view/action.h"
#include "view/document/document.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace raywalk {

namespace {

double pixel_of(const State& state) { return 1 / state.plan.camera.pixels_per_unit; }

bool draws_nothing(const InkMark& mark) {
  return std::visit(Overloaded{
                        [](const PenStroke& stroke) { return stroke.points.empty(); },
                        [](const InkText& note) { return note.text.find_first_not_of(' ') == std::string::npos; },
                        [](const Protractor& tool) { return tool.from == tool.vertex || tool.to == tool.vertex; },
                        [](const auto& line) { return line.from == line.to; },
                    },
                    mark.shape);
}

/// Ends what is begun.
void put_down(State& state) {
  if (!state.ink.begun) return;
  InkMark mark = std::move(state.ink.begun->mark);
  state.ink.begun.reset();
  if (draws_nothing(mark)) return;
  if (auto* const stroke = std::get_if<PenStroke>(&mark.shape)) {
    const double pixel = pixel_of(state) * state.appearance.ui_scale;
    stroke->points = simplified(stroke->points, 0.3 * pixel);
    for (Vec2d& point : stroke->points) point = rounded(point, 0.1 * pixel);
    if (stroke->points.size() > most_pen_points) stroke->points.resize(most_pen_points);
  }
  Ink next = state.document.contents.ink;
  next.push_back(std::move(mark));
  commit_ink(state, std::move(next));
}

/// What is begun and cannot be ended is dropped.
void settle(State& state) {
  if (text_begun(state) != nullptr) return put_down(state);
  state.ink.begun.reset();
}

/// Erases what lies between two places.
void erase(State& state, const Vec2d& from, const Vec2d& to) {
  const auto pixels = [&](const Vec2d& at) { return to_pixels(state.plan.camera, state.plan.viewport, at); };
  const Vec2d begin = pixels(from), way = pixels(to) - begin;
  constexpr int most = 200;
  const int steps = static_cast<int>(std::min(std::ceil(length(way) / Sizes(state).reach), 1.0 * most));
  for (int i = 0; i <= steps; ++i) {
    const Vec2d at = steps == 0 ? begin : begin + static_cast<double>(i) / steps * way;
    for (int found = mark_at(state, at); found >= 0; found = mark_at(state, at)) {
      Ink next = state.document.contents.ink;
      next.erase(next.begin() + found);
      commit_ink(state, std::move(next), state.ink.erased);
      state.ink.erased = true;
    }
  }
}

/// A mark of this tool whose places are all `at`; none of the eraser.
std::optional<InkMark> begin_mark(const InkRoom& ink, const Vec2d& at) {
  switch (ink.tool) {
    case InkTool::pen:
      return InkMark{PenStroke{{at}}, ink.colour};
    case InkTool::arrow:
      return InkMark{InkArrow{at, at}, ink.colour};
    case InkTool::text:
      return InkMark{InkText{at, {}}, ink.colour};
    case InkTool::ruler:
      return InkMark{Ruler{at, at}, ink.colour};
    case InkTool::protractor:
      return InkMark{Protractor{at, at, at}, ink.colour};
    case InkTool::eraser:
      return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace

bool inks(const State& state) { return state.ink.on && state.walk.mode != Mode::help && !shows_lines(state); }

const InkText* text_begun(const State& state) {
  return state.ink.begun ? std::get_if<InkText>(&state.ink.begun->mark.shape) : nullptr;
}

std::vector<Vec2d*> places_of(InkMark& mark) {
  return std::visit(Overloaded{
                        [](Protractor& tool) { return std::vector{&tool.vertex, &tool.from, &tool.to}; },
                        [](PenStroke&) { return std::vector<Vec2d*>(); },
                        [](InkText&) { return std::vector<Vec2d*>(); },
                        [](auto& line) { return std::vector{&line.from, &line.to}; },
                    },
                    mark.shape);
}

void InkRoom::press(State& state, const Vec2d& at, const action::Modifiers& modifiers) {
  InkRoom& ink = state.ink;
  if (ink.begun && !places_of(ink.begun->mark).empty()) return lead(state, at, modifiers);  // its next place
  settle(state);
  ink.erased = false;
  ink.led = at;
  if (ink.tool == InkTool::eraser) return erase(state, at, at);
  const bool measures = ink.tool == InkTool::arrow || ink.tool == InkTool::ruler || ink.tool == InkTool::protractor;
  ink.begun = Begun{
      *begin_mark(ink, measures ? snapped(state, nullptr, at, modifiers).at : rounded(at, 0.1 * pixel_of(state)))};
}

void InkRoom::lead(State& state, const Vec2d& at, const action::Modifiers& modifiers) {
  InkRoom& ink = state.ink;
  const bool drawn = state.plan.drag && state.plan.drag->inks;
  if (!ink.begun) {
    if (drawn && ink.tool == InkTool::eraser) erase(state, std::exchange(ink.led, at), at);
    return;
  }
  if (auto* const stroke = std::get_if<PenStroke>(&ink.begun->mark.shape)) {
    const double least = pixel_of(state) * state.appearance.ui_scale;
    // Ten times what is kept, for most of them lie on a line.
    if (drawn && length(at - stroke->points.back()) >= least && stroke->points.size() < 10 * most_pen_points)
      stroke->points.push_back(at);
    return;
  }
  const std::vector<Vec2d*> places = places_of(ink.begun->mark);
  const auto next = static_cast<std::size_t>(ink.begun->placed);
  const Vec2d place = snapped(state, &*ink.begun, at, modifiers).at;
  // Those after it go along.
  for (std::size_t i = next; i < places.size(); ++i) *places[i] = place;
}

void InkRoom::lift(State& state, bool moved) {
  InkRoom& ink = state.ink;
  ink.erased = false;
  if (!ink.begun || text_begun(state) != nullptr) return;
  const std::vector<Vec2d*> places = places_of(ink.begun->mark);
  if (places.empty()) return put_down(state);
  // A click leaves the second place to the next one.
  if (std::exchange(ink.begun->fresh, false) && !moved) return;
  if (++ink.begun->placed == static_cast<int>(places.size())) put_down(state);
}

void InkRoom::drop(State& state) {
  state.ink.begun.reset();
  if (std::exchange(state.ink.erased, false)) action::Undo{}.apply(state);
}

void action::SetInk::apply(State& state) const {
  settle(state);
  state.ink.on = on;
}

void action::ChooseInkTool::apply(State& state) const {
  settle(state);
  state.ink.tool = tool;
}

void action::ChooseInkColour::apply(State& state) const {
  state.ink.colour = colour;
  if (state.ink.begun) state.ink.begun->mark.colour = colour;
}

void action::TypeInk::apply(State& state) const {
  if (text_begun(state) == nullptr) return;
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; };
  std::string line = text;
  std::erase_if(line, is_control);
  // Not within a character of UTF-8.
  std::size_t end = std::min(line.size(), longest_ink_text);
  while (end > 0 && end < line.size() && (static_cast<unsigned char>(line[end]) & 0xC0U) == 0x80U) --end;
  line.resize(end);
  std::get<InkText>(state.ink.begun->mark.shape).text = std::move(line);
}

void action::FinishInk::apply(State& state) const {
  if (text_begun(state) != nullptr) put_down(state);
}

void action::LeaveInk::apply(State& state) const {
  if (!state.ink.begun) state.ink.on = false;
  state.ink.begun.reset();
}

void action::ClearInk::apply(State& state) const {
  state.ink.begun.reset();
  commit_ink(state, {});
}

void action::KeepInk::apply(State& state) const { keep_ink(state, kept); }

}  // namespace raywalk
