// In a page the presenter's notes have a tab of their own.

#include "gui/notes.h"
#include "text/markup.h"

#include <emscripten/em_js.h>

#include <memory>
#include <string>
#include <utility>

// clang-format off
EM_JS_DEPS(raywalk_notes, "$UTF8ToString");
// Whether the tab is there: opened by a click or a key, and not closed by the user.
EM_JS(int, raywalk_show_notes, (const char* html, const char* css, int opens), {
  if (opens) Module["notes"] = window.open("", "raywalk-notes");
  const tab = Module["notes"];
  if (!tab || tab.closed) return 0;
  const text = UTF8ToString(html), style = UTF8ToString(css), shown = style + text;
  try {
    if (Module["notesShown"] !== shown || opens) {
      Module["notesShown"] = shown;
      tab.document.body.innerHTML = text;
      // The page's policy is the tab's too: it lets scripts style it, but no <style>.
      const sheet = new tab.CSSStyleSheet();
      sheet.replaceSync(style);
      tab.document.adoptedStyleSheets = [sheet];
    }
  } catch (why) { // the user has gone elsewhere in it
    Module["notes"] = null;
    return 0;
  }
  return 1;
});
EM_JS(void, raywalk_close_notes, (), { Module["notes"]?.close(); });
// clang-format on

namespace raywalk {

struct NotesWindow::Parts {
  bool opened = false;
};

NotesWindow::NotesWindow(Window& /*main*/, FontFiles /*fonts*/) : parts_(new Parts) {}

NotesWindow::~NotesWindow() { raywalk_close_notes(); }

bool NotesWindow::show(const State& state) {
  const NotesPanel panel = notes_panel(state);
  const Palette& colours = palette(state.appearance.theme);
  const auto css = [](Colour colour) {
    return "rgb(" + std::to_string(colour.r) + "," + std::to_string(colour.g) + "," + std::to_string(colour.b) + ")";
  };
  const std::string style =
      "body{font:1.3rem sans-serif;margin:1.5rem;white-space:pre-line;background:" + css(colours.panel) +
      ";color:" + css(colours.text) + "}small,.later{color:" + css(colours.dim_text) +
      "}h1{font-size:1.6rem}h2{font-size:1rem;margin:1em 0 .2em}";
  std::string html = "<small>" + escaped(panel.lesson) + "   " + escaped(panel.time) + "</small><h1>" +
                     escaped(panel.heading) + "</h1>";
  for (const NotesPanel::Part& part : panel.parts)
    html += std::string("<div") + (part.later ? " class=later" : "") + "><h2>" + escaped(part.title) + "</h2>" +
            escaped(part.text) + "</div>";
  return raywalk_show_notes(html.c_str(), style.c_str(), std::exchange(parts_->opened, true) ? 0 : 1) != 0;
}

}  // namespace raywalk
