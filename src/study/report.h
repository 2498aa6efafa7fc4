#pragma once
// What an experiment concludes.

#include "image/image_file.h"
#include "study/plot.h"
#include "study/statistics.h"

#include <string>
#include <vector>

namespace raywalk::study {

enum class LawKind {
  equals,    ///< the number is `expected`
  at_most,   ///< or less
  at_least,  ///< or more
  exact,     ///< not random: the number is `expected` up to `tolerance`
};

/// A prediction of theory, and what was measured.
struct Law {
  std::string name;  ///< "random, edge"
  std::string says;  ///< "error falls as N^-1/2: each sample by itself"
  LawKind kind = LawKind::equals;
  double expected = 0;
  Estimate measured{};
  double tolerance = 0;
  std::string otherwise{};  ///< the explanation if it does not hold
  std::string number{};     ///< what the number is, where the law does not say it: "how many times as many"
  /// The number is the natural logarithm of a factor; readers are shown the factor.
  bool is_logarithm = false;
};

/// A number on the law's scale as readers are shown it.
[[nodiscard]] double shown(const Law& law, double number);

/// The verdict on a law, given all laws of the study.
struct Verdict {
  bool holds = true;
  double p = 1, level = 0.05;
  Interval interval{};  ///< at the confidence that Holm's procedure leaves this law
};
[[nodiscard]] std::vector<Verdict> judged(const std::vector<Law>& laws);

struct Figure {
  Plot plot;
  std::string text;  ///< a paragraph that explains it
};

struct CaptionedImage {
  std::string caption;
  Image image;
};

struct Report {
  std::vector<Figure> figures;
  std::vector<Law> laws;
  std::vector<CaptionedImage> pictures{};
};

}  // namespace raywalk::study
