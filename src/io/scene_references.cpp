// The names of the files that a scene uses, relative to another folder.

#include "io/scene_file.h"
#include "text/toml_text.h"

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace raywalk {

namespace {

namespace fs = std::filesystem;

/// The folder of a file with all links resolved: only from there ".." leads where it seems to.
fs::path real_folder(const fs::path& file) {
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  std::error_code failed;
  const fs::path real = fs::weakly_canonical(fs::absolute(folder, failed), failed);
  return failed ? folder : real;
}

/// Rewrites names; keeps the first that a scene cannot contain.
class PathRewriter {
 public:
  PathRewriter(const std::string& from, const std::string& to) : from_(real_folder(from)), to_(real_folder(to)) {}

  [[nodiscard]] bool is_needed() const { return from_ != to_; }
  void retell(std::optional<Sky>& sky) {
    if (!sky) return;
    if (auto* image = std::get_if<ImageSky>(&sky->kind)) retell(image->file);
  }
  void retell(std::vector<Object>& objects) {
    for (Object& object : objects) {
      if (auto* mesh = std::get_if<MeshShape>(&object.shape)) retell(mesh->file);
      if (object.material.texture) retell(object.material.texture->file);
      each_map(object.material, [this](MapImage& map, bool /*colour*/) { retell(map.file); });
    }
  }
  [[nodiscard]] const std::optional<Error>& error() const { return error_; }

 private:
  void retell(std::string& name) {
    if (name.empty() || fs::path(name).is_absolute()) return;
    const fs::path file = from_ / name;
    // The file itself may be a link, which keeps its name.
    std::string retold = (real_folder(file) / file.filename()).lexically_relative(to_).generic_string();
    if (!error_ && !toml_text::check(toml_text::quoted(retold), ""))
      error_ = Error{"", 0, 0,
                     "\"" + name + "\" has no name that could be stated from here: one of the folders is not in UTF-8",
                     "write beside the scene that was read, or copy what it names to here first"};
    name = std::move(retold);
  }

  fs::path from_, to_;
  std::optional<Error> error_;
};

}  // namespace

Result<Scene> with_names_from(Scene scene, const std::string& from, const std::string& to) {
  PathRewriter retelling(from, to);
  if (from.empty() || !retelling.is_needed()) return scene;
  retelling.retell(scene.sky);
  retelling.retell(scene.objects);
  for (Group& group : scene.groups) retelling.retell(group.objects);
  if (retelling.error()) return tl::unexpected(*retelling.error());
  return scene;
}

}  // namespace raywalk
