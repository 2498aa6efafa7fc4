#pragma once
// What the window shows, in words: for who does not see it. A browser's page mirrors it for assistive technology.

#include "view/action.h"
#include "view/cost/cost.h"

#include "text/error.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace raywalk {

struct OutlineItem {
  enum class Role {
    region,   ///< a part of the window, with its heading
    text,     ///< a paragraph
    news,     ///< a sentence to be read out when it changes
    warning,  ///< the same, at once
    list,     ///< of entries
    entry,    ///< of a list; may hold further items
    button,
    number,  ///< a field for a number
    words,   ///< a field for a text
    path,    ///< the same for a file, with a button that takes what stands in it
  };
  Role role = Role::text;
  std::string key;   ///< differs from those of its siblings, and stays while the item does
  std::string name;  ///< what it says
  /// Of a button or a field: the action's line (view/action_text.h), where `{}` stands for what is typed; or `command`
  /// and a command's name.
  std::string does{};
  std::string hint{};            ///< what a button does, in one clause; of a path: its button's name
  std::string value{};           ///< of a field
  bool enabled = true;           ///< of a button
  std::string leads_to{};        ///< of a button: the key of the region that has what it opens in the window
  std::optional<bool> chosen{};  ///< of a button that is on or off
  bool current = false;          ///< of an entry: the walk is here
  bool folded = false;           ///< of a region: shown by its heading alone until it is asked for
  std::vector<OutlineItem> items{};
};
template <>
inline constexpr Word<OutlineItem::Role> words_of<OutlineItem::Role>[] = {
    {OutlineItem::Role::region, "region"},   {OutlineItem::Role::text, "text"},     {OutlineItem::Role::news, "news"},
    {OutlineItem::Role::warning, "warning"}, {OutlineItem::Role::list, "list"},     {OutlineItem::Role::entry, "entry"},
    {OutlineItem::Role::button, "button"},   {OutlineItem::Role::number, "number"}, {OutlineItem::Role::words, "words"},
    {OutlineItem::Role::path, "path"}};

/// A window in words: its regions, in the order of reading.
using Outline = std::vector<OutlineItem>;

/// All but the commands, which gui/mirror.h adds: what is asked, or else the walk, the lesson, the code, the plan, and
/// the open tab. `costs`: what Cost has found.
[[nodiscard]] Outline outline(const State& state, const CostFindings* costs = nullptr);

/// The action of a button or field whose `does` this is, with what was typed; says in the state's language what is
/// wrong with that.
[[nodiscard]] Result<Action> outlined_action(const State& state, std::string_view does, std::string_view typed = {});

}  // namespace raywalk
