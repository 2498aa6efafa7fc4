#pragma once
// The accelerators, stepped (view/structure.h).

#include "accel/accelerator.h"
#include "view/fields.h"
#include "view/structure/structure.h"

namespace raywalk::action {

/// Its search and its build are at the start, or at the end if the other's was.
struct ChooseStructure {
  static constexpr std::string_view word = "structure";
  AcceleratorKind kind;  ///< one of watched_accelerators
  static void fields(auto& f, auto& a) { f(a.kind); }
  void apply(State& state) const;
};
struct ShowStructurePage {
  static constexpr std::string_view word = "structure-page";
  StructurePage page;
  static void fields(auto& f, auto& a) { f(a.page); }
  void apply(State& state) const;
};
struct GoInStructure {
  static constexpr std::string_view word = "structure-go";
  int step;  ///< of the open page; clamped
  static void fields(auto& f, auto& a) { f(a.step); }
  void apply(State& state) const;
};

using OfStructure = Types<ChooseStructure, ShowStructurePage, GoInStructure>;

}  // namespace raywalk::action
