// PLY, the polygon file format of Greg Turk (1994).

#include "io/mesh_file.h"
#include "io/mesh_text.h"
#include "io/polygon_cut.h"
#include "scene/schema_kinds.h"
#include "text/text_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

namespace raywalk {

namespace {

enum class PlyScalar { int8, uint8, int16, uint16, int32, uint32, float32, float64 };
enum class Format { text, little, big };

constexpr std::array<std::size_t, 8> sizes{1, 1, 2, 2, 4, 4, 4, 8};
std::size_t size_of(PlyScalar type) { return sizes[static_cast<std::size_t>(type)]; }

std::optional<PlyScalar> scalar_named(std::string_view word) {
  constexpr std::array<std::array<std::string_view, 2>, 8> names{{{"char", "int8"},
                                                                  {"uchar", "uint8"},
                                                                  {"short", "int16"},
                                                                  {"ushort", "uint16"},
                                                                  {"int", "int32"},
                                                                  {"uint", "uint32"},
                                                                  {"float", "float32"},
                                                                  {"double", "float64"}}};
  for (std::size_t i = 0; i < names.size(); ++i)
    if (word == names[i][0] || word == names[i][1]) return static_cast<PlyScalar>(i);
  return std::nullopt;
}

struct Property {
  std::string name;
  PlyScalar type;
  std::optional<PlyScalar> count_type;  ///< of a list
};

struct PlyElement {
  std::string name;
  std::int64_t count;
  std::vector<Property> properties;
};

class PlyReader {
 public:
  PlyReader(std::string& bytes, const std::string& path) : bytes_(bytes), path_(path), cursor_(bytes) {}

  Result<MeshFile> read() {
    end_lines_with_lf(bytes_, 0, header_end());
    if (!read_header()) return tl::unexpected(*error_);
    at_ = cursor_.position();
    if (format_ == Format::text) end_lines_with_lf(bytes_, at_, bytes_.size());
    for (const PlyElement& element : elements_)
      if (element.name == "vertex")
        vertices_ = std::min<std::int64_t>(element.count, std::numeric_limits<std::int32_t>::max());
    for (const PlyElement& element : elements_)
      if (!read_element(element)) return tl::unexpected(*error_);
    if (!cut_waiting()) return tl::unexpected(*error_);
    if (normals_given_ < 3) mesh_.normals.clear();
    if (uv_given_ < 2) mesh_.uv.clear();
    if (const std::string why = detail::why_no_mesh(mesh_); !why.empty())
      return tl::unexpected(Error{path_, 0, 0, why, "the file is damaged, or its program wrote it wrongly"});
    MeshFile file = detail::finished_mesh(std::move(mesh_), path_);
    if (has_colours_) file.warnings.push_back(detail::warning_of_colours(path_));
    return file;
  }

 private:
  bool fail(const std::string& message, const std::string& hint = "is the file damaged or cut short?") {
    const bool in_text = format_ == Format::text;
    const std::string which = element_ == nullptr ? "" : fmt::format("{} {}: ", element_->name.substr(0, 40), index_);
    if (error_) return false;
    error_ = Error{path_, in_text ? cursor_.line() : 0, 0,
                   which + message + (in_text ? "" : fmt::format(" at byte {}", value_at_)), hint};
    if (element_ != nullptr && in_text && cursor_.line() > line_) end_of_text(false);
    if (misfit_) {
      misfit_->hint = fmt::format("what comes after it is read in the wrong place, up to line {}: {}", error_->line,
                                  error_->message);
      error_ = misfit_;
    }
    return false;
  }

  /// Before an element's first value.
  void begin(std::size_t index) {
    index_ = index;
    if (format_ != Format::text) return;
    cursor_.to_word();
    line_ = cursor_.line();
    values_ = in_line_ = 0;
  }
  /// After its last one: the first whose line has too few or too many values is to blame for what does not fit later. A
  /// file that is read to its end may break its lines as it likes.
  void end_of_text(bool complete) {
    const bool too_few = cursor_.line() > line_;
    if (misfit_ || (!too_few && cursor_.is_line_done())) return;
    const auto& all = element_->properties;
    const bool has_list =
        std::any_of(all.begin(), all.end(), [](const Property& each) { return each.count_type.has_value(); });
    const std::string expected = complete ? std::to_string(values_) : has_list ? "more" : std::to_string(all.size());
    misfit_ = Error{path_, line_, 0,
                    fmt::format("{} {}: its line has {}{} value{} (expected {}, by the header)",
                                element_->name.substr(0, 40), index_, too_few ? "" : "more than ",
                                too_few ? in_line_ : values_, (too_few ? in_line_ : values_) == 1 ? "" : "s", expected),
                    ""};
  }
  void end() {
    if (format_ == Format::text) end_of_text(true);
  }

  /// Where binary data begins: after the header's last line, which ends like its first.
  [[nodiscard]] std::size_t header_end() const {
    const std::size_t first = std::min(bytes_.find_first_of("\r\n"), bytes_.size());
    const bool lone_cr = bytes_.compare(first, 1, "\r") == 0 && bytes_.compare(first, 2, "\r\n") != 0;
    const std::size_t last = std::min(bytes_.find("end_header"), bytes_.size());
    return std::min(bytes_.find(lone_cr ? '\r' : '\n', last), bytes_.size() - 1) + 1;
  }

  bool read_header() {
    constexpr int max_lines = 1000;
    if (bytes_.empty()) return fail("the file is empty (expected a PLY file)", "is this the right file?");
    if (cursor_.word() != "ply")
      return fail("the file does not begin with \"ply\" (expected a PLY file)", "is this the right file?");
    bool has_format = false;
    for (int lines = 0; lines < max_lines && cursor_.next_line(); ++lines) {
      const std::string_view keyword = cursor_.word();
      if (keyword == "end_header") {
        if (!has_format) return fail("the header has no line \"format\" (expected one such as \"format ascii 1.0\")");
        cursor_.next_line();
        format_ = header_format_;
        return true;
      }
      if (keyword.empty() || keyword == "comment" || keyword == "obj_info") continue;
      if (keyword == "format") {
        const std::string_view word = cursor_.word();
        if (word != "ascii" && word != "binary_little_endian" && word != "binary_big_endian")
          return fail(fmt::format("format \"{}\" (expected ascii, binary_little_endian or binary_big_endian)",
                                  word.substr(0, 40)));
        header_format_ = word == "ascii" ? Format::text : word == "binary_little_endian" ? Format::little : Format::big;
        has_format = true;
      } else if (keyword == "element") {
        const std::string_view name = cursor_.word();
        const auto count = detail::whole_in(cursor_.word());
        if (!count || *count < 0) return fail("an element without a count (expected \"element NAME COUNT\")");
        const auto has_name = [&](const PlyElement& element) { return element.name == name; };
        if (std::any_of(elements_.begin(), elements_.end(), has_name))
          return fail(fmt::format("the element \"{}\" twice (expected each once)", name.substr(0, 40)));
        elements_.push_back({std::string(name), *count, {}});
      } else if (keyword == "property") {
        if (!read_property()) return false;
      } else {
        return fail(fmt::format("unknown word \"{}\" in the header (expected element, property, comment or end_header)",
                                keyword.substr(0, 40)));
      }
    }
    return fail("the header does not end (expected \"end_header\")");
  }

  bool read_property() {
    constexpr std::size_t most = 1000;
    if (elements_.empty())
      return fail("a property that belongs to no element (expected \"element NAME COUNT\" above it)");
    if (elements_.back().properties.size() >= most) return fail(fmt::format("more than {} properties", most));
    Property property{};
    std::string_view word = cursor_.word();
    if (word == "list") {
      property.count_type = scalar_named(cursor_.word());
      if (!property.count_type || *property.count_type >= PlyScalar::float32)
        return fail("a list without a type for its length (expected a whole-number type, such as uchar)");
      word = cursor_.word();
    }
    const auto type = scalar_named(word);
    if (!type)
      return fail(fmt::format("unknown type \"{}\" (expected char, uchar, short, ushort, int, uint, float or double)",
                              word.substr(0, 40)));
    property.type = *type;
    property.name = cursor_.word();
    elements_.back().properties.push_back(std::move(property));
    return true;
  }

  /// The next value of a property, or its list's length; NaN and an error at the end.
  double value(const Property& property, PlyScalar type) {
    if (format_ == Format::text) {
      const std::string_view word = cursor_.word_anywhere();
      const auto number = detail::number_in(word);
      if (!number)
        fail(word.empty() ? fmt::format("{}: the file ends too early (expected a number)", property.name)
                          : fmt::format("{}: \"{}\" is no finite number (expected one such as 1.5 or 2e-3)",
                                        property.name, word.substr(0, 40)));
      ++values_;
      if (cursor_.line() == line_) ++in_line_;
      return number.value_or(NAN);
    }
    value_at_ = at_;
    const std::size_t size = size_of(type);
    if (bytes_.size() - at_ < size) {
      fail(fmt::format("{}: the file ends too early (expected {} more byte{})", property.name, size,
                       size == 1 ? "" : "s"));
      return NAN;
    }
    std::array<unsigned char, 8> raw{};
    for (std::size_t i = 0; i < size; ++i)
      raw[format_ == Format::little ? i : size - 1 - i] = static_cast<unsigned char>(bytes_[at_ + i]);
    at_ += size;
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < size; ++i) bits |= std::uint64_t{raw[i]} << (8 * i);
    switch (type) {
      case PlyScalar::int8:
        return static_cast<std::int8_t>(bits);
      case PlyScalar::int16:
        return static_cast<std::int16_t>(bits);
      case PlyScalar::int32:
        return static_cast<std::int32_t>(bits);
      case PlyScalar::uint8:
      case PlyScalar::uint16:
      case PlyScalar::uint32:
        return static_cast<double>(bits);
      case PlyScalar::float32:
        return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
      case PlyScalar::float64:
        return std::bit_cast<double>(bits);
    }
    return NAN;
  }

  /// Whether the rest of the file can hold this many elements: nothing is allocated for a false count.
  bool can_hold(const PlyElement& element) {
    value_at_ = at_;
    std::size_t least = 0;
    for (const Property& property : element.properties)
      least += format_ == Format::text ? 2 : size_of(property.count_type.value_or(property.type));
    const std::size_t left = bytes_.size() - (format_ == Format::text ? cursor_.position() : at_) + 1;
    if (least == 0 || static_cast<std::uint64_t>(element.count) <= left / least) return true;
    return fail(fmt::format("the header says {} of \"{}\", more than the file can hold", element.count,
                            element.name.substr(0, 40)));
  }

  bool read_element(const PlyElement& element) {
    const bool is_vertices = element.name == "vertex";
    element_ = nullptr;
    if (element.properties.empty() && !is_vertices) return true;
    if (!can_hold(element)) return false;
    if (element.count > std::numeric_limits<std::int32_t>::max()) return fail("too many elements");
    const auto count = static_cast<std::size_t>(element.count);
    if (is_vertices) return read_vertices(element, count);
    element_ = &element;
    for (std::size_t i = 0; i < count; ++i) {
      begin(i);
      for (const Property& property : element.properties) {
        const bool is_corners = element.name == "face" && property.count_type &&
                                (property.name == "vertex_indices" || property.name == "vertex_index");
        if (is_corners ? !read_face(property) : !skip(property)) return false;
      }
      end();
    }
    return true;
  }

  bool read_vertices(const PlyElement& element, std::size_t count) {
    constexpr std::array<std::string_view, 8> names{"x", "y", "z", "nx", "ny", "nz", "u", "v"};
    constexpr std::array<std::string_view, 2> st{"s", "t"}, long_uv{"texture_u", "texture_v"};
    std::vector<int> slots;
    std::array<int, 8> given{};
    for (const Property& property : element.properties) {
      int slot = -1;
      has_colours_ = has_colours_ || property.name == "red";
      for (std::size_t i = 0; i < names.size(); ++i)
        if (property.name == names[i]) slot = static_cast<int>(i);
      for (std::size_t i = 0; i < 2; ++i)
        if (property.name == st[i] || property.name == long_uv[i]) slot = static_cast<int>(6 + i);
      if (property.count_type) slot = -1;
      if (slot >= 0) given[static_cast<std::size_t>(slot)] = 1;
      slots.push_back(slot);
    }
    if (given[0] + given[1] + given[2] < 3)
      return fail("the vertices have no place (expected the properties x, y and z)");
    normals_given_ = given[3] + given[4] + given[5];
    uv_given_ = given[6] + given[7];
    mesh_.positions.reserve(count);
    if (normals_given_ == 3) mesh_.normals.reserve(count);
    if (uv_given_ == 2) mesh_.uv.reserve(count);
    element_ = &element;
    for (std::size_t i = 0; i < count; ++i) {
      begin(i);
      std::array<double, 8> v{};
      for (std::size_t p = 0; p < slots.size(); ++p) {
        const Property& property = element.properties[p];
        if (slots[p] < 0) {
          if (!skip(property)) return false;
          continue;
        }
        const double number = v[static_cast<std::size_t>(slots[p])] = value(property, property.type);
        if (!error_ && !(std::abs(number) <= schema::max_magnitude))
          fail(fmt::format("{} is {:g} (expected a finite number, at most {:g})", property.name, number,
                           schema::max_magnitude));
        if (error_) return false;
      }
      end();
      mesh_.positions.emplace_back(v[0], v[1], v[2]);
      if (normals_given_ == 3) mesh_.normals.emplace_back(v[3], v[4], v[5]);
      if (uv_given_ == 2) mesh_.uv.emplace_back(v[6], v[7]);
    }
    return true;
  }

  /// A list's length, if the rest of the file can hold it.
  std::optional<std::size_t> length_of(const Property& property) {
    const double length = value(property, *property.count_type);
    if (error_) return std::nullopt;
    const std::size_t left = bytes_.size() - (format_ == Format::text ? cursor_.position() : at_);
    const std::size_t each = format_ == Format::text ? 1 : size_of(property.type);
    if (!(length >= 0 && length == std::floor(length) && length <= static_cast<double>(left / each))) {
      fail(fmt::format("{} is a list of {:g} values, which the file cannot hold", property.name, length));
      return std::nullopt;
    }
    return static_cast<std::size_t>(length);
  }

  bool skip(const Property& property) {
    std::size_t count = 1;
    if (property.count_type) {
      const auto length = length_of(property);
      if (!length) return false;
      count = *length;
    }
    for (std::size_t i = 0; i < count && !error_; ++i) static_cast<void>(value(property, property.type));
    return !error_;
  }

  bool read_face(const Property& property) {
    const auto length = length_of(property);
    if (!length) return false;
    if (*length < 3) return fail(fmt::format("it has {} corners (expected 3 or more)", *length));
    face_.clear();
    for (std::size_t i = 0; i < *length; ++i) {
      const double index = value(property, property.type);
      if (error_) return false;
      if (!(index >= 0 && index < static_cast<double>(vertices_) && index == std::floor(index)))
        return fail(fmt::format("it names vertex {:g} (expected {})", index,
                                vertices_ > 0 ? fmt::format("a whole number from 0 to {}", vertices_ - 1)
                                              : "\"element vertex COUNT\" in the header, for there are none"),
                    "vertices are counted from 0, in the order of the file");
      face_.push_back(static_cast<std::int32_t>(index));
    }
    const auto last = static_cast<std::size_t>(*std::max_element(face_.begin(), face_.end()));
    if (last < mesh_.positions.size())
      return detail::add_face(mesh_, face_) || fail(detail::too_many_corners(face_.size()), detail::hint_to_cut);
    waiting_.push_back(static_cast<std::int32_t>(face_.size()));
    waiting_.insert(waiting_.end(), face_.begin(), face_.end());
    return true;
  }

  /// The faces that stand above the vertices, of whose shape nothing was known until now.
  bool cut_waiting() {
    std::size_t number = 0;
    for (auto next = waiting_.begin(); next != waiting_.end(); next += static_cast<std::ptrdiff_t>(face_.size())) {
      const std::int32_t count = *next++;
      face_.assign(next, next + count);
      if (!detail::add_face(mesh_, face_)) {
        error_ = Error{path_, 0, 0, fmt::format("face {}: {}", number, detail::too_many_corners(face_.size())),
                       detail::hint_to_cut};
        return false;
      }
      ++number;
    }
    return true;
  }

  std::string& bytes_;
  const std::string& path_;
  detail::TextCursor cursor_;
  std::size_t at_ = 0, value_at_ = 0;  ///< of binary data: what is next, and the value that was read last
  Format format_ = Format::text, header_format_ = Format::text;
  std::vector<PlyElement> elements_;
  std::vector<std::int32_t> face_;     ///< vertices of the one that is read
  std::vector<std::int32_t> waiting_;  ///< of each face above the vertices: how many corners, and their vertices
  Mesh mesh_;
  int normals_given_ = 0, uv_given_ = 0;
  bool has_colours_ = false;
  std::int64_t vertices_ = 0;            ///< as the header counts them
  const PlyElement* element_ = nullptr;  ///< that is read
  std::size_t index_ = 0;                ///< of that element
  // As text: its first line, how many values it has so far, and how many of them in that line.
  int line_ = 0, values_ = 0, in_line_ = 0;
  std::optional<Error> misfit_;  ///< the first line that has too few or too many
  std::optional<Error> error_;
};

}  // namespace

Result<MeshFile> parse_ply(std::string bytes, const std::string& path) {
  if (const auto other = why_not_utf8(bytes, path)) return tl::unexpected(*other);
  drop_utf8_marks(bytes);
  return PlyReader(bytes, path).read();
}

}  // namespace raywalk
