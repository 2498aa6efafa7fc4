#include "io/scene_merge.h"

#include "io/scene_rearrange.h"

#include <algorithm>
#include <string>

namespace raywalk::detail {

using Kind = Value::Kind;
using Shorthand = Value::Shorthand;

namespace {

class Merger {
 public:
  Merger(const TomlLayout& layout, std::string_view text, TextEdits& edits)
      : layout_(layout), text_(text), edits_(edits) {}

  /// `path` is the header's name of `node`.
  void merge(const LayoutNode& node, const Value& old, const Value& now, const std::string& path) {
    if (old == now) return;
    switch (now.kind) {
      case Kind::scalar:
        return edits_.replace(node.value, now.text);
      case Kind::list:
        return merge_list(node, old, now);
      case Kind::table:
        return merge_table(node, old, now, path);
      case Kind::tables:
        for (std::size_t i = 0; i < now.children.size(); ++i)
          merge(node.children[i], old.children[i], now.children[i], path);
    }
  }

 private:
  void merge_list(const LayoutNode& node, const Value& old, const Value& now) {
    const std::size_t count = node.children.size();
    const bool is_short = count < old.children.size();
    const bool grows = is_short && now.shorthand == Shorthand::flat && now.children.back().text != "0";
    if (node.kind != LayoutNode::Kind::list) return edits_.replace(node.value, inline_text(now));  // a grey
    if (old.children.size() != now.children.size()) {
      const Origins origins = continued(old, now);
      rearrange_list(text_, node, now, origins, edits_);
      for (std::size_t i = 0; i < origins.size(); ++i)
        if (origins[i]) merge(node.children[*origins[i]], old.children[*origins[i]], now.children[i], "");
      return;
    }
    for (std::size_t i = 0; i < count; ++i) merge(node.children[i], old.children[i], now.children[i], "");
    if (grows) edits_.insert(node.children.back().value.end, ", " + now.children.back().text);
  }

  /// Elements are matched with equal ones from the front and from the back, then in order in between.
  static Origins continued(const Value& old, const Value& now) {
    const auto &olds = old.children, &news = now.children;
    const std::size_t shorter = std::min(olds.size(), news.size());
    Origins origins(news.size());
    std::size_t front = 0, back = 0;
    for (; front < shorter && olds[front] == news[front]; ++front) origins[front] = front;
    for (; back < shorter - front && olds[olds.size() - 1 - back] == news[news.size() - 1 - back]; ++back)
      origins[news.size() - 1 - back] = olds.size() - 1 - back;
    for (std::size_t i = front; i < shorter - back; ++i) origins[i] = i;
    return origins;
  }

  void merge_table(const LayoutNode& node, const Value& old, const Value& now, const std::string& path) {
    const auto is_stated = [&](const Value& child) { return node.find(child.key) != nullptr; };
    const auto is_new = [&](const Value& child) {
      const Value* before = old.find(child.key);
      return !is_stated(child) && (before == nullptr || !(*before == child) || before->must_now_be_stated(child));
    };
    const auto is_gone = [&](const Value& child) { return is_stated(child) && now.find(child.key) == nullptr; };
    const bool changes_keys = std::any_of(now.children.begin(), now.children.end(), is_new) ||
                              std::any_of(old.children.begin(), old.children.end(), is_gone);
    if (node.is_inline && changes_keys) return edits_.replace(node.value, inline_text(now));

    // Keys before tables, and into tables that there are before new ones: a line that is added after a header belongs
    // to that header's table.
    enum class Turn { keys, tables, new_tables };
    for (const Turn turn : {Turn::keys, Turn::tables, Turn::new_tables})
      for (const Value& child : now.children) {
        const LayoutNode* stated = node.find(child.key);
        const Value* before = old.find(child.key);
        const bool is_there = stated != nullptr && before != nullptr;
        if (turn != (child.kind != Kind::table ? Turn::keys : is_there ? Turn::tables : Turn::new_tables)) continue;
        if (is_there && child.kind == Kind::tables && before->children.size() != child.children.size())
          state_anew(node, *stated, now, child, path);
        else if (is_there)
          merge(*stated, *before, child, path.empty() ? child.key : path + "." + child.key);
        else if (is_new(child))
          add(node, now, child, path);
      }
    for (const Value& child : old.children)
      if (is_gone(child)) remove(*node.find(child.key));
  }

  /// Tables within a table, of which there are now more or fewer.
  void state_anew(const LayoutNode& node, const LayoutNode& stated, const Value& table, const Value& child,
                  const std::string& path) {
    if (stated.is_inline) return edits_.replace(stated.value, inline_text(child));
    remove(stated);
    if (!child.children.empty()) add(node, table, child, path);
  }

  void add(const LayoutNode& node, const Value& table, const Value& child, const std::string& path) {
    const LayoutNode* sibling = sibling_before(node, table, child);
    const bool is_dotted = node.section == no_section && sibling != nullptr;
    if (child.kind == Kind::table && !is_dotted) return add_section(node, child, path);
    if (sibling != nullptr) {
      // Written like the key above it, with the same indentation and the same dotted prefix.
      const std::size_t begin = line_begin(text_, sibling->entry.begin);
      const std::string start(text_.substr(begin, sibling->name_begin - begin));
      return edits_.insert(line_end(text_, sibling->entry.end), start + line_of(child));
    }
    if (node.section == no_section) {
      // Only tables within this one have headers: its own is inserted before them.
      const std::vector<std::size_t> inner = sections_of(node);
      const std::size_t at = inner.empty() ? text_.size() : layout_.sections[inner.front()].lead_begin;
      const std::string opened = opened_ == &node ? "" : "[" + path + "]\n";
      opened_ = &node;
      return edits_.insert(at, opened + line_of(child));
    }
    const Section& section = layout_.sections[node.section];
    // If a file begins with a header, its comments belong to that header; keys go before them.
    const std::size_t at = node.section == 0 && layout_.sections.size() > 1 && section.body_end == section.lead_begin
                               ? layout_.sections[1].lead_begin
                               : section.body_end;
    edits_.insert(at, line_of(child));
  }

  static std::string line_of(const Value& child) { return child.key + " = " + inline_text(child) + "\n"; }

  void add_section(const LayoutNode& node, const Value& child, const std::string& path) {
    const std::string name = path.empty() ? child.key : path + "." + child.key;
    const std::string lines = "[" + name + "]\n" + section_text(child, name);
    if (!path.empty()) return edits_.insert(layout_.sections[sections_of(node).back()].own_end, lines);
    // Before the lights and objects, which readers expect last.
    std::size_t at = text_.size();
    for (const LayoutNode& top : node.children)
      if (top.kind == LayoutNode::Kind::tables && !top.is_inline && !top.children.empty())
        at = std::min(at, layout_.sections[top.children.front().section].lead_begin);
    edits_.insert(at, at == text_.size() ? "\n" + lines : lines + "\n");
  }

  /// The nearest key before `child`, in the order of a new file, that has its own line in this table; else any such
  /// key.
  static const LayoutNode* sibling_before(const LayoutNode& node, const Value& table, const Value& child) {
    const LayoutNode* nearest = nullptr;
    for (const Value& each : table.children) {
      if (each.key == child.key && nearest != nullptr) break;
      const LayoutNode* stated = node.find(each.key);
      if (stated != nullptr && stated->has_entry()) nearest = stated;
    }
    return nearest;
  }

  void remove(const LayoutNode& node) {
    if (node.has_entry()) {
      edits_.remove({line_begin(text_, node.entry.begin), line_end(text_, node.entry.end)});
    } else {
      if (node.section != no_section)
        edits_.remove({layout_.sections[node.section].lead_begin, layout_.sections[node.section].own_end});
      for (const LayoutNode& child : node.children)
        if (node.section == no_section || !child.has_entry()) remove(child);
    }
  }

  const TomlLayout& layout_;
  std::string_view text_;
  TextEdits& edits_;
  const LayoutNode* opened_ = nullptr;  ///< the table whose header add() has just inserted
};

}  // namespace

void merge_values(const TomlLayout& layout, std::string_view text, const Value& old, const Value& now,
                  TextEdits& edits) {
  Merger(layout, text, edits).merge(layout.root, old, now, "");
}

}  // namespace raywalk::detail
