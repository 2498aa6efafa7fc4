// Saving a scene loses nothing: random edits of random scenes with comments all over.

#include <map>
#include <set>
#include <vector>

#include "io/scene_file.h"
#include "io/scene_values.h"
#include "random_scene.h"
#include "support/catch.h"
#include "support/effort.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

/// A comment in a decorated text, and to whom it belongs: to a key of a table, to a table, or to nobody.
struct Comment {
  std::string text;
  std::string table;  ///< the name of the light or object, "" outside of these
  std::string path;   ///< "camera.eye"; the table's own for comments above its header
};

struct Decorated {
  std::string text;
  std::vector<Comment> comments;
};

/// `text`, which is a tidy scene, with comments in every place where one may stand.
Decorated decorate(const std::string& text, Random& random) {
  Decorated result;
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = text.find('\n', at);
    lines.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  std::string header, table;
  const auto comment = [&](const std::string& owner_table, const std::string& path) {
    const std::string words = "# comment " + std::to_string(result.comments.size()) + " = [\"x\"] #";
    result.comments.push_back({words, owner_table, path});
    return words;
  };
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string& line = lines[i];
    if (!line.empty() && line[0] == '[') {
      header = line.substr(line.find_last_of('[', 1) + 1);
      header = header.substr(0, header.find(']'));
      const bool element = line[1] == '[';
      if (element) table = lines[i + 1];
      const bool within = header.find('.') != std::string::npos;
      if (!within && !element) table.clear();
      // Set apart by an empty line it belongs to nothing, except inside of a light or object.
      if (random.chance(0.4)) result.text += (within ? comment(table, header) : comment("", "")) + "\n\n";
      if (random.chance(0.5)) result.text += comment(table, header) + "\n";
      result.text += line + (random.chance(0.5) ? " \t" + comment(table, header) : "") + "\n";
    } else if (line.empty() || line[0] == ' ' || line[0] == ']') {
      result.text += line + "\n";
    } else {
      const std::string key = (header.empty() ? "" : header + ".") + line.substr(0, line.find(' '));
      if (random.chance(0.2)) result.text += "  " + comment(table, header) + "\n";
      result.text += line + (random.chance(0.5) ? "   " + comment(table, key) : "") + "\n";
    }
  }
  result.text += "\n" + comment("", "") + "\n";
  return result;
}

/// Every "path" of a scene's tables and keys, those of lights and objects under their name; but for maps, which have
/// none.
void collect_paths(const detail::Value& value, const std::string& table, const std::string& path,
                   std::set<std::pair<std::string, std::string>>& paths) {
  if (value.kind == detail::Value::Kind::tables && !value.children.empty() && !value.children[0].find("name")) return;
  paths.insert({table, path});
  for (const detail::Value& child : value.children) {
    if (value.kind == detail::Value::Kind::tables) {
      collect_paths(child, "name = " + child.find("name")->text, path, paths);
    } else if (!child.key.empty()) {
      collect_paths(child, table, path.empty() ? child.key : path + "." + child.key, paths);
    }
  }
}

std::size_t occurrences(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

/// Comments of what is still there must be there exactly once.
std::string first_lost_comment(const Decorated& before, const std::string& after, const Scene& scene,
                               const std::map<std::string, std::string>& renamed) {
  std::set<std::pair<std::string, std::string>> paths;
  collect_paths(detail::values_of(scene), "", "", paths);
  for (const Comment& comment : before.comments) {
    const auto new_name = renamed.find(comment.table);
    const std::string& table = new_name == renamed.end() ? comment.table : new_name->second;
    const bool stays = paths.count({table, comment.path}) > 0;
    if (stays && occurrences(after, comment.text) != 1) return comment.text + " of " + table + " " + comment.path;
  }
  return {};
}

std::string quoted_name(const std::string& name) {
  Scene scene;
  scene.lights.push_back({name, Rgbd(1.0), PointLight{}});
  return "name = " + detail::values_of(scene).find("light")->children[0].find("name")->text;
}

}  // namespace

TEST_CASE("a new file reads back as the same scene, bit for bit") {
  Random random(1);
  for (int round = 0; round < rounds(2000); ++round) {
    const Scene scene = random_scene(random);
    const auto text = format_scene(scene);
    INFO("round " << round << "\n" << (text ? *text : text.error().text()));
    REQUIRE(text);
    const auto back = parse_scene(*text, "new.toml");
    INFO((back ? "" : back.error().text()));
    REQUIRE(back);
    REQUIRE(same_bits(back->scene, scene));
  }
}

TEST_CASE("an unchanged scene is written as the very same text") {
  Random random(2);
  for (int round = 0; round < rounds(300); ++round) {
    const Scene scene = random_scene(random);
    const Decorated before = decorate(*format_scene(scene), random);
    INFO("round " << round << "\n" << before.text);
    const auto document = parse_scene(before.text, "same.toml");
    INFO((document ? "" : document.error().text()));
    REQUIRE(document);
    REQUIRE(same_bits(document->scene, scene));
    REQUIRE(format_scene(document->scene, document->text) == before.text);
  }
}

TEST_CASE("edits keep the comments of everything that is still there") {
  Random random(3);
  for (int round = 0; round < rounds(2000); ++round) {
    Scene scene = random_scene(random);
    const Decorated before = decorate(*format_scene(scene), random);
    for (std::size_t edits = 1 + random.below(4); edits > 0; --edits) change_something(scene, random);
    // At most one of: add, remove, move, rename, so that nobody can doubt what became of what.
    std::map<std::string, std::string> renamed;
    const std::size_t objects = scene.objects.size();
    switch (random.below(6)) {
      case 0:
        scene.objects.insert(scene.objects.begin() + static_cast<std::ptrdiff_t>(random.below(objects + 1)),
                             random_object(random, "a new object"));
        break;
      case 1:
        if (objects > 0)
          scene.objects.erase(scene.objects.begin() + static_cast<std::ptrdiff_t>(random.below(objects)));
        break;
      case 2:
        if (objects > 1) std::swap(scene.objects[random.below(objects)], scene.objects[random.below(objects)]);
        break;
      case 3:
        if (!scene.lights.empty()) {
          if (random.chance(0.5)) scene.lights.pop_back();
        } else {
          scene.lights.push_back(random_light(random, "a new light"));
        }
        break;
      case 4: {
        // Only renamed: with half of its values changed too it would be a new object.
        scene = parse_scene(before.text, "")->scene;
        if (objects == 0) break;
        Object& object = scene.objects[random.below(objects)];
        renamed[quoted_name(object.name)] = quoted_name("a new name");
        object.name = "a new name";
        break;
      }
      default:
        break;
    }
    INFO("round " << round << "\n" << before.text);
    const auto after = format_scene(scene, before.text);
    INFO((after ? *after : after.error().text()));
    REQUIRE(after);
    const auto back = parse_scene(*after, "edited.toml");
    INFO((back ? "" : back.error().text()));
    REQUIRE(back);
    REQUIRE(same_bits(back->scene, scene));
    REQUIRE(first_lost_comment(before, *after, scene, renamed) == "");
  }
}

TEST_CASE("any number of edits at once reads back as the edited scene") {
  Random random(4);
  for (int round = 0; round < rounds(1000); ++round) {
    const Decorated before = decorate(*format_scene(random_scene(random)), random);
    const Scene scene = random_scene(random);  // shares names with the other by chance
    const auto after = format_scene(scene, before.text);
    INFO("round " << round << "\n" << before.text << "\n----\n" << (after ? *after : after.error().text()));
    REQUIRE(after);
    const auto back = parse_scene(*after, "edited.toml");
    INFO((back ? "" : back.error().text()));
    REQUIRE(back);
    REQUIRE(same_bits(back->scene, scene));
    // The comment at the end belongs to nobody, so it shows that the old text was edited and not thrown away.
    REQUIRE(occurrences(*after, before.comments.back().text) == 1);
  }
}
