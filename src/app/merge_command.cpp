#include "app/merge_command.h"

#include "app/part_file.h"
#include "app/render_command.h"
#include "image/image_file.h"
#include "text/file.h"

#include <fmt/format.h>

#include <memory>

namespace raywalk {

namespace {

/// The parts of a picture as they come.
class Merged {
 public:
  Result<void> add(const std::string& path, PicturePart part) {
    const auto number = static_cast<std::size_t>(part.share.part);
    const bool is_first = paths_.empty();
    if (is_first) {
      paths_.resize(static_cast<std::size_t>(part.share.of) + 1);
      first_ = path;
    } else if (auto why = why_another(path, part)) {
      return tl::unexpected(*why);
    }
    if (!paths_[number].empty())
      return tl::unexpected(
          Error{path, 0, 0, fmt::format("this is part {} of {}, and so is {}", number, part.share.of, paths_[number]),
                "leave one of them out"});
    paths_[number] = path;
    if (is_first) {
      whole_ = std::move(part);
      return {};
    }
    std::visit(
        [&]<class T>(Film<T>& film) {
          const auto& from = std::get<Film<T>>(part.film);
          Tiles(part.size).for_rows(part.share, [&](int row, int first, int columns) {
            for (int column = first; column < first + columns; ++column) film.set(column, row, from.at(column, row));
          });
        },
        whole_.film);
    return {};
  }

  [[nodiscard]] std::optional<Error> why_not_whole() const {
    std::string missing;
    int count = 0, first = 0;
    for (std::size_t part = 1; part < paths_.size(); ++part) {
      if (!paths_[part].empty()) continue;
      constexpr int most_named = 20;
      if (++count <= most_named) missing += (count > 1 ? ", " : "") + std::to_string(part);
      if (count == most_named + 1) missing += " ...";
      if (count == 1) first = static_cast<int>(part);
    }
    if (count == 0) return std::nullopt;
    const std::size_t of = paths_.size() - 1;
    return Error{"", 0, 0,
                 fmt::format("of {} parts, {} {} missing: {}; nothing was written", of, count,
                             count == 1 ? "is" : "are", missing),
                 fmt::format("render what is missing with --part {}/{} and all else as before", first, of)};
  }

  [[nodiscard]] Encoding encoding() const { return whole_.encoding; }
  /// The film of the pixels.
  [[nodiscard]] std::variant<Film<double>, Film<float>> film() && {
    if (!whole_.corners) return std::move(whole_.film);
    return std::visit(
        [](const auto& corners) -> std::variant<Film<double>, Film<float>> { return mean_of_corners(corners); },
        whole_.film);
  }

 private:
  /// Why a part is not of the same picture as the first one.
  [[nodiscard]] std::optional<Error> why_another(const std::string& path, const PicturePart& part) const {
    const auto differs = [&](const std::string& how) {
      return Error{path, 0, 0, fmt::format("this is no part of the same picture as {}: {}", first_, how),
                   "render all parts from the same files, with the same options but --part"};
    };
    if (part.share.of != whole_.share.of)
      return differs(fmt::format("of {} parts, not of {}", part.share.of, whole_.share.of));
    for (std::size_t i = 0; i < part.made_from.size() && i < whole_.made_from.size(); ++i) {
      const auto& [name, value] = part.made_from[i];
      const auto& [other_name, other] = whole_.made_from[i];
      if (name != other_name) break;
      if (value != other) return differs(fmt::format("{} here is {}, there {}", name, value, other));
    }
    if (part.made_from != whole_.made_from || part.size != whole_.size || part.corners != whole_.corners ||
        part.film.index() != whole_.film.index() || part.encoding != whole_.encoding)
      return differs("they were made from other files");
    return std::nullopt;
  }

  std::vector<std::string> paths_;  ///< by number, from 1; empty: not there yet
  std::string first_;
  PicturePart whole_;
};

}  // namespace

ExitCode merge_command(const MergeOptions& options) {
  Merged merged;
  for (const std::string& path : options.parts) {
    auto part = read_part(path);
    if (!part) return fail(part.error());
    if (const auto added = merged.add(path, std::move(*part)); !added) return fail(added.error());
  }
  if (const auto why = merged.why_not_whole()) return fail(*why);
  const Encoding encoding = merged.encoding();
  return std::visit(
      [&](const auto& film) {
        if (const auto written = write_image(options.image, image_of(film), encoding); !written)
          return fail(written.error());
        return fail_if_not_finite(options.image, not_finite(film));
      },
      std::move(merged).film());
}

void declare_merge(CLI::App& program, Run& run) {
  CLI::App& command = *program.add_subcommand("merge", "Make one picture of the parts that render --part wrote");
  const auto options = std::make_shared<MergeOptions>();
  MergeOptions& to = *options;
  command.add_option("PART", to.parts, "All parts of the picture, in any order")->required()->type_name("");
  add_image(command, to.image, "The picture: .png (8-bit), or .pfm and .exr (linear float)")->required();
  command.footer(
      "The picture has the very bits that it has when one machine renders all of it. What is missing, damaged, or of\n"
      "another picture is named, and then nothing is written.\n\n"
      "Examples:\n"
      "  for i in 1 2 3; do raywalk render cornell -o cornell.exr --part $i/3 || break; done\n"
      "  raywalk merge cornell.exr.part-* -o cornell.exr");
  command.callback([options, &run] { run = [options] { return merge_command(*options); }; });
}

}  // namespace raywalk
