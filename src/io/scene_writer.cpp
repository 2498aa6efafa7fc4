#include "io/scene_file.h"
#include "io/scene_merge.h"
#include "io/scene_rearrange.h"
#include "io/scene_values.h"
#include "io/toml_layout.h"
#include "text/file.h"

#include <fmt/format.h>

#include <algorithm>
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

/// Whether the triangle meshes that a scene holds itself are too large for its text: at least "0, " per number. Their
/// trees of values would take a hundred times that memory.
bool has_large_meshes(const Scene& scene) {
  constexpr std::size_t per_row = 3 * 3;
  std::size_t bytes = 0;
  for (const Object& object : scene.objects)
    if (const auto* mesh = std::get_if<MeshShape>(&object.shape); mesh && mesh->mesh && mesh->file.empty())
      bytes += per_row * (mesh->mesh->positions.size() + mesh->mesh->normals.size() + mesh->mesh->triangles.size());
  return bytes > max_scene_bytes;
}

Error too_large(const Scene& scene, std::size_t listed) {
  const std::size_t count = scene.objects.size();
  const std::string which = listed < count ? fmt::format("the first {} of its {} objects", listed, count)
                            : count == 1   ? "its object"
                                           : fmt::format("its {} objects", count);
  return {
      "", 0, 0,
      fmt::format("the scene is too large for a .toml: {} would take more than {} MiB", which, max_scene_bytes >> 20),
      "convert it to .pov, which may be larger, or keep the file that it was read from"};
}

}  // namespace

Result<std::string> format_scene(const Scene& scene, std::string_view previous_text, const Ink& ink) {
  if (has_large_meshes(scene)) return tl::unexpected(too_large(scene, scene.objects.size()));
  // Reading back proves that nothing is lost, and checks the scene itself.
  const auto holds_scene = [&](const Result<SceneDocument>& written) {
    return written && detail::have_same_values({written->scene, written->ink}, {scene, ink});
  };
  if (!previous_text.empty()) {
    const bool windows = has_windows_lines(previous_text);
    const std::string previous = windows ? with_unix_lines(std::string(previous_text)) : std::string(previous_text);
    if (const auto old = parse_scene(previous, "", MeshReading::skip)) {
      auto text = merged(previous, detail::values_of(old->scene, old->ink), detail::values_of(scene, ink));
      if (text && windows) text = with_windows_lines(*text);
      if (text && holds_scene(parse_scene(*text, "", MeshReading::skip))) return *text;
    }
  }
  detail::SceneText listed = detail::scene_text({scene, ink}, max_scene_bytes);
  if (listed.text.size() > max_scene_bytes) return tl::unexpected(too_large(scene, listed.objects));
  const auto written = parse_scene(listed.text, "the scene to be written", MeshReading::skip);
  if (!written) return tl::unexpected(written.error());
  if (!holds_scene(written))
    return tl::unexpected(Error{"", 0, 0, "the scene cannot be written without loss", "change what was edited last"});
  return std::move(listed.text);
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
