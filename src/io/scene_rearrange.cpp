#include "io/scene_rearrange.h"

#include <algorithm>
#include <map>

namespace raywalk::detail {

namespace {

const std::string& text_of(const Value& table, std::string_view key) {
  static const std::string nothing;
  const Value* child = table.find(key);
  return child == nullptr ? nothing : child->text;
}

/// The number of values of `a` besides name and type, and how many of them `b` shares.
struct Similarity {
  std::size_t values = 0, same = 0;
};
Similarity compare(const Value& a, const Value& b) {
  Similarity likeness;
  for (const Value& child : a.children) {
    if (child.key == "name" || child.key == "type") continue;
    ++likeness.values;
    const Value* other = b.find(child.key);
    if (other != nullptr && *other == child) ++likeness.same;
  }
  return likeness;
}

std::string_view part(std::string_view text, Span span) { return text.substr(span.begin, span.end - span.begin); }

/// The leading blanks of the line of `at`.
std::string_view indentation(std::string_view text, std::size_t at) {
  const std::size_t begin = line_begin(text, at);
  return text.substr(begin, std::min(text.find_first_not_of(" \t", begin), text.size()) - begin);
}

bool is_first_in_line(std::string_view text, std::size_t at) {
  return line_begin(text, at) + indentation(text, at).size() == at;
}

bool is_empty_line(std::string_view text, std::size_t begin) {
  const std::size_t first = text.find_first_not_of(" \t\r", begin);
  return first == std::string_view::npos || text[first] == '\n';
}

/// The text spans of a table with its sub-tables, adjacent ones joined.
std::vector<Span> spans_of(const TomlLayout& layout, const LayoutNode& table) {
  std::vector<Span> spans;
  std::size_t previous = no_section;
  for (const std::size_t i : sections_of(table)) {
    const Section& section = layout.sections[i];
    if (!spans.empty() && previous + 1 == i)
      spans.back().end = section.own_end;
    else
      spans.push_back({section.lead_begin, section.own_end});
    previous = i;
  }
  return spans;
}

/// `span` with the empty lines below it, if an empty line or nothing remains above it.
Span with_gap(std::string_view text, Span span) {
  if (span.begin > 0 && !is_empty_line(text, line_begin(text, span.begin - 1))) return span;
  while (span.end < text.size() && is_empty_line(text, span.end)) span.end = line_end(text, span.end);
  return span;
}

}  // namespace

Origins pair_up(const Value& old_tables, const Value& new_tables) {
  const auto& olds = old_tables.children;
  const auto& news = new_tables.children;
  Origins origins(news.size());
  std::vector<bool> taken(olds.size());
  const auto pair = [&](std::size_t now, std::size_t old) {
    origins[now] = old;
    taken[old] = true;
  };
  std::map<std::string_view, std::size_t> by_name;
  for (std::size_t i = 0; i < olds.size(); ++i)
    if (olds[i].find("name") != nullptr) by_name.emplace(text_of(olds[i], "name"), i);
  for (std::size_t i = 0; i < news.size(); ++i)
    if (const auto found = by_name.find(text_of(news[i], "name")); found != by_name.end()) pair(i, found->second);

  // Few are left: renamed, added or removed since the file was last written.
  for (const bool exactly : {true, false}) {
    for (std::size_t i = 0; i < news.size(); ++i) {
      for (std::size_t j = 0; j < olds.size() && !origins[i]; ++j) {
        if (taken[j] || text_of(olds[j], "type") != text_of(news[i], "type")) continue;
        const Similarity likeness = compare(news[i], olds[j]);
        if (exactly ? likeness.same == likeness.values : i == j && 2 * likeness.same >= likeness.values) pair(i, j);
      }
    }
  }
  return origins;
}

bool is_unchanged(const Origins& origins, std::size_t old_count) {
  if (origins.size() != old_count) return false;
  for (std::size_t i = 0; i < origins.size(); ++i)
    if (origins[i] != i) return false;
  return true;
}

void rearrange_tables(const TomlLayout& layout, std::string_view text, const LayoutNode* tables, const Value& now,
                      const Origins& origins, TextEdits& edits) {
  const auto new_text = [&](std::size_t i) { return "[[" + now.key + "]]\n" + section_text(now.children[i], now.key); };
  if (tables == nullptr || tables->children.empty()) {
    for (std::size_t i = 0; i < origins.size(); ++i) edits.insert(text.size(), "\n" + new_text(i));
    return;
  }
  std::vector<std::vector<Span>> spans;
  for (const LayoutNode& table : tables->children) spans.push_back(spans_of(layout, table));

  // The remaining tables, in their old order, are the slots; the new order says which goes where.
  std::vector<bool> stays(spans.size());
  for (const auto& origin : origins)
    if (origin) stays[*origin] = true;
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < spans.size(); ++i)
    if (stays[i]) places.push_back(i);

  std::size_t next_place = 0;
  for (std::size_t i = 0; i < origins.size(); ++i) {
    if (!origins[i]) {
      if (next_place > 0)
        edits.insert(spans[places[next_place - 1]].back().end, "\n" + new_text(i));
      else
        edits.insert(spans.front().front().begin, new_text(i) + "\n");
      continue;
    }
    const std::size_t place = places[next_place++];
    if (place == *origins[i]) continue;
    std::string moved;
    for (const Span& span : spans[*origins[i]]) moved += part(text, span);
    edits.replace(spans[place].front(), moved);
    for (std::size_t k = 1; k < spans[place].size(); ++k) edits.remove(spans[place][k]);
  }
  std::vector<Span> gone;
  for (std::size_t i = 0; i < spans.size(); ++i) {
    if (stays[i]) continue;
    for (const Span& span : spans[i]) {
      const Span whole = with_gap(text, span);
      if (!gone.empty() && gone.back().end == whole.begin)
        gone.back().end = whole.end;
      else
        gone.push_back(whole);
    }
  }
  // What stood last leaves no empty lines at the end, unless something new goes there.
  const bool adds = std::any_of(origins.begin(), origins.end(), [](const auto& origin) { return !origin; });
  if (!adds && !gone.empty() && gone.back().end == text.size()) {
    std::size_t& begin = gone.back().begin;
    while (begin > 0 && is_empty_line(text, line_begin(text, begin - 1))) begin = line_begin(text, begin - 1);
  }
  for (const Span& span : gone) edits.remove(span);
}

void rearrange_list(std::string_view text, const LayoutNode& list, const Value& now, const Origins& origins,
                    TextEdits& edits) {
  const auto& olds = list.children;
  // The elements that keep their place: those still in ascending order, from the first on.
  std::vector<bool> keeps(origins.size());
  std::vector<bool> stays(olds.size());
  std::size_t least = 0;
  for (std::size_t i = 0; i < origins.size(); ++i) {
    keeps[i] = origins[i] && *origins[i] >= least;
    if (!keeps[i]) continue;
    stays[*origins[i]] = true;
    least = *origins[i] + 1;
  }
  if (least == 0) return edits.replace(list.value, inline_text(now));

  const auto element_text = [&](std::size_t i) {
    return origins[i] ? std::string(part(text, olds[*origins[i]].value)) : inline_text(now.children[i]);
  };
  const std::size_t last_kept = least - 1, last = olds.size() - 1, bracket = list.value.end - 1;
  const bool bracket_stands_alone = is_first_in_line(text, bracket);
  for (std::size_t i = 0; i < origins.size(); ++i) {
    if (keeps[i]) continue;
    std::size_t next = i;
    while (next < origins.size() && !keeps[next]) ++next;
    if (next < origins.size()) {
      const std::size_t at = olds[*origins[next]].value.begin;
      const bool own_line = is_first_in_line(text, at);
      edits.insert(at, element_text(i) + (own_line ? ",\n" + std::string(indentation(text, at)) : ", "));
    } else if (bracket_stands_alone && last_kept == last) {
      // A comment after the last element stays there.
      const bool comma = list.trailing_comma || (i > 0 && !keeps[i - 1]);
      if (!comma) edits.insert(olds[last].value.end, ",");
      edits.insert(line_begin(text, bracket),
                   std::string(indentation(text, olds[last].value.begin)) + element_text(i) + ",\n");
    } else {
      edits.insert(olds[last_kept].value.end, ", " + element_text(i));
    }
  }
  for (std::size_t j = 0; j < last_kept; ++j)
    if (!stays[j]) edits.remove({olds[j].value.begin, olds[j + 1].value.begin});
  if (last_kept < last) edits.remove({olds[last_kept].value.end, olds[last].value.end});
}

}  // namespace raywalk::detail
