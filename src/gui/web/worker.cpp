// The same program in a worker: it has no window, and answers messages (worker.js).

#include "gui/row_workers.h"
#include "gui/try_workers.h"

#include <emscripten/emscripten.h>

#include <cstddef>
#include <string>

namespace raywalk {

namespace {
RowServer rows;
TryServer tries;
std::string message, answer;
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
  const bool of_rows =
      !raywalk::message.empty() && raywalk::message[0] == static_cast<char>(raywalk::MessageKind::rows);
  raywalk::answer = of_rows ? raywalk::rows.answer(raywalk::message) : raywalk::tries.answer(raywalk::message);
  return static_cast<int>(raywalk::answer.size());
}

EMSCRIPTEN_KEEPALIVE const char* worker_answer() { return raywalk::answer.data(); }
}
