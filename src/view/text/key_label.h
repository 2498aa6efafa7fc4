#pragma once

#include "text/language.h"

#include <string>
#include <string_view>

namespace raywalk {

/// The words beside a field, and what they mean.
class KeyLabel {
 public:
  KeyLabel(const char* id) : id_(id) {}       // NOLINT: stands for its words
  KeyLabel(std::string_view id) : id_(id) {}  // NOLINT
  /// {number} is the number.
  KeyLabel(std::string_view id, int number) : id_(id), number_(number) {}
  /// A key of a scene: "property.TABLE_KEY" where there is such a text, else "property.KEY"; without either it is said
  /// by its name and the schema's sentence.
  KeyLabel(std::string_view table, std::string_view key, std::string_view sentence)
      : id_(key), table_(table), sentence_(sentence) {}
  KeyLabel(const KeyLabel& list, int number) : KeyLabel(list) { number_ = number; }
  [[nodiscard]] std::string words(Language language) const;
  /// May be empty.
  [[nodiscard]] std::string hint(Language language) const;

 private:
  [[nodiscard]] std::string id_in(Language language) const;

  std::string_view id_;
  std::string_view table_{}, sentence_{};
  int number_ = 0;
};

}  // namespace raywalk
