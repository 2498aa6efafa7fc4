#pragma once

#include "gui/ui.h"

namespace raywalk {

/// The open question, if there is one, with a button for each answer.
void question_dialog(const Ui& ui);

/// What the program has to say, above the plan, with a button to take it away.
void notice_bar(const Ui& ui, const Rect& plan);

}  // namespace raywalk
