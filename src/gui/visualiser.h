#pragma once

#include "gui/attention.h"
#include "gui/gui.h"
#include "gui/loop.h"
#include "gui/window.h"

#include <memory>

namespace raywalk {

/// The open window and what runs in it.
struct Visualiser {
  std::unique_ptr<Window> window;
  std::unique_ptr<Attention> attention;
  std::unique_ptr<Loop> loop;
};
/// Opens it; fails where run_gui says. `ledger` as there.
[[nodiscard]] Result<Visualiser> open_visualiser(const GuiOptions& options, FileLedger& ledger);

}  // namespace raywalk
