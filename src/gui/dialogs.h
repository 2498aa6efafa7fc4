#pragma once

#include "gui/ui.h"

namespace raywalk {

/// The open question, if there is one, with a button for each answer.
void question_dialog(const Ui& ui);

/// The notice above the plan, with a button to dismiss it.
void notice_bar(const Ui& ui, const Rect& plan);

}  // namespace raywalk
