#include "io/scene_file.h"

#include "io/mesh_scene.h"
#include "io/nff_reader.h"
#include "io/scene_reader.h"
#include "io/test_format_reader.h"
#include "io/textures.h"
#include "scene/copied_meshes.h"
#include "scene/schema_kinds.h"
#include "scene/warnings.h"
#include "text/file.h"
#include "text/file_ledger.h"
#include "text/text_file.h"
#include "text/toml_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <new>

namespace raywalk {

namespace {

using detail::ReadLog;
using detail::SceneReader;

/// Other formats contain their millions of shapes themselves.
constexpr std::size_t max_foreign_bytes = std::size_t{2} << 30;

bool ends_with(std::string_view path, std::string_view ending) {
  if (path.size() <= ending.size()) return false;
  const auto same = [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; };
  return std::equal(path.end() - static_cast<std::ptrdiff_t>(ending.size()), path.end(), ending.begin(), same);
}

/// The place of a value, or of the innermost table around it that the file has.
toml::source_region place_of(const toml::table& root, std::string_view table, std::string_view key) {
  const auto outer = root[table];
  if (const auto inner = outer[key]) return inner.node()->source();
  if (outer) return outer.node()->source();
  return root.source();
}

void check_camera(const Camera& camera, const toml::table& root, ReadLog& log) {
  if (camera.fov && camera.screen.width)
    log.fail(place_of(root, "screen", "width"),
             "width of [screen]: the camera's fov already gives the width of the picture (expected only one of them)",
             "remove width from [screen] or fov from [camera]");
  if (!camera.fov && !camera.screen.width)
    log.fail(place_of(root, "camera", "fov"),
             "the picture has no width (expected either fov in [camera] or width in [screen])",
             "add fov = 45 to [camera]");
  if (!looks_somewhere(camera))
    return log.fail(place_of(root, "camera", "look_at"),
                    "look_at of [camera] is the same point as eye (expected a point that the eye sees)",
                    "move look_at to the middle of what is to be seen");
  if (looks_along_up(camera))
    log.fail(place_of(root, "camera", root["camera"]["up"] ? "up" : "look_at"),
             "up of [camera] is parallel to the view (expected any other direction)",
             "when looking straight down or up, give up = [0, 1, 0]");
}

void check_image(const ImageSize& image, const toml::table& root, ReadLog& log) {
  if (has_too_many_pixels(image))
    log.fail(place_of(root, "image", "height"),
             fmt::format("[image] has {} x {} pixels (expected at most {} in all)", image.width, image.height,
                         max_image_pixels),
             "make it narrower or lower");
}

void check_entries(const Scene& scene, const toml::table& root, ReadLog& log) {
  const CopiedMeshes copied(scene);
  const double all = entries_of(scene.objects), stored = all - (copied.share() ? copied.spared() : 0);
  if (!(stored > detail::max_entries) && !(all > detail::max_copied)) return;
  const bool of_copies = stored < all && !(stored > detail::max_entries);
  log.fail(
      root["object"] ? root["object"].node()->source() : root.source(),
      fmt::format("the scene comes to {:.3g} objects and triangles{} (expected at most {:g})", of_copies ? all : stored,
                  of_copies ? " of copies" : "", of_copies ? detail::max_copied : detail::max_entries),
      "groups of groups grow fast: use fewer instances, or smaller meshes");
}

void warn_of_bright_materials(const Scene& scene, const toml::table& root, ReadLog& log) {
  const toml::array* tables = root["object"].as_array();
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const Material& m = scene.objects[i].material;
    double sum = max_component(m.diffuse + m.specular + m.reflection + m.transmission);
    if (m.mask)
      sum = std::max(sum, max_component(m.mask->second.diffuse + m.mask->second.specular + m.mask->second.reflection));
    constexpr double rounding = 1e-9;  // 0.7 + 0.2 + 0.1 may come out above 1
    if (sum > 1 + rounding)
      log.warn(
          tables->get(i)->source(),
          fmt::format("{} sends out more light than it receives: diffuse + specular + reflection + transmission is "
                      "{:.4g} in its largest channel (expected at most 1)",
                      toml_text::quoted(scene.objects[i].name), sum));
  }
}

/// Why one of a material's maps changes nothing; empty if it does.
std::string why_idle(const ParameterMap& map, const Material& material) {
  const auto is_nothing = [&] {
    switch (map.of) {
      case MappedParameter::ambient:
        return is_black(material.ambient);
      case MappedParameter::diffuse:
        return is_black(material.diffuse);
      case MappedParameter::diffuse_roughness:
        return material.diffuse_roughness == 0;
      case MappedParameter::specular:
        return is_black(material.specular);
      case MappedParameter::shininess:
        return material.shininess == 0;
      case MappedParameter::reflection:
        return is_black(material.reflection);
      case MappedParameter::transmission:
        return is_black(material.transmission);
      case MappedParameter::roughness:
        return material.roughness == 0;
      case MappedParameter::gloss:
        return material.gloss == 0;
      case MappedParameter::translucency:
        return material.translucency == 0;
      case MappedParameter::emission:
        return is_black(material.emission);
    }
    return false;
  };
  const std::string name(name_of(map.of));
  if (is_nothing())
    return fmt::format(
        "the map of {} changes nothing, for what it multiplies is 0 (expected above 0: 1 takes the map "
        "as it is)",
        name);
  const auto needs = [&](const char* what) {
    return fmt::format("the map of {} changes nothing, for there is no {} (expected {} above 0)", name, what, what);
  };
  const bool bounces = !is_black(material.reflection) || material.transmits();
  switch (map.of) {
    case MappedParameter::roughness:
    case MappedParameter::gloss:
      return bounces ? "" : needs("reflection");
    case MappedParameter::translucency:
      return material.transmits() ? "" : needs("transmission");
    case MappedParameter::shininess:
      return !is_black(material.specular) ? "" : needs("specular");
    case MappedParameter::diffuse_roughness:
      return !is_black(material.diffuse) ? "" : needs("diffuse");
    case MappedParameter::ambient:
    case MappedParameter::diffuse:
    case MappedParameter::specular:
    case MappedParameter::reflection:
    case MappedParameter::transmission:
    case MappedParameter::emission:
      break;
  }
  return {};
}

void warn_of_idle_maps(const Scene& scene, const toml::table& root, ReadLog& log) {
  const toml::array* tables = root["object"].as_array();
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const Material& material = scene.objects[i].material;
    const auto warn_of = [&](const Material& of, const char* whose) {
      for (const ParameterMap& map : of.maps)
        if (const std::string why = why_idle(map, of); !why.empty())
          log.warn(tables->get(i)->source(),
                   fmt::format("{}{}: {}", toml_text::quoted(scene.objects[i].name), whose, why));
    };
    warn_of(material, "");
    if (material.mask) warn_of(second_of(material), ", second material");
    if (material.normal_map && material.normal_map->strength == 0)
      log.warn(tables->get(i)->source(),
               fmt::format("{}: the normal map changes nothing, for its strength is 0 (expected above 0)",
                           toml_text::quoted(scene.objects[i].name)));
    if (material.bump_map && material.bump_map->relief == 0)
      log.warn(tables->get(i)->source(),
               fmt::format("{}: the bump map changes nothing, for its relief is 0 (expected another height)",
                           toml_text::quoted(scene.objects[i].name)));
  }
}

Error syntax_error(const toml::parse_error& error, const std::string& file) {
  const std::string_view what = error.description();
  const bool number = what.find("floating-point") != what.npos || what.find("representable") != what.npos;
  return {file, static_cast<int>(error.source().begin.line), static_cast<int>(error.source().begin.column),
          "this is not valid TOML: " + std::string(what),
          number ? "a number is written as 2, -0.5 or 1e-3, and none is as large as 1e308"
                 : "a line is KEY = VALUE, [TABLE] or a # comment; text stands in \"quotes\", lists in [brackets]"};
}

Result<SceneDocument> parse_toml(std::string_view text, const std::string& file_name, ReadLog& log) {
  if (text.size() > max_scene_bytes)
    return tl::unexpected(
        Error{file_name, 0, 0,
              fmt::format("the file is too large for a scene (expected at most {} MiB)", max_scene_bytes >> 20),
              "is this the right file?"});
  if (const auto fine = toml_text::check(text, file_name); !fine) return tl::unexpected(fine.error());
  const toml::parse_result parsed = toml::parse(text, std::string_view(file_name));
  if (!parsed) return tl::unexpected(syntax_error(parsed.error(), file_name));
  const toml::table& root = parsed.table();

  schema::SceneFile file;
  Scene& scene = file.scene;
  scene.camera.screen.width.reset();  // given by the file, or computed from the angle
  SceneReader reader(root, log, "");
  schema::describe(reader, file);
  reader.finish();
  if (!log.error()) {
    check_camera(scene.camera, root, log);
    check_image(scene.image, root, log);
    check_entries(scene, root, log);
    warn_of_bright_materials(scene, root, log);
    warn_of_idle_maps(scene, root, log);
  }
  if (log.error()) return tl::unexpected(*log.error());
  SceneDocument document{std::move(file.scene), std::string(text), log.warnings()};
  document.ink = std::move(file.ink);
  document.keeps_ink = !document.ink.empty();
  return document;
}

}  // namespace

Result<SceneDocument> parse_scene(std::string_view text, const std::string& file_name, MeshReading meshes) {
  ReadLog log(file_name, meshes == MeshReading::read);
  return parse_toml(text, file_name, log);
}

SceneFormat scene_format_of(std::string_view path) {
  for (int i = 0; i < scene_format_count; ++i)
    if (ends_with(path, scene_ending(static_cast<SceneFormat>(i)))) return static_cast<SceneFormat>(i);
  return SceneFormat::toml;
}

namespace {

bool is_mesh(SceneFormat format) { return format >= SceneFormat::ply; }

}  // namespace

bool has_scene_ending(std::string_view path) { return ends_with(path, scene_ending(scene_format_of(path))); }

namespace {

/// Said of what is wrong in a file whose ending is no scene's.
std::string why_toml() {
  std::string endings;
  for (int i = 0; i < scene_format_count; ++i)
    endings.append(i == 0 ? "" : ", ").append(scene_ending(static_cast<SceneFormat>(i)));
  return "; it is read as TOML, for its name has none of the endings " + endings;
}

Result<SceneDocument> read_format(const std::string& path, SceneFormat format) {
  if (is_mesh(format)) return scene_of_mesh(path);
  if (format == SceneFormat::toml) {
    auto text = read_scene_text(path);
    if (!text) return tl::unexpected(text.error());
    ReadLog log(path, true);
    const std::string_view mark = text->starts_with(utf8_mark) ? utf8_mark : std::string_view();
    auto document = parse_toml(std::string_view(*text).substr(mark.size()), path, log);
    if (!document) return document;
    document->text = std::move(*text);
    const std::string folder = path.substr(0, path.find_last_of('/') + 1);
    if (const auto loaded = load_textures(document->scene, folder); !loaded)
      return tl::unexpected(log.where_named(loaded.error()));
    return document;
  }
  const auto text = read_text(path, max_foreign_bytes);
  if (!text) return tl::unexpected(text.error());
  switch (format) {
    case SceneFormat::nff:
      return parse_nff(*text, path);
    case SceneFormat::test:
      return parse_test_format(*text, path);
    case SceneFormat::toml:
    case SceneFormat::ply:
    case SceneFormat::obj:
    case SceneFormat::gltf:
    case SceneFormat::glb:
      break;  // read above
  }
  return SceneDocument{};
}

}  // namespace

Result<std::string> read_scene_text(const std::string& path) {
  auto text = read_file(path, max_scene_bytes);
  if (!text) return text;
  const bool marked = text->starts_with(utf8_mark);
  if (const auto plain = make_plain_text(*text, path); !plain) return tl::unexpected(plain.error());
  if (marked) text->insert(0, utf8_mark);  // preserved when written
  return text;
}

Result<SceneDocument> read_scene(const std::string& path) {
  const FileLedger ledger(FileLedger::Notes::reading);
  Result<SceneDocument> document;
  try {
    document = read_format(path, scene_format_of(path));
  } catch (const std::bad_alloc&) {
    return tl::unexpected(Error{path, 0, 0, "there is not enough memory to read this, with the files that it names",
                                "close other programs, or use smaller meshes or textures"});
  }
  if (!document) {
    Error& error = document.error();
    if (error.line > 0 && !has_scene_ending(path)) error.hint += why_toml();
    return document;
  }
  if (is_empty(document->scene))
    document->warnings.push_back(
        path + ": warning: there is no object in this scene: a picture of it shows only the background; " +
        (scene_format_of(path) == SceneFormat::toml ? "add an [[object]], which `raywalk info --keys object` explains"
                                                    : "is the file cut short?"));
  document->path = path;
  document->files = ledger.files_read();
  return document;
}

}  // namespace raywalk
