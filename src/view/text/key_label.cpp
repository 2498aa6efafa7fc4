#include "view/text/key_label.h"

#include "view/text/text.h"

namespace raywalk {

std::string KeyLabel::id_in(Language language) const {
  if (table_.empty()) return std::string(id_);
  const std::string key(id_), own = "property." + std::string(table_) + "_" + key;
  return language.catalogue().find(own) != nullptr ? own : "property." + key;
}

std::string KeyLabel::words(Language language) const {
  const std::string id = id_in(language);
  if (!table_.empty() && language.catalogue().find(id) == nullptr) return std::string(id_);
  return fill(id, language, {{"number", number_}});
}

std::string KeyLabel::hint(Language language) const {
  const std::string_view known = explanation(id_in(language), language);
  return std::string(known.empty() ? sentence_ : known);
}

}  // namespace raywalk
