// Links as letters.

#include "io/packed_text.h"
#include "view/action.h"
#include "view/link/link.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <utility>

namespace raywalk {

namespace {

constexpr std::string_view link_begin = "v=";
constexpr int link_version = 1;
constexpr std::size_t max_unpacked = 1 << 16;
constexpr int max_steps = 1 << 26, max_side = 1 << 16, max_lesson_steps = 1000;

tl::unexpected<Error> no_link(std::string message, std::string hint = {}) {
  return tl::unexpected(Error{"", 0, 0, std::move(message), std::move(hint)});
}

/// Names of files without their folder and ending.
bool is_file_name(std::string_view word) {
  constexpr std::size_t most = 80;
  return !word.empty() && word.size() <= most && std::all_of(word.begin(), word.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  });
}

/// The address from behind its #; all of it where there is none.
std::string_view fragment_of(std::string_view address) {
  const std::size_t at = address.find('#');
  return at == std::string_view::npos ? address : address.substr(at + 1);
}

int hex_digit(char c) {
  constexpr std::string_view digits = "0123456789abcdef";
  return static_cast<int>(digits.find(static_cast<char>(c >= 'A' && c <= 'F' ? c - 'A' + 'a' : c)));
}

/// With %XX as the character that it stands for: some programs write / and = like that.
std::string without_escapes(std::string_view text) {
  std::string plain;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const bool escape =
        text[at] == '%' && at + 2 < text.size() && hex_digit(text[at + 1]) >= 0 && hex_digit(text[at + 2]) >= 0;
    plain += escape ? static_cast<char>(16 * hex_digit(text[at + 1]) + hex_digit(text[at + 2])) : text[at];
    if (escape) at += 2;
  }
  return plain;
}

template <class Number>
bool parse_number(std::string_view text, Number& value, Number least, Number most, int base = 10) {
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number, base);
  if (error != std::errc() || end != text.data() + text.size() || number < least || number > most) return false;
  value = number;
  return true;
}

/// Reads the parts of a link into its fields.
class LinkReader {
 public:
  explicit LinkReader(Link& link) : link_(link) {}

  [[nodiscard]] Result<void> part(std::string_view key, std::string_view value) {
    if (!understood(key, value) && error_.empty()) error_ = fmt::format("its part {} cannot be read", key);
    if (!error_.empty()) return no_link(error_, "copy the link again, from its beginning to its end");
    return {};
  }

 private:
  /// Whether the value is one that such a part can have.
  bool understood(std::string_view key, std::string_view value) {
    if (key == "lesson" || key == "scene") {
      (key == "lesson" ? link_.lesson : link_.scene) = value;
      return is_file_name(value);
    }
    if (key == "at") return parse_number(value, link_.lesson_step, 1, max_lesson_steps);
    if (key == "bug") return parse_number(value, link_.bug, 1, static_cast<int>(values_of<Fault>.size()));
    if (key == "changes") return unpack(value, link_.changes);
    if (key == "camera") return unpack(value, link_.camera);
    if (key == "sum") return parse_number(value, link_.sum.emplace(), 0U, ~0U, 16);
    if (key == "pixel") return pixel(value);
    if (key == "walk") return word(value, link_.integrator);
    if (key == "bits") {
      link_.single_precision = value == "24";
      return value == "24" || value == "53";
    }
    if (key == "samples") return parse_number(value, link_.walk_samples, 1, max_walk_samples);
    if (key == "effects") return effects(value);
    if (key == "step") return parse_number(value, link_.step.emplace(), 0, max_steps);
    if (key == "mode") return word(value, link_.mode) && link_.mode != Mode::help;
    if (key == "tab") return word(value, link_.tab);
    if (key == "lang") {
      link_.language = value;
      return is_language_code(value);
    }
    if (key == "theme") return word(value, link_.theme);
    return true;  // a later version's
  }

  bool unpack(std::string_view letters, std::string& text) {
    auto unpacked = unpack_text(letters, max_unpacked);
    if (!unpacked) error_ = unpacked.error().message;
    if (unpacked) text = std::move(*unpacked);
    return unpacked.has_value();
  }
  template <class E>
  static bool word(std::string_view value, std::optional<E>& to) {
    to = named<E>(value);
    return to.has_value();
  }
  /// "COLUMN,ROW,WIDTH,HEIGHT"
  bool pixel(std::string_view value) {
    PixelWalk walk;
    for (int* number : {&walk.column, &walk.row, &walk.size.width, &walk.size.height}) {
      const std::size_t end = std::min(value.find(','), value.size());
      if (!parse_number(value.substr(0, end), *number, 0, max_side)) return false;
      value.remove_prefix(std::min(end + 1, value.size()));
    }
    link_.pixel = walk;
    return value.empty() && walk.column < walk.size.width && walk.row < walk.size.height;
  }

  /// "LEFT_OUT" or "LEFT_OUT,DEPTH"
  bool effects(std::string_view value) {
    const std::size_t end = std::min(value.find(','), value.size());
    std::uint32_t set = 0;
    if (!parse_number(value.substr(0, end), set, 0U, (1U << effect_count) - 1, 16)) return false;
    link_.left_out = set;
    return end == value.size() || parse_number(value.substr(end + 1), link_.depth.emplace(), 1, EffectsRoom::deepest);
  }

  Link& link_;
  std::string error_;
};

}  // namespace

std::string write_link(const Link& link) {
  std::string text = fmt::format("#{}{}", link_begin, link_version);
  const auto part = [&](std::string_view key, const auto& value) { text += fmt::format("/{}={}", key, value); };
  if (!link.lesson.empty()) {
    part("lesson", link.lesson);
    part("at", link.lesson_step);
  }
  if (link.bug > 0) part("bug", link.bug);
  if (!link.scene.empty()) part("scene", link.scene);
  if (!link.changes.empty()) part("changes", pack_text(link.changes));
  if (link.sum) part("sum", fmt::format("{:x}", *link.sum));
  if (!link.camera.empty()) part("camera", pack_text(link.camera));
  if (const auto& walk = link.pixel)
    part("pixel", fmt::format("{},{},{},{}", walk->column, walk->row, walk->size.width, walk->size.height));
  if (link.integrator) part("walk", name_of(*link.integrator));
  if (link.single_precision) part("bits", 24);
  if (link.walk_samples != 1) part("samples", link.walk_samples);
  if (link.left_out.any() || link.depth)
    part("effects", fmt::format("{:x}{}", link.left_out.to_ulong(), link.depth ? fmt::format(",{}", *link.depth) : ""));
  if (link.step) part("step", *link.step);
  if (link.mode) part("mode", name_of(*link.mode));
  if (link.tab) part("tab", name_of(*link.tab));
  if (!link.language.empty()) part("lang", link.language);
  if (link.theme) part("theme", name_of(*link.theme));
  return text;
}

bool is_link(std::string_view word) {
  const std::size_t at = word.find('#');
  return at != std::string_view::npos && without_escapes(word.substr(at + 1, 8)).starts_with(link_begin);
}

Result<Link> read_link(std::string_view address) {
  const std::string_view fragment = fragment_of(address);
  if (fragment.size() > max_link)
    return no_link(fmt::format("it has {} letters (expected at most {})", fragment.size(), max_link), "");
  const std::string text = without_escapes(fragment);
  Link link;
  std::string_view rest = text;
  bool begun = false;
  while (!rest.empty()) {
    const std::string_view part = rest.substr(0, rest.find('/'));
    rest.remove_prefix(std::min(part.size() + 1, rest.size()));
    const std::size_t middle = part.find('=');
    if (part.empty()) continue;
    if (!begun) {
      int version = 0;
      if (!part.starts_with(link_begin) || !parse_number(part.substr(link_begin.size()), version, 1, 999'999))
        return no_link("it does not begin as links do (expected #v=1/...)",
                       "copy the link again, from its beginning to its end");
      if (version > link_version)
        return no_link(fmt::format("it was made by a later version of Raywalk (links of version {}, this one reads {})",
                                   version, link_version),
                       "load the page again, or get the current version");
      begun = true;
      continue;
    }
    if (middle == std::string_view::npos)
      return no_link("it has been cut off", "copy the link again, from its beginning to its end");
    if (const auto read = LinkReader(link).part(part.substr(0, middle), part.substr(middle + 1)); !read)
      return tl::unexpected(read.error());
  }
  if (!begun) return no_link("there is nothing in it (expected #v=1/...)");
  if (link.lesson.empty()) link.lesson_step = 1;
  return link;
}

}  // namespace raywalk
