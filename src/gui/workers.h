#pragma once
// Programs of this build that run beside this one and share nothing with it but messages: a page's Web Workers. There
// are none where threads do their work (render/parallel.h), and where a browser refuses them.

#include <cstdint>
#include <optional>
#include <string>

namespace raywalk {

/// The first byte of every message and answer.
enum class MessageKind : std::uint8_t { rows, tries, structures };

/// How every message and answer begins. `What`: an enumeration of what a worker is asked to do; in an answer, whether
/// it knows the job.
template <class What>
struct MessageHead {
  MessageKind kind;
  What what;
  std::uint64_t job;
};

class Workers {
 public:
  Workers() = default;
  virtual ~Workers() = default;
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  /// They are numbered from 0. Once one is lost, all are, and there are none.
  [[nodiscard]] virtual int count() = 0;
  /// They take their messages in order.
  virtual void tell(int worker, const std::string& message) = 0;

  struct Answer {
    int worker;
    std::string message;
  };
  /// The next answer of this kind, if there is one by now.
  [[nodiscard]] virtual std::optional<Answer> hear(MessageKind kind) = 0;
};

}  // namespace raywalk
