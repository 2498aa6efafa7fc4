#include "study/report.h"

#include <cmath>

namespace raywalk::study {

namespace {

double p_of(const Law& law) {
  if (!std::isfinite(law.measured.value) || !std::isfinite(law.measured.error)) return 0;  // nothing was measured
  const double both = two_sided_p(law.measured, law.expected);
  const bool above = law.measured.value > law.expected;
  switch (law.kind) {
    case LawKind::equals:
      return both;
    case LawKind::at_most:
      return above ? both / 2 : 1 - both / 2;
    case LawKind::at_least:
      return above ? 1 - both / 2 : both / 2;
    case LawKind::exact:
      break;
  }
  return 1;
}

}  // namespace

double shown(const Law& law, double number) { return law.is_logarithm ? std::exp(number) : number; }

std::vector<Verdict> judged(const std::vector<Law>& laws) {
  constexpr double alpha = 0.05;
  std::vector<Verdict> verdicts(laws.size());
  std::vector<double> p;
  for (const Law& law : laws)
    if (law.kind != LawKind::exact) p.push_back(p_of(law));
  const std::vector<double> levels = holm_levels(p, alpha);
  std::size_t tested = 0;
  for (std::size_t i = 0; i < laws.size(); ++i) {
    const Law& law = laws[i];
    Verdict& verdict = verdicts[i];
    if (law.kind == LawKind::exact) {
      verdict.holds = std::abs(law.measured.value - law.expected) <= law.tolerance;
      verdict.interval = {law.measured.value, law.measured.value};
      continue;
    }
    verdict.p = p[tested];
    verdict.level = levels[tested++];
    verdict.holds = verdict.p > verdict.level;
    // A one-sided law has all of its uncertainty on that side.
    const double sides = law.kind == LawKind::equals ? 1 : 2;
    verdict.interval = interval(law.measured, 1 - sides * verdict.level);
  }
  return verdicts;
}

}  // namespace raywalk::study
