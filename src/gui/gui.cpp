#include "gui/gui.h"

#include "gui/loading.h"
#include "gui/visualiser.h"
#include "text/file.h"
#include "text/text_file.h"
#include "view/action_text.h"

#include <utility>

namespace raywalk {

Result<Visualiser> open_visualiser(const GuiOptions& options, FileLedger& ledger) {
  const auto begun = std::chrono::steady_clock::now();
  // Otherwise the window is opened last: errors in a scene are reported without one.
  Result<std::unique_ptr<Window>> window{nullptr};
  std::unique_ptr<Attention> attention;
  if (takes_long_to_read(options)) {
    window = Window::open("Raywalk", options.width, options.height);
    if (!window) return tl::unexpected(window.error());
    attention = std::make_unique<Attention>(**window);
  }
  Result<State> state = attention ? start_in_sight(options, **window, *attention) : start(options);
  if (!state) return tl::unexpected(state.error());
  Demo demo;
  if (!options.demo_path.empty()) {
    constexpr std::size_t max_bytes = 16 << 20;
    const Result<std::string> text = read_text(options.demo_path, max_bytes);
    if (!text) return tl::unexpected(text.error());
    Result<std::vector<Action>> actions = parse_demo(*text, options.demo_path);
    if (!actions) return tl::unexpected(actions.error());
    demo = Demo(std::move(*actions));
  }
  if (!options.screenshot_path.empty()) {
    if (const auto format = image_format_of(options.screenshot_path); !format) return tl::unexpected(format.error());
  }
  for (const std::string& path : {options.report_path, options.screenshot_path})
    if (const auto claimed = path.empty() ? Result<void>() : claim_output(path); !claimed)
      return tl::unexpected(claimed.error());
  ledger.close();
  for (const std::string& path : {options.demo_path, options.report_path, options.screenshot_path})
    if (!path.empty()) state->document.keeps.push_back(path);
  if (*window == nullptr) window = Window::open("Raywalk", options.width, options.height);
  if (!window) return tl::unexpected(window.error());
  if (!attention) attention = std::make_unique<Attention>(**window);
  auto loop = std::make_unique<Loop>(options, std::move(*state), **window, *attention, std::move(demo), begun);
  return Visualiser{std::move(*window), std::move(attention), std::move(loop)};
}

Result<void> run_gui(const GuiOptions& options, FileLedger& ledger) {
  const Result<Visualiser> opened = open_visualiser(options, ledger);
  if (!opened) return tl::unexpected(opened.error());
  while (opened->loop->turn()) {
  }
  return opened->loop->end();
}

}  // namespace raywalk
