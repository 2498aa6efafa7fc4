#include "gui/dialogs.h"

#include "gui/platform.h"
#include "gui/widgets.h"
#include "view/document/question.h"
#include "view/plan/plan_geometry.h"
#include "view/plan/plan_view.h"
#include "view/text/text.h"

#include <algorithm>

namespace raywalk {

bool asks_for_files(const State& state) {
  const auto& question = state.document.question;
  const PathPrompt prompt = state.document.prompt;
  return platform::has_file_chooser() &&
         (question ? !question->why_not.empty() : prompt == PathPrompt::open || prompt == PathPrompt::start);
}

void question_dialog(const Ui& ui) {
  if (!ui.state.document.question) return;
  const QuestionPanel question = question_panel(ui.state);
  const ImVec2 whole = ImGui::GetMainViewport()->Size;
  const float width = std::min(ui.px(520), whole.x);
  ImGui::SetNextWindowPos({whole.x / 2, whole.y * 0.45f}, 0, {0.5f, 0.5f});
  ImGui::SetNextWindowSize({width, 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ui.padding(24, 22));
  if (!ImGui::IsPopupOpen("###question")) ImGui::OpenPopup("###question");
  const bool open = ImGui::BeginPopupModal("###question", nullptr,
                                           ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove |
                                               ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoSavedSettings);
  ImGui::PopStyleVar();
  if (!open) return;
  paragraph(ui.colours.text, question.text);
  ImGui::Dummy({1, ui.px(8)});
  bool first = true;
  int number = 0;
  for (const QuestionPanel::Choice& choice : question.choices) {
    if (!first) ImGui::SameLine();
    const std::string name = "answer-" + std::to_string(number++);
    const ImVec2 extent{(width - 2 * ui.px(24) - 2 * ImGui::GetStyle().ItemSpacing.x) / 3, ui.high(38)};
    // The keys for this answer: see press_key.
    const std::string digit = std::to_string(number);
    const std::string keys = first                                     ? ui.say("keys.name_enter") + ", " + digit
                             : choice.answer == action::Answer::cancel ? "Esc, " + digit
                                                                       : digit;
    if (button(ui, name, choice.label, "", extent, {.look = first ? Look::primary : Look::plain}))
      ui.act(action::AnswerQuestion{choice.answer});
    first = false;
    // Below the button: beside the pointer, a hint would cover the next one.
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    push_font(ui.fonts.small);
    const float x = (low.x + high.x - ImGui::CalcTextSize(keys.c_str()).x) / 2;
    ImGui::GetWindowDrawList()->AddText({x, high.y + ui.px(4)}, to_imgui(ui.colours.dim_text), keys.c_str());
    pop_font();
  }
  ImGui::Dummy({1, ui.px(16)});
  if (asks_for_files(ui.state) && button(ui, "question-device", ui.say("files.from_device"), "", {}, {}))
    platform::choose_files();
  ImGui::EndPopup();
}

bool answer_by_key(const KeyPress& press, const Ui& ui) {
  const QuestionPanel question = question_panel(ui.state);
  const auto answer = [&](std::size_t i) {
    if (i >= question.choices.size()) return false;
    ui.act(action::AnswerQuestion{question.choices[i].answer});
    return true;
  };
  if (press.key == "Enter") return answer(0);
  if (press.key.size() == 1 && press.key[0] >= '1' && press.key[0] <= '9')
    return answer(static_cast<std::size_t>(press.key[0] - '1'));
  if (press.key != "Escape") return false;
  for (std::size_t i = 0; i < question.choices.size(); ++i) {
    if (question.choices[i].answer == action::Answer::cancel) return answer(i);
  }
  return false;
}

namespace {

// EYE and the lights that `notice` would cover.
int symbols_below(const Ui& ui, const Rect& plan, const Rect& notice) {
  const State& state = ui.state;
  const float reach = ui.px(16);
  const auto covers = [&](const Target& target) {
    const Vec2d at = to_pixels(state.plan.camera, state.plan.viewport, place_of(state, target, state.plan.viewport));
    const float x = plan.x + static_cast<float>(at.x) * ui.dpi, y = plan.y + static_cast<float>(at.y) * ui.dpi;
    return x > notice.x - reach && x < notice.right() + reach && y > notice.y - reach && y < notice.bottom() + reach;
  };
  int count = covers({TargetKind::eye}) ? 1 : 0;
  for (std::size_t i = 0; i < state.scene().lights.size(); ++i)
    count += covers({TargetKind::light, static_cast<int>(i)}) ? 1 : 0;
  return count;
}

}  // namespace

void notice_bar(const Ui& ui, const Rect& plan, const Rect& strip) {
  if (!ui.state.document.notice || ui.state.document.prompt != PathPrompt::none || plan.width < ui.px(80)) return;
  const bool error = ui.state.document.notice->kind == Notice::Kind::error;
  // What a finger presses reaches to the edges around it.
  const float edge = ui.high(24), beside = ui.px(ui.finger > 0 ? 0 : 12), above = ui.px(ui.finger > 0 ? 0 : 10);
  const float inset = ui.px(12), left = ui.px(16), gap = ui.px(ui.finger > 0 ? 4 : 14);
  const float most = std::min(plan.width - 2 * inset, ui.px(640)), text_most = most - left - gap - edge - beside;
  const std::string& words = ui.state.document.notice->text;
  const ImVec2 extent = ImGui::CalcTextSize(words.c_str(), nullptr, false, text_most);
  const float width = most - text_most + std::min(extent.x + 1, text_most);
  // At the top of the plan, or where it covers less: at the bottom, or on the strip below.
  const float height = std::max(extent.y + ui.px(20), edge + 2 * above);
  Rect where{plan.x + inset, plan.y + inset, width, height};
  int least = symbols_below(ui, plan, where);
  const float bottom = plan.bottom() - inset;
  // The panel may be in the plan's place, and the plan elsewhere.
  const bool adjoin = strip.x == plan.x && strip.y >= plan.bottom() - 1;
  for (const float end : {bottom, adjoin ? strip.bottom() - ui.px(2) : bottom}) {
    const Rect lower{where.x, std::max(end - height, plan.y), width, height};
    const int covered = symbols_below(ui, plan, lower);
    if (covered >= least) continue;
    least = covered;
    where = lower;
  }
  ui.publish("notice", where);
  ImGui::SetNextWindowPos(corner(where));
  ImGui::SetNextWindowSize(size(where));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  ImGui::PushStyleColor(ImGuiCol_Border,
                        to_imgui4(error ? ui.colours.error : Shades(ui.state.appearance.theme).raised_held));
  ImGui::PushStyleColor(ImGuiCol_WindowBg, to_imgui4(ui.colours.panel));
  ImGui::Begin("notice", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav);
  ImGui::PopStyleColor(2);
  ImGui::PopStyleVar();
  ImGui::SetCursorScreenPos({where.x + left, where.y + std::max((edge + 2 * above - extent.y) / 2, ui.px(10))});
  // Broken as it was measured: a word more in a line would stand under the button.
  ImGui::PushTextWrapPos(left + std::min(extent.x, text_most) + 1);
  label(error ? ui.colours.error : ui.colours.text, words);
  ImGui::PopTextWrapPos();
  ImGui::SetCursorScreenPos({where.right() - beside - edge, where.y + above});
  if (button(ui, "dismiss-notice", ui.say("dialog.close"), ui.say("dialog.close"), {edge, edge},
             {.look = Look::flat, .icon = Icon::close, .font = nullptr, .label = false}))
    ui.act(action::DismissNotice{});
  ImGui::End();
}

}  // namespace raywalk
