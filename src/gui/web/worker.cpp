// The same program in a worker: it has no window, and answers messages (worker.js).

#include "gui/row_workers.h"
#include "gui/structure_workers.h"
#include "gui/try_workers.h"

#include <emscripten/emscripten.h>

#include <cstddef>
#include <string>

namespace raywalk {

namespace {
RowServer rows;
TryServer tries;
StructureServer structures;
std::string message, answer;

std::string answer_to(const std::string& told) {
  if (told.empty()) return {};
  switch (static_cast<MessageKind>(told[0])) {
    case MessageKind::rows:
      return rows.answer(told);
    case MessageKind::tries:
      return tries.answer(told);
    case MessageKind::structures:
      return structures.answer(told);
  }
  return {};
}
}  // namespace

}  // namespace raywalk

extern "C" {

/// Where the next message of so many bytes is to be written.
EMSCRIPTEN_KEEPALIVE char* worker_room(int size) {
  raywalk::message.resize(static_cast<std::size_t>(size));
  return raywalk::message.data();
}

/// Answers it: the answer's size, 0 if there is none.
EMSCRIPTEN_KEEPALIVE int worker_work() {
  raywalk::answer = raywalk::answer_to(raywalk::message);
  return static_cast<int>(raywalk::answer.size());
}

EMSCRIPTEN_KEEPALIVE const char* worker_answer() { return raywalk::answer.data(); }
}
