#include "io/toml_layout.h"

#include "text/toml_text.h"

#include <algorithm>

namespace raywalk::detail {

namespace {

using Kind = LayoutNode::Kind;

struct KeyPart {
  std::string name;
  std::size_t begin;
};

class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {}

  std::optional<TomlLayout> scan() {
    constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
    if (text_.substr(0, 3) == byte_order_mark) at_ = 3;
    layout_.root.section = 0;
    layout_.sections.push_back({at_, at_, at_, at_});
    table_path_.clear();
    for (skip_blank(true); at_ < text_.size(); skip_blank(true)) {
      if (!(text_[at_] == '[' ? header() : entry(*table(), false))) return std::nullopt;
    }
    find_comments();
    return std::move(layout_);
  }

 private:
  [[nodiscard]] bool at(char c) const { return at_ < text_.size() && text_[at_] == c; }
  bool take(char c) {
    if (!at(c)) return false;
    ++at_;
    return true;
  }
  /// Skips blanks and, if `lines`, newlines and comments.
  void skip_blank(bool lines) {
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == ' ' || c == '\t' || (lines && (c == '\n' || c == '\r')))
        ++at_;
      else if (lines && c == '#')
        at_ = std::min(text_.find('\n', at_), text_.size());
      else
        return;
    }
  }

  /// A key, dotted or not; empty when there is none.
  std::vector<KeyPart> key() {
    std::vector<KeyPart> parts;
    do {
      skip_blank(false);
      const std::size_t begin = at_;
      if (at('"') || at('\'')) {
        at_ = toml_text::after_string(text_, at_);
        parts.push_back({std::string(text_.substr(begin + 1, at_ - begin - 2)), begin});
      } else {
        at_ = std::min(text_.find_first_of(" \t\r\n.=[]{},#\"'", at_), text_.size());
        if (at_ == begin) return {};
        parts.push_back({std::string(text_.substr(begin, at_ - begin)), begin});
      }
      skip_blank(false);
    } while (take('.'));
    return parts;
  }

  /// The table that the current section's keys belong to. Looked up each time, because nodes move when their lists
  /// grow.
  LayoutNode* table() {
    LayoutNode* node = &layout_.root;
    for (const std::string& name : table_path_) node = descend(*node, name);
    return node;
  }
  /// The table of this name in `node`, the last of several; created if new.
  static LayoutNode* descend(LayoutNode& node, const std::string& name) {
    LayoutNode* child = own_child(node, name);
    return child->kind == Kind::tables && !child->children.empty() ? &child->children.back() : child;
  }
  static LayoutNode* own_child(LayoutNode& node, const std::string& name) {
    for (LayoutNode& child : node.children)
      if (child.key == name) return &child;
    node.children.push_back({.key = name});
    return &node.children.back();
  }

  bool header() {
    const std::size_t begin = at_;
    take('[');
    const bool is_element = take('[');
    const std::vector<KeyPart> parts = key();
    if (parts.empty() || !take(']') || (is_element && !take(']'))) return false;
    table_path_.clear();
    for (const KeyPart& part : parts) table_path_.push_back(part.name);
    if (is_element) {
      LayoutNode* parent = &layout_.root;
      for (std::size_t i = 0; i + 1 < parts.size(); ++i) parent = descend(*parent, parts[i].name);
      LayoutNode* list = own_child(*parent, parts.back().name);
      list->kind = Kind::tables;
      list->children.emplace_back();
    }
    table()->section = layout_.sections.size();
    const std::size_t end = line_end(text_, at_);
    layout_.sections.push_back({begin, line_begin(text_, begin), end, end});
    at_ = end;
    return true;
  }

  bool entry(LayoutNode& parent, bool in_braces) {
    const std::size_t begin = at_;
    const std::vector<KeyPart> parts = key();
    if (parts.empty() || !take('=')) return false;
    skip_blank(false);
    LayoutNode* owner = &parent;
    for (std::size_t i = 0; i + 1 < parts.size(); ++i) owner = own_child(*owner, parts[i].name);
    LayoutNode node{.key = parts.back().name};
    if (!value(node)) return false;
    node.entry = {begin, at_};
    node.name_begin = parts.back().begin;
    owner->children.push_back(std::move(node));
    if (!in_braces) {
      Section& section = layout_.sections.back();
      section.body_end = section.own_end = line_end(text_, at_);
      at_ = section.body_end;
    }
    return true;
  }

  bool value(LayoutNode& node) {
    const std::size_t begin = at_;
    node.is_inline = true;
    if (at('"') || at('\'')) {
      node.kind = Kind::scalar;
      at_ = toml_text::after_string(text_, at_);
    } else if (take('[')) {
      node.kind = Kind::list;
      for (skip_blank(true); !take(']'); skip_blank(true)) {
        if (!value(node.children.emplace_back())) return false;
        skip_blank(true);
        node.trailing_comma = take(',');
        if (!node.trailing_comma && !at(']')) return false;
      }
    } else if (take('{')) {
      node.kind = Kind::table;
      for (skip_blank(true); !take('}'); skip_blank(true)) {
        if (!entry(node, true)) return false;
        skip_blank(true);
        if (!take(',') && !at('}')) return false;
      }
    } else {
      node.kind = Kind::scalar;
      at_ = std::min(text_.find_first_of(" \t\r\n,]}#", at_), text_.size());
      if (at_ == begin) return false;
    }
    node.value = {begin, at_};
    return true;
  }

  [[nodiscard]] bool is_comment_line(std::size_t begin) const {
    const std::size_t first = text_.find_first_not_of(" \t", begin);
    return first != std::string_view::npos && text_[first] == '#';
  }

  /// Assigns comment lines to the header below them, else to the keys above them; those between empty lines to neither.
  void find_comments() {
    std::vector<Section>& sections = layout_.sections;
    for (std::size_t i = 0; i < sections.size(); ++i) {
      if (i > 0) {
        std::size_t lead = sections[i].header_begin;
        const auto line_above = [&] { return std::max(line_begin(text_, lead - 1), sections[i - 1].body_end); };
        while (lead > sections[i - 1].body_end && is_comment_line(line_above())) lead = line_above();
        sections[i].lead_begin = lead;
      }
    }
    for (std::size_t i = 1; i < sections.size(); ++i) {
      const std::size_t limit = i + 1 < sections.size() ? sections[i + 1].lead_begin : text_.size();
      std::size_t& end = sections[i].own_end;
      while (end < limit && is_comment_line(end)) end = line_end(text_, end);
    }
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::vector<std::string> table_path_;
  TomlLayout layout_;
};

void collect_sections(const LayoutNode& node, std::vector<std::size_t>& sections) {
  if (node.section != no_section) sections.push_back(node.section);
  for (const LayoutNode& child : node.children) collect_sections(child, sections);
}

}  // namespace

const LayoutNode* LayoutNode::find(std::string_view child_key) const {
  const auto child =
      std::find_if(children.begin(), children.end(), [&](const LayoutNode& each) { return each.key == child_key; });
  return child == children.end() ? nullptr : &*child;
}

std::optional<TomlLayout> scan_toml(std::string_view text) { return Scanner(text).scan(); }

std::size_t line_begin(std::string_view text, std::size_t at) {
  if (at == 0) return 0;
  const std::size_t newline = text.rfind('\n', at - 1);
  return newline == std::string_view::npos ? 0 : newline + 1;
}

std::size_t line_end(std::string_view text, std::size_t at) {
  const std::size_t newline = text.find('\n', at);
  return newline == std::string_view::npos ? text.size() : newline + 1;
}

std::vector<std::size_t> sections_of(const LayoutNode& node) {
  std::vector<std::size_t> sections;
  collect_sections(node, sections);
  std::sort(sections.begin(), sections.end());
  return sections;
}

std::optional<std::string> TextEdits::apply(std::string_view text) const {
  std::vector<const Edit*> sorted;
  for (const Edit& edit : edits_) sorted.push_back(&edit);
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const Edit* a, const Edit* b) { return a->span.begin < b->span.begin; });
  std::string result;
  std::size_t at = 0;
  for (const Edit* edit : sorted) {
    if (edit->span.begin < at) return std::nullopt;
    result.append(text.substr(at, edit->span.begin - at)).append(edit->text);
    at = edit->span.end;
  }
  return result.append(text.substr(at));
}

}  // namespace raywalk::detail
