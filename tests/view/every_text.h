#pragma once
// All texts of `view`, in both languages side by side.

#include "view/bug_text.h"
#include "view/choice_text.h"
#include "view/cost.h"
#include "view/equation_text.h"
#include "view/lesson_text.h"
#include "view/microscope.h"
#include "view/predict.h"
#include "view/structure_text.h"
#include "view/text.h"

#include <string>
#include <vector>

namespace raywalk::test {

struct TextPair {
  std::string where;  ///< the family and the number in it
  std::string english, portuguese;
};

/// All ids of a family up to its last.
template <class Id>
void add_family(std::vector<TextPair>& all, const std::string& family, Id last) {
  for (int i = 0; i <= static_cast<int>(last); ++i) {
    const Id id = static_cast<Id>(i);
    all.push_back({family + " " + std::to_string(i), std::string(english(id)), std::string(portuguese(id))});
  }
}

[[nodiscard]] inline std::vector<TextPair> every_text_of_view() {
  std::vector<TextPair> all;
  add_family(all, "TextId", TextId::autosave_failed);
  add_family(all, "PanelText", PanelText::shown_tiny);
  add_family(all, "MessageId", MessageId::next_formed);
  add_family(all, "RayKind", RayKind::refract);
  add_family(all, "Ending", static_cast<Ending>(ending_count - 1));
  add_family(all, "CostText", CostText::surveying);
  add_family(all, "ScopeText", ScopeText::says_alike_at_surface);
  add_family(all, "EquationText", EquationText::survival);
  add_family(all, "LessonWord", LessonWord::close);
  add_family(all, "PredictText", PredictText::nothing_to_save);
  add_family(all, "BugText", BugText::leave);
  add_family(all, "StructureText", StructureText::note_cut_short);
  add_family(all, "AcceleratorKind", all_accelerators.back());
  add_family(all, "Integrator", Integrator::path);
  add_family(all, "Sampler", Sampler::sobol);
  add_family(all, "Numerics", Numerics::naive);
  add_family(all, "Effect", static_cast<Effect>(effect_count - 1));
  for (const Fault fault : all_faults)
    for (const FaultText id : {FaultText::symptom, FaultText::hint, FaultText::wrong, FaultText::cure}) {
      const FaultTextOf of{fault, id};
      all.push_back({"fault", std::string(english(of)), std::string(portuguese(of))});
    }
  for (const PseudocodeLine& line : pseudocode)
    all.push_back({"duty", std::string(english(DutyOf{line.line})), std::string(portuguese(DutyOf{line.line}))});
  const auto explained = explanations(Language::english), other = explanations(Language::portuguese);
  for (std::size_t i = 0; i < explained.size() && i < other.size(); ++i)
    all.push_back({"explanation", std::string(explained[i].text), std::string(other[i].text)});
  const auto help_english = help(Language::english), help_portuguese = help(Language::portuguese);
  for (std::size_t i = 0; i < help_english.size() && i < help_portuguese.size(); ++i) {
    const HelpSection &one = help_english[i], &two = help_portuguese[i];
    all.push_back({"help", one.title, two.title});
    for (std::size_t k = 0; k < one.entries.size() && k < two.entries.size(); ++k) {
      if (!one.entries[k].term.empty()) all.push_back({"help term", one.entries[k].term, two.entries[k].term});
      all.push_back({"help text", one.entries[k].text, two.entries[k].text});
    }
  }
  return all;
}

}  // namespace raywalk::test
