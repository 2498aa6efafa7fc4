#include "io/scene_file.h"
#include "io/scene_merge.h"
#include "io/scene_rearrange.h"
#include "io/scene_values.h"
#include "io/toml_layout.h"
#include "text/file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace raywalk {

namespace {

using detail::Value;

/// Whether every line of `text` ends with CR LF.
bool has_windows_lines(std::string_view text) {
  for (std::size_t at = text.find('\n'); at != std::string_view::npos; at = text.find('\n', at + 1))
    if (at == 0 || text[at - 1] != '\r') return false;
  return text.find('\n') != std::string_view::npos;
}

std::string with_unix_lines(std::string text) {
  std::erase(text, '\r');
  return text;
}

std::string with_windows_lines(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '\n') result += '\r';
    result += c;
  }
  return result;
}

/// `text`, changed from `old` to `now`; nothing if its layout is too complex.
std::optional<std::string> merged(std::string text, Value old, const Value& now) {
  if (!text.empty() && text.back() != '\n') text += '\n';
  for (const Value& tables : now.children) {
    if (tables.kind != Value::Kind::tables) continue;
    const auto before = std::find_if(old.children.begin(), old.children.end(),
                                     [&](const Value& each) { return each.key == tables.key; });
    const detail::Origins origins = detail::pair_up(*before, tables);
    if (detail::is_unchanged(origins, before->children.size())) continue;
    const auto layout = detail::scan_toml(text);
    if (!layout) return std::nullopt;
    const detail::LayoutNode* node = layout->root.find(tables.key);
    detail::TextEdits edits;
    if (node != nullptr && node->is_inline)
      detail::rearrange_list(text, *node, tables, origins, edits);
    else
      detail::rearrange_tables(*layout, text, node, tables, origins, edits);
    auto rearranged = edits.apply(text);
    if (!rearranged) return std::nullopt;
    text = std::move(*rearranged);
    std::vector<Value> elements;
    for (std::size_t i = 0; i < origins.size(); ++i)
      elements.push_back(origins[i] ? before->children[*origins[i]] : tables.children[i]);
    before->children = std::move(elements);
  }
  const auto layout = detail::scan_toml(text);
  if (!layout) return std::nullopt;
  detail::TextEdits edits;
  detail::merge_values(*layout, text, old, now, edits);
  return edits.apply(text);
}

/// Minimum size of the scene's text: a short name, a type and a few digits per object, "0, " per number of a mesh.
double least_text(const Scene& scene) {
  constexpr double per_object = 60, per_number = 3;
  double bytes = per_object * static_cast<double>(scene.objects.size());
  for (const Object& object : scene.objects)
    if (const auto* mesh = std::get_if<MeshShape>(&object.shape); mesh && mesh->mesh && mesh->file.empty())
      bytes +=
          3 * per_number *
          static_cast<double>(mesh->mesh->positions.size() + mesh->mesh->normals.size() + mesh->mesh->triangles.size());
  return bytes;
}

}  // namespace

Result<std::string> format_scene(const Scene& scene, std::string_view previous_text, const Ink& ink) {
  const auto too_large = [&](std::string_view at_least, double bytes) {
    const std::size_t count = scene.objects.size();
    constexpr double mebibyte = 1 << 20;
    return tl::unexpected(Error{
        "", 0, 0,
        fmt::format("the scene is too large for a .toml: {} object{} to {}{:.0f} MiB (expected at most {} MiB)", count,
                    count == 1 ? " comes" : "s come", at_least, std::ceil(bytes / mebibyte), max_scene_bytes >> 20),
        "convert it to .pov, which may be larger, or keep the file that it was read from"});
  };
  // The tree of values takes a thousand times the memory of the text, so what is too large is refused before.
  if (const double least = least_text(scene); least > static_cast<double>(max_scene_bytes))
    return too_large("at least ", least);
  const Value now = detail::values_of(scene, ink);
  // Reading back proves that nothing is lost, and checks the scene itself.
  const auto holds_scene = [&](const Result<SceneDocument>& written) {
    return written && detail::values_of(written->scene, written->ink) == now;
  };
  if (!previous_text.empty()) {
    const bool windows = has_windows_lines(previous_text);
    const std::string previous = windows ? with_unix_lines(std::string(previous_text)) : std::string(previous_text);
    if (const auto old = parse_scene(previous, "", MeshReading::skip)) {
      auto text = merged(previous, detail::values_of(old->scene, old->ink), now);
      if (text && windows) text = with_windows_lines(*text);
      if (text && holds_scene(parse_scene(*text, "", MeshReading::skip))) return *text;
    }
  }
  std::string text = detail::section_text(now, "");
  if (text.size() > max_scene_bytes) return too_large("", static_cast<double>(text.size()));
  const auto written = parse_scene(text, "the scene to be written", MeshReading::skip);
  if (!written) return tl::unexpected(written.error());
  if (!holds_scene(written))
    return tl::unexpected(Error{"", 0, 0, "the scene cannot be written without loss", "change what was edited last"});
  return text;
}

Result<void> write_scene(SceneDocument& document, const std::string& path) {
  const SceneFormat format = scene_format_of(path);
  if (format != SceneFormat::toml)
    return tl::unexpected(
        Error{path, 0, 0, "scenes in " + std::string(scene_ending(format)) + " are read, not written (expected .toml)",
              "save it as a file that ends in .toml"});
  auto text = with_names_from(document.scene, document.path, path).and_then([&](const Scene& scene) {
    return format_scene(scene, document.text, document.ink_of_file());
  });
  if (!text) {
    // A place in a text that the user has not seen is no help; the message names the key and the object.
    Error error = text.error();
    error.file = path;
    error.line = error.column = 0;
    return tl::unexpected(error);
  }
  if (const auto written = write_file_atomically(path, *text); !written) return written;
  document.text = std::move(*text);
  return {};
}

}  // namespace raywalk
