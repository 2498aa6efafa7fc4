// The names of the files that a scene uses, relative to another folder.

#include "io/scene_references.h"

#include "io/scene_file.h"
#include "text/toml_text.h"

#include <filesystem>
#include <optional>
#include <string>
#include <utility>

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
  void retell(std::string& name) {
    if (fs::path(name).is_absolute()) return;
    const fs::path file = from_ / name;
    // The file itself may be a link, which keeps its name.
    std::string retold = (real_folder(file) / file.filename()).lexically_relative(to_).generic_string();
    if (!error_ && !toml_text::check(toml_text::quoted(retold), ""))
      error_ = Error{"", 0, 0,
                     "\"" + name + "\" has no name that could be stated from here: one of the folders is not in UTF-8",
                     "write beside the scene that was read, or copy what it names to here first"};
    name = std::move(retold);
  }
  [[nodiscard]] const std::optional<Error>& error() const { return error_; }

 private:
  fs::path from_, to_;
  std::optional<Error> error_;
};

}  // namespace

Result<Scene> with_names_from(Scene scene, const std::string& from, const std::string& to) {
  PathRewriter retelling(from, to);
  if (from.empty() || !retelling.is_needed()) return scene;
  detail::each_file_name(scene, [&](std::string& file) { retelling.retell(file); });
  if (retelling.error()) return tl::unexpected(*retelling.error());
  return scene;
}

}  // namespace raywalk
