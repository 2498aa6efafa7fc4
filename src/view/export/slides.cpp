#include "view/export/slides.h"

#include "text/markup.h"
#include "view/drawing/svg.h"
#include "view/plan/plan_view.h"
#include "view/text/shown.h"
#include "view/text/text.h"
#include "view/walk/equation.h"
#include "view/walk/status.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>
#include <optional>

namespace raywalk {

namespace {

using Json = nlohmann::json;

constexpr Viewport picture_size{960, 640};
constexpr Viewport page_size{750, 500};  // smaller, so that letters are larger at the same width

State walked(const Scene& scene, std::shared_ptr<const Timeline> timeline, Language language, Theme theme,
             const Viewport& viewport, const Ink& ink, bool english_code = false) {
  SceneDocument document;
  document.scene = scene;
  document.ink = ink;
  State state = make_state(std::move(document));
  state.walk.timeline = std::move(timeline);
  state.walk.mode = Mode::trace;
  state.appearance.theme = theme;
  state.appearance.language = language;
  state.appearance.english_code = english_code;
  state.appearance.tab = EquationRoom::tab;
  state.plan.viewport = viewport;
  state.plan.camera = fitted(state);
  return state;
}

/// String interning: most of what one step draws was there before.
class Dictionary {
 public:
  int number_of(std::string text) {
    const auto [at, is_new] = numbers_.try_emplace(std::move(text), static_cast<int>(texts_.size()));
    if (is_new) texts_.push_back(at->first);
    return at->second;
  }
  [[nodiscard]] const Json& texts() const { return texts_; }

 private:
  std::map<std::string, int> numbers_;
  Json texts_ = Json::array();
};

/// The plan of each step as the numbers of its items. Most of them the step before has drawn too, in the same order: a
/// run of those is written [first, count]. Else long walks would grow with the square of their steps.
class PlanWriter {
 public:
  static constexpr int complete_every = 100;  ///< steps, so that a page that jumps has few to go through

  Json next(DisplayList list, bool complete) {
    if (complete) before_.clear();
    std::vector<int> numbers;
    numbers.reserve(list.size());
    Json items = Json::array();
    std::size_t run = 0, end = 0;  // of the list before
    const auto end_run = [&](std::size_t from) {
      if (run < end) items.push_back({run, end - run});
      run = end = from;
    };
    for (const DisplayItem& item : list) {
      const std::size_t same = find(item, end);
      if (same == before_.size()) {
        end_run(end);
        numbers.push_back(drawn_.number_of(svg_element(item.shape)));
        items.push_back(numbers.back());
      } else {
        if (same != end) end_run(same);
        numbers.push_back(numbers_[same]);
        end = same + 1;
      }
    }
    end_run(end);
    before_ = std::move(list);
    numbers_ = std::move(numbers);
    return items;
  }
  [[nodiscard]] const Json& texts() const { return drawn_.texts(); }

 private:
  /// The same item in the list before, shortly after `from`; the end of the list if there is none.
  [[nodiscard]] std::size_t find(const DisplayItem& item, std::size_t from) const {
    constexpr std::size_t reach = 16;
    for (std::size_t i = from; i < std::min(from + reach, before_.size()); ++i)
      if (before_[i].shape == item.shape) return i;
    return before_.size();
  }

  Dictionary drawn_;
  DisplayList before_;
  std::vector<int> numbers_;  ///< of before_
};

Json slide(const State& state, PlanWriter& plan, Dictionary& said) {
  Json equation = Json::array();
  for (const EquationRow& row : equation_panel(state).rows) {
    const std::string colour = row.light ? fmt::format("<i style=\"background:{}\"></i>",
                                                       css_colour(display_colour(*row.light, state.scene().encoding)))
                                         : std::string();
    const bool plain = row.kind == EquationRow::Kind::formula || row.kind == EquationRow::Kind::note;
    equation.push_back(
        said.number_of(fmt::format("<p{}>{}{}</p>", plain ? " class=\"dim\"" : "", colour, escaped(row.text))));
  }
  const Event* ran = state.walk.timeline->just_run(state.walk.position);
  const Event* next = state.walk.timeline->next(state.walk.position);
  return {{"d", plan.next(plan_view(state), state.walk.position % PlanWriter::complete_every == 0)},
          {"e", std::move(equation)},
          {"s", said.number_of(escaped(sentence(state)))},
          {"r", ran == nullptr ? -1 : static_cast<int>(ran->line)},
          {"n", next == nullptr ? -1 : static_cast<int>(next->line)},
          {"l", ran == nullptr ? 0 : ran->depth}};
}

/// All procedures: the page marks lines of each, whichever runs.
std::string code_of(const State& state) {
  const Language language = state.appearance.code_language();
  std::string html;
  std::optional<Procedure> open;
  for (const PseudocodeLine& line : state.walk.timeline->pseudocode().lines) {
    if (!state.walk.timeline->walks(line.line)) continue;
    if (open != line.procedure) {
      html += fmt::format("{}<section><h2>{}</h2><ol>", open ? "</ol></section>" : "",
                          escaped(text(line.procedure, language)));
      open = line.procedure;
    }
    html += fmt::format("<li id=\"l{}\" style=\"padding-left:{}em\">{}</li>", static_cast<int>(line.line),
                        0.4 + 1.4 * line.indent, escaped(text(line.line, language)));
  }
  return html + (open ? "</ol></section>" : "");
}

/// Samples of the kinds of rays, with their names.
std::string legend_of(const State& state) {
  std::string html = "<ul id=\"legend\">";
  for (const RayKind kind : values_of<RayKind>) {
    if (kind == RayKind::photon && !state.walk.timeline->of_photons()) continue;
    if (kind == (state.walk.timeline->has_width() ? RayKind::primary : RayKind::beam)) continue;
    if (kind != RayKind::primary && state.walk.timeline->of_radiosity()) continue;
    const RayStyle& style = ray_style(state.appearance.theme, kind);
    const LineItem line{{1, 6}, {45, 6}, Stroke{style.colour, 2.5, style.dash, 0}, 9};
    html += fmt::format("<li><svg viewBox=\"0 0 46 12\">{}</svg>{}</li>", svg_element(line),
                        escaped(kind_name(state, kind)));
  }
  return html + "</ul>\n";
}

/// The page fills its window and never scrolls as a whole: its letters, in rem, grow with the window, and the picture
/// takes what the sentence and the buttons leave.
std::string style_of(const Palette& colours) {
  return fmt::format(
      "html{{font-size:clamp(9px,min(1.3vw,2.1vh),48px)}}"
      "body{{box-sizing:border-box;margin:0;padding:.7rem;height:100vh;height:100dvh;display:flex;flex-direction:"
      "column;"
      "overflow:hidden;background:{0};color:{1};font:1rem Inter,Helvetica,Arial,sans-serif}}"
      "main{{flex:1;min-height:0;display:grid;grid-template:minmax(0,1fr)/minmax(0,1fr) minmax(24rem,32%);gap:1rem}}"
      "#walk{{display:flex;flex-direction:column;min-height:0}}"
      "#picture{{flex:1;min-height:0;width:100%;background:{2};border-radius:6px}}"
      "#beside{{display:flex;flex-direction:column;min-height:0;overflow:auto}}"
      "ol,ul{{list-style:none;margin:0;padding:0}}"
      "ol{{font:.85rem 'JetBrains Mono',Menlo,Consolas,monospace}}"
      "ol li{{padding:.1em .4em;border:2px solid transparent;border-radius:4px;white-space:pre}}"
      "li.ran{{background:{3};font-weight:bold}}li.next{{border-color:{4}}}"
      "#legend{{display:flex;flex-wrap:wrap;gap:.2rem 1.4rem;padding:.5rem .2rem;font-size:.9rem}}"
      "#legend svg{{width:3.2rem;height:.8rem;margin-right:.5rem;vertical-align:-.05em}}"
      "h1{{font-size:1.25rem;margin:0 0 .5rem;white-space:nowrap;overflow:hidden;text-overflow:ellipsis}}"
      "h2{{font-size:.9rem;margin:.6em 0 .2em}}"
      "#said{{height:3.75em;overflow:auto;margin:.1rem 0 .4rem;font-size:1.1rem;line-height:1.25}}"
      "#equation{{flex:1;min-height:4em;margin-top:.6em;overflow:auto;"
      "font:.85rem 'JetBrains Mono',Menlo,Consolas,monospace}}"
      "#equation p{{margin:.2em 0}}.dim{{color:{5}}}"
      "i{{display:inline-block;width:1.6em;height:1em;border:1px solid;margin-right:.5em;vertical-align:-.1em}}"
      "#buttons{{display:flex;flex-wrap:wrap;align-items:center;gap:.4rem}}#count{{margin-left:.6rem}}"
      "button{{font:inherit;font-weight:bold;color:{1};background:{6};border:0;border-radius:.5rem;min-width:4.6rem;"
      "height:2.6rem}}#step{{background:{3}}}"
      "button svg{{width:1.4rem;height:1.4rem;fill:{1};vertical-align:middle}}"
      "button:focus-visible{{outline:3px solid {4}}}#bar{{width:100%;margin:.6rem 0 0;accent-color:{4}}}"
      "@media(max-aspect-ratio:1){{html{{font-size:clamp(11px,min(2.6vw,1.7vh),48px)}}"
      "main{{grid-template:minmax(0,58%) minmax(0,1fr)/minmax(0,1fr)}}}}\n",
      css_colour(colours.window), css_colour(colours.text), css_colour(colours.plan), css_colour(colours.just_run),
      css_colour(colours.next), css_colour(colours.dim_text), css_colour(mix(colours.panel, colours.text, 0.12)));
}

constexpr std::string_view script = R"(
const box = id => document.getElementById(id);
let at = Math.trunc(location.hash.slice(1)) || 0;
function items(step) {
  let list = [];
  for (let i = step - step % W.complete; i <= step; ++i)
    list = W.steps[i].d.flatMap(d => Array.isArray(d) ? list.slice(d[0], d[0] + d[1]) : [d]);
  return list;
}
function show(step) {
  at = Math.min(Math.max(step, 0), W.steps.length - 1);
  const s = W.steps[at];
  box('plan').innerHTML = items(at).map(i => W.drawn[i]).join('');
  box('said').innerHTML = W.said[s.s];
  box('equation').innerHTML = s.e.map(i => W.said[i]).join('');
  document.querySelectorAll('ol li').forEach(li => li.className = '');
  box('l' + s.n)?.classList.add('next');
  const ran = box('l' + s.r);
  if (ran) { ran.classList.add('ran'); ran.scrollIntoView({block: 'nearest'}); }
  box('bar').value = at;
  box('count').textContent = at + ' / ' + (W.steps.length - 1) + (s.l ? '  DEPTH ' + s.l : '');
}
const auto = box('auto'), words = [auto.textContent, box('pause').innerHTML];
let clock = 0;
function play(on) {
  clearInterval(clock);
  clock = on && at < W.steps.length - 1 ? setInterval(() => at < W.steps.length - 1 ? show(at + 1) : play(false), 250) : 0;
  auto.textContent = words[clock ? 1 : 0];
}
function go(step) { play(false); show(step); }
auto.onclick = () => play(!clock);
box('first').onclick = () => go(0);
box('back').onclick = () => go(at - 1);
box('step').onclick = () => go(at + 1);
box('last').onclick = () => go(W.steps.length - 1);
box('bar').oninput = e => go(+e.target.value);
document.onkeydown = e => {
  if (e.ctrlKey || e.altKey || e.metaKey || (e.key === ' ' && e.target.tagName === 'BUTTON')) return;
  if (e.key === 'a') return play(!clock);
  const to = {ArrowRight: at + 1, ' ': at + 1, PageDown: at + 1, ArrowLeft: at - 1, PageUp: at - 1,
              Home: 0, End: W.steps.length - 1}[e.key];
  if (to === undefined) return;
  e.preventDefault();
  go(to);
};
show(at);
)";

}  // namespace

std::string slides_page(const Scene& scene, std::shared_ptr<const Timeline> timeline, Language language, Theme theme,
                        const Ink& ink, bool english_code) {
  State state = walked(scene, std::move(timeline), language, theme, page_size, ink, english_code);
  const Palette& colours = palette(theme);
  PlanWriter plan;
  Dictionary said;
  const auto say = [&](auto id) { return text(id, language); };
  Json steps = Json::array();
  for (state.walk.position = 0; state.walk.position <= state.walk.timeline->steps(); ++state.walk.position)
    steps.push_back(slide(state, plan, said));
  state.walk.position = 0;
  const Json walk{{"drawn", plan.texts()},
                  {"complete", PlanWriter::complete_every},
                  {"said", said.texts()},
                  {"steps", std::move(steps)}};
  // "</" would end the script.
  std::string data = walk.dump(-1, ' ', false, Json::error_handler_t::replace);
  for (std::size_t i = data.find("</"); i != std::string::npos; i = data.find("</", i + 3)) data.insert(i + 1, "\\");
  const std::string title = escaped(scene.title.empty() ? "Raywalk" : scene.title);
  std::string page = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"{}\"><head><meta charset=\"utf-8\"/>"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n<title>{}</title>\n<style>\n",
      language.code(), title);
  page += style_of(colours);
  page += fmt::format(
      "</style></head>\n<body><h1>{}</h1>\n<main><div id=\"walk\">"
      "<svg id=\"picture\" viewBox=\"0 0 {} {}\" role=\"img\" aria-labelledby=\"said\" "
      "font-family=\"Inter, Helvetica, Arial, sans-serif\"><g id=\"plan\"></g></svg>\n"
      "{}<p id=\"said\" aria-live=\"polite\"></p>\n"
      "<div id=\"buttons\"><button id=\"first\" aria-label=\"{}\"><svg viewBox=\"0 0 24 24\">"
      "<path d=\"M5 5h3v14H5zM20 5v14L9 12z\"/></svg></button><button id=\"back\">{}</button>"
      "<button id=\"step\">{}</button><button id=\"auto\">{}</button><button id=\"last\" aria-label=\"{}\">"
      "<svg viewBox=\"0 0 24 24\"><path d=\"M16 5h3v14h-3zM4 5l11 7-11 7z\"/></svg></button>"
      "<span id=\"count\"></span></div>\n"
      "<input id=\"bar\" type=\"range\" min=\"0\" max=\"{}\" value=\"0\" aria-label=\"{}\"/></div>\n"
      "<div id=\"beside\">{}<div id=\"equation\"></div></div></main><template id=\"pause\">{}</template>\n",
      title, page_size.width, page_size.height, legend_of(state), say("slides.to_start"),
      say("command.step_back.label"), say("command.step.label"), say("command.play.label"), say("slides.to_end"),
      state.walk.timeline->steps(), say("slides.step_bar"), code_of(state), say("transport.pause"));
  return page + "<script>\nconst W = " + data + ";" + std::string(script) + "</script></body></html>\n";
}

std::string plan_picture(const Scene& scene, std::shared_ptr<const Timeline> timeline, Language language, Theme theme,
                         const Ink& ink) {
  State state = walked(scene, std::move(timeline), language, theme, picture_size, ink);
  state.walk.position = state.walk.timeline->steps();
  state.appearance.tab = PictureRoom::tab;
  return svg_file(plan_view(state), picture_size.width, picture_size.height, palette(theme).plan,
                  scene.title.empty() ? "Raywalk" : scene.title);
}

}  // namespace raywalk
