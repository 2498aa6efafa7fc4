// The page's program. Its JavaScript (page.js) gives it a turn a frame, and hands it files.

#include "gui/command.h"
#include "gui/visualiser.h"
#include "gui/web/program.h"
#include "image/image_file.h"
#include "io/scene_file.h"
#include "io/scene_patch.h"
#include "math/words.h"
#include "render/render.h"
#include "text/languages.h"
#include "text/text_file.h"
#include "view/document/document.h"
#include "view/link/link.h"
#include "view/opening.h"

#include <emscripten/em_js.h>
#include <emscripten/emscripten.h>
#include <unistd.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <limits>
#include <new>
#include <string>
#include <string_view>
#include <vector>

// clang-format off
EM_JS(void, raywalk_fail, (const char* text), { Module["fail"](UTF8ToString(text)); });
EM_JS(void, raywalk_speaks, (const char* language), { Module["speaks"](UTF8ToString(language)); });
EM_JS(void, raywalk_stands_at, (const char* link), { Module["stands_at"](UTF8ToString(link)); });
// clang-format on

namespace raywalk {

namespace {

/// Where page.cmake puts the data, and page.js what is kept between visits and the user's files.
constexpr const char *data_folder = "/raywalk", *kept_folder = "/kept", *files_folder = "/files";

Visualiser& visualiser() {
  static Visualiser only;  // never destroyed: a page just goes away
  return only;
}

/// The options of the address, each a name and a value.
Result<GuiOptions> options_of(int argc, char** argv) {
  GuiOptions options;
  options.data_dir = data_folder;
  options.state_dir = kept_folder;
  const LanguagesRead texts = read_languages(options.data_dir + "/text");
  options.languages = texts.languages;
  options.broken_texts = texts.broken;
  for (int i = 1; i + 1 < argc; i += 2) {
    const std::string_view name = argv[i];
    const std::string value = argv[i + 1];
    if (name == "scene") options.scene_path = options.data_dir + "/scenes/" + value + ".toml";
    if (name == "language") options.language = options.languages->find(value);
    if (name == "report") options.report_path = value;
    if (name == "link") options.link = value;
    if (name == "page") options.own_page = value;
    if (name == "embed") options.embedded = true;
  }
  return options;
}

Result<void> open(int argc, char** argv) {
  if (::chdir(files_folder) != 0) return tl::unexpected(Error{files_folder, 0, 0, "there is no such folder", ""});
  const Result<GuiOptions> options = options_of(argc, argv);
  if (!options) return tl::unexpected(options.error());
  FileLedger ledger;
  Result<Visualiser> opened = open_visualiser(*options, ledger);
  if (!opened) return tl::unexpected(opened.error());
  visualiser() = std::move(*opened);
  return {};
}

/// Does it. What it throws, the page says, and keeps what is saved.
void guarded(const auto& work) {
  try {
    work();
  } catch (const std::bad_alloc&) {
    raywalk_fail("out of memory");
  } catch (const std::exception& error) {
    raywalk_fail(error.what());
  }
}

}  // namespace

Loop& page_loop() { return *visualiser().loop; }

namespace {

/// What the page says itself is said in the program's language.
void tell_language() {
  static std::string told;
  if (const std::string_view now = page_loop().state().appearance.language.code(); now != told)
    raywalk_speaks((told = now).c_str());
}

/// Where in which lesson it is, for the address: a page that is loaded again goes on there. None without a lesson.
void tell_place() {
  static std::string told;
  const LessonRoom& sitting = page_loop().state().lessons;
  const std::string now =
      sitting.at() ? write_link({.lesson = sitting.open->lesson.name, .lesson_step = sitting.step + 1}) : std::string();
  if (now != told) raywalk_stands_at((told = now).c_str());
}

}  // namespace

}  // namespace raywalk

using namespace raywalk;

extern "C" {

/// A turn of the loop. The seconds until the next is needed, negative if an event must come first; NaN: there is none.
EMSCRIPTEN_KEEPALIVE double page_turn() {
  double next = std::numeric_limits<double>::quiet_NaN();
  guarded([&] {
    Loop& loop = page_loop();
    if (loop.turn()) next = loop.patience();
    tell_language();
    tell_place();
  });
  return next;
}

/// Before the page is hidden or gone: then it may get no turn any more.
EMSCRIPTEN_KEEPALIVE void page_autosave() {
  guarded([] { page_loop().autosave_now(); });
}

/// Why a scene is not opened that the page around this one has sent; empty if it is. It names no files: they would be
/// read here, and what is wrong with them told there.
EMSCRIPTEN_KEEPALIVE const char* page_refuses(const char* scene) {
  static std::string why;
  try {
    const auto document = parse_scene(scene, "the scene", MeshReading::skip);
    why = !document                      ? document.error().text()
          : names_files(document->scene) ? "the scene names files, which a message cannot bring"
                                         : "";
  } catch (const std::exception& error) {  // the page goes on with the scene that it has
    why = error.what();
  }
  return why.c_str();
}

/// What the page around this one is told (embed.js), as JSON.
EMSCRIPTEN_KEEPALIVE const char* page_told() {
  static std::string told;
  const State& state = page_loop().state();
  const LessonRoom& lessons = state.lessons;
  const auto of_lesson = lessons.first_tries.find(lessons.last);
  const FirstTries tries = of_lesson == lessons.first_tries.end() ? FirstTries{} : of_lesson->second;
  const bool lesson = lessons.at() != nullptr, predicted = !state.predictions.made.empty();
  const nlohmann::json json{
      {"moment",
       {{"step", state.walk.position},
        {"steps", state.walk.timeline->steps()},
        {"scene", state.scene().title},
        {"lesson", lesson ? lessons.open->lesson.name : ""},
        {"lesson_step", lesson ? lessons.step + 1 : 0},
        {"lesson_steps", lesson ? lessons.open->played.steps.size() : 0}}},
      {"judged", tries.judged()},
      {"right", tries.right()},
      {"made", state.predictions.made.size()},
      {"last_right", predicted && state.predictions.made.back().right},
      {"done", lessons.done},
      {"asks", state.document.question.has_value()},
      {"waits", waits_for_answer(state)},
      {"unsaved", state.document.dirty},
      {"error",
       state.document.notice && state.document.notice->kind == Notice::Kind::error ? state.document.notice->text : ""}};
  told = json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  return told.c_str();
}

/// Opens the first scene among these files, one a line; asks before it drops changes.
EMSCRIPTEN_KEEPALIVE void page_open(const char* paths) {
  std::vector<std::string> chosen;
  for (std::string_view rest = paths; !rest.empty();) {
    const std::string_view path = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(path.size() + 1, rest.size()));
    chosen.emplace_back(path);
  }
  guarded([&] {
    for (const Action& action : opening_among(page_loop().state(), chosen)) page_loop().act(action);
  });
}

/// What was saved there is not in the user's file: refused, where `why` is empty. False if another scene is open by
/// now.
EMSCRIPTEN_KEEPALIVE bool page_not_saved(const char* path, const char* why) {
  if (page_loop().state().document.path != path) return false;
  guarded([&] { page_loop().act(action::NotSaved{path, why}); });
  return true;
}

/// All that the drawing was made with is gone.
EMSCRIPTEN_KEEPALIVE void page_draw_again() {
  guarded([] { page_loop().draw_again(); });
}

/// Whether a key press, "Ctrl+Shift+S", does anything in the window: the browser then should not.
EMSCRIPTEN_KEEPALIVE bool page_uses_key(const char* written) {
  const KeyPress press = key_press(written);
  return is_key(press.key) && (commands_on(press, Mode::trace) > 0 || commands_on(press, Mode::move) > 0);
}

/// Renders a scene, as `raywalk render` does; null, or what is wrong. An empty `integrator` is the scene's.
EMSCRIPTEN_KEEPALIVE const char* page_render(const char* scene, const char* image, int width, int height,
                                             const char* precision, const char* integrator) {
  static std::string wrong;
  auto document = read_scene(scene);
  if (!document) return (wrong = document.error().text()).c_str();
  RenderSettings settings;
  settings.size = ImageSize{width, height};
  settings.sampling.per_pixel = document->scene.render.samples;
  settings.precision = named<Precision>(precision).value_or(Precision::double_);
  RenderChoices& choices = document->scene.render;
  choices.integrator = named<Integrator>(integrator).value_or(choices.integrator);
  settings.tolerance = choices.tolerance;
  const auto rendering = render(document->scene, settings);
  if (!rendering) return (wrong = rendering.error().text()).c_str();
  const auto written = write_image(image, rendering->image(), document->scene.encoding);
  if (!written) return (wrong = written.error().text()).c_str();
  return nullptr;
}
}

int main(int argc, char** argv) {
  guarded([&] {
    if (const Result<void> opened = open(argc, argv); !opened) raywalk_fail(opened.error().text().c_str());
  });
}
