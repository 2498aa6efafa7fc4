#pragma once

#include "gui/key.h"
#include "gui/ui.h"

namespace raywalk {

/// Whether the user's own files are asked for, and come through the system's chooser: to open them, or because an
/// autosave lacks them.
[[nodiscard]] bool asks_for_files(const State& state);
/// The open question, if there is one, with a button for each answer.
void question_dialog(const Ui& ui);
/// Enter gives the first answer, which is safe; Escape cancels if possible; a digit picks. Returns whether it did.
bool answer_by_key(const KeyPress& press, const Ui& ui);

/// The link that is shown, with its QR code.
void link_dialog(const Ui& ui);
/// Escape closes it, Enter copies. Returns whether it is open: then no other key has a meaning.
bool link_by_key(const KeyPress& press, const Ui& ui);

/// The notice over the plan, with a button to dismiss it, where it covers neither EYE nor a light; if need be over the
/// strip below.
void notice_bar(const Ui& ui, const Rect& plan, const Rect& strip);

}  // namespace raywalk
