#include "gui/names.h"

namespace raywalk {

std::string_view name_of(Question::Kind kind) {
  switch (kind) {
    case Question::Kind::unsaved:
      return "unsaved";
    case Question::Kind::recover:
      return "recover";
    case Question::Kind::overwrite:
      return "overwrite";
  }
  return "";
}

std::string_view name_of(PathPrompt prompt) {
  switch (prompt) {
    case PathPrompt::none:
      return "";
    case PathPrompt::open:
      return "open";
    case PathPrompt::save_as:
      return "save_as";
    case PathPrompt::save_predictions:
      return "save_predictions";
    case PathPrompt::export_walk:
      return "export";
  }
  return "";
}

}  // namespace raywalk
