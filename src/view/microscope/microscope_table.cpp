// Compares robust and naive numerics at a hit, as text.

#include "view/microscope/microscope.h"
#include "view/state.h"
#include "view/text/shown.h"
#include "view/text/text.h"
#include "view/walk/asked.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace raywalk {

namespace {

/// "2.3 · 10¹¹"
std::string in_powers(double large, Language language) {
  const int power = static_cast<int>(std::floor(std::log10(large)));
  return typeset_power(fmt::format("{:.1f}e{}", large / std::pow(10.0, power), power), language);
}

std::string off_text(const Specimen& specimen, const std::optional<double>& off, Language language) {
  if (!off) return std::string(text("microscope.none", language));
  const double ulps = specimen.in_ulps(*off);
  if (ulps == 0) return std::string(text("microscope.on_surface", language));
  return fill(ulps > 0 ? "microscope.outside" : "microscope.inside", language,
              {{"ulps", ulps_text(std::abs(ulps), language)}});
}

/// All digits that distinguish it from its neighbours; if many, the first and the last, and the power of ten.
std::string number_of(double t, Precision precision, Language language) {
  const bool single = precision == Precision::float_;
  std::string digits = single ? fmt::format("{:.9g}", t) : fmt::format("{:.17g}", t);
  const std::string power = digits.substr(std::min(digits.find('e'), digits.size()));
  digits.resize(digits.size() - power.size());
  const std::size_t most = 13 - power.size(), first = 7, last = 5 - power.size();
  if (digits.size() > most) digits = digits.substr(0, first) + "\u2026" + digits.substr(digits.size() - last);
  return typeset_power(digits + power, language);
}

std::string leaving_text(const SpawnedRays& rays, Language language) {
  if (rays.hit_own == 0 && rays.astray == 0) return std::string(text("microscope.leaves", language));
  if (rays.count == 1)
    return std::string(text(rays.hit_own > 0 ? "microscope.hits_own" : "microscope.goes_astray", language));
  const bool own = rays.hit_own > 0;
  return fill(own ? "microscope.some_hit_own" : "microscope.some_astray", language,
              {{"some", own ? rays.hit_own : rays.astray}, {"all", rays.count}});
}

const SpawnedRays* of_kind(const std::optional<Reading>& reading, RayKind kind) {
  if (!reading) return nullptr;
  const auto found = std::find_if(reading->spawned.begin(), reading->spawned.end(),
                                  [kind](const SpawnedRays& rays) { return rays.kind == kind; });
  return found == reading->spawned.end() ? nullptr : &*found;
}

std::string_view short_name(RayKind kind, Language language) {
  switch (kind) {
    case RayKind::primary:
      return text("ray.short_primary", language);
    case RayKind::shadow:
      return text("ray.short_shadow", language);
    case RayKind::reflect:
      return text("ray.short_reflect", language);
    case RayKind::refract:
      return text("ray.short_refract", language);
    case RayKind::photon:
      return text("ray.short_photon", language);
    case RayKind::beam:
      return text("ray.short_beam", language);
  }
  return {};
}

bool goes_wrong(const SpawnedRays& rays) { return rays.hit_own > 0 || rays.astray > 0; }

/// Where naive rays start: off the surface, to one side of it or, where some go through it, to either.
std::string starts_text(const Specimen& specimen, const Reading& naive, Language language) {
  const SpawnPoint& start = naive.starts.front();
  if (!start.off)  // where the surface is cannot be said to the ulp
    return fill("microscope.away", language,
                {{"ulps", ulps_text(specimen.in_ulps(length(start.place - naive.point)), language)}});
  const bool both = std::any_of(naive.starts.begin(), naive.starts.end(),
                                [&](const SpawnPoint& other) { return other.off && *other.off * *start.off < 0; });
  if (!both) return off_text(specimen, start.off, language);
  return fill("microscope.either_side", language,
              {{"ulps", ulps_text(std::abs(specimen.in_ulps(*start.off)), language)}});
}

std::string sentence_on(const Specimen& specimen, Language language) {
  const std::optional<Reading>&robust = specimen.robust, &naive = specimen.naive;
  if (!naive) return std::string(text("microscope.says_missed", language));
  if (!robust) return std::string(text("microscope.says_invented", language));
  const SpawnPoint& start = naive->starts.front();
  const std::string starts = starts_text(specimen, *naive, language);
  for (const SpawnedRays& rays : naive->spawned)
    if (rays.hit_own > 0)
      return fill("microscope.says_acne", language,
                  {{"starts", starts}, {"ray", std::string(text(rays.kind, language))}});
  if (std::any_of(naive->spawned.begin(), naive->spawned.end(), goes_wrong))
    return fill("microscope.says_astray", language, {{"starts", starts}});
  if (!start.right_side()) return fill("microscope.says_wrong_side", language, {{"starts", starts}});
  const double apart = specimen.in_ulps(length(naive->point - robust->point));
  constexpr double far_apart = 8;  // ulps
  if (apart > far_apart)
    return fill("microscope.says_apart", language, {{"ulps", ulps_text(apart, language)}, {"starts", starts}});
  if (!start.off || specimen.in_ulps(*start.off) == 0)
    return std::string(text("microscope.says_alike_at_surface", language));
  return fill("microscope.says_alike", language, {{"starts", starts}});
}

}  // namespace

std::string ulps_text(double ulps, Language language) {
  if (ulps < 0.05) return typeset_power(fmt::format("{:.1g}", ulps), language);
  if (ulps < 9.95) return typeset_number(fmt::format("{:.1f}", ulps), language);
  if (ulps < 99999.5) return fmt::format("{:.0f}", ulps);
  return in_powers(ulps, language);
}

std::string magnification_text(double factor, Language language) {
  return "\u00d7 " + (factor < 9999.5 ? number_text(factor, language) : in_powers(factor, language));
}

MicroscopeTable microscope_table(const State& state, const Specimen& specimen) {
  const Language language = state.appearance.language;
  const auto name_of = [&](const std::optional<Reading>& reading) {
    return reading ? object_name(state, reading->object) : std::string(text("microscope.nothing", language));
  };
  MicroscopeTable table;
  const std::string ray = capitalised(std::string(text(specimen.kind, language)));
  if (specimen.passed >= 0) {
    const std::string passed = object_name(state, specimen.passed);
    table.title = fill("microscope.title_passed", language, {{"ray", ray}, {"object", passed}});
    table.sentence = fill("microscope.says_passed", language,
                          {{"object", passed},
                           {"gap", number_text(specimen.gap, language)},
                           {"ulps", ulps_text(specimen.in_ulps(specimen.gap), language)}});
    return table;
  }
  table.title = fill("microscope.title", language,
                     {{"ray", ray}, {"object", name_of(specimen.robust ? specimen.robust : specimen.naive)}});
  const auto spawns = [](const std::optional<Reading>& reading) { return reading && !reading->spawned.empty(); };
  const bool foretells = hides_rays_to_come(state) && (spawns(specimen.robust) || spawns(specimen.naive));
  table.sentence =
      foretells ? std::string(text("microscope.predict_first", language)) : sentence_on(specimen, language);
  const auto add = [&](std::string what, const auto& of, bool wrong) {
    const auto said = [&](const std::optional<Reading>& reading) {
      return reading ? of(*reading) : std::string(text("microscope.none", language));
    };
    table.rows.push_back({std::move(what), said(specimen.robust), said(specimen.naive), wrong});
  };
  // If both hit the same, the title says so.
  const bool alike = specimen.robust && specimen.naive && specimen.robust->object == specimen.naive->object;
  if (!alike)
    table.rows.push_back(
        {std::string(text("microscope.row_hit", language)), name_of(specimen.robust), name_of(specimen.naive), true});
  // The naive ray may itself have started elsewhere; each is right for its own.
  constexpr double far_apart = 8;  // ulps
  const bool own_starts = specimen.robust && specimen.naive &&
                          specimen.in_ulps(std::abs(specimen.robust->t - specimen.naive->t)) > far_apart &&
                          std::abs(specimen.robust->t_error.value_or(0)) < far_apart &&
                          std::abs(specimen.naive->t_error.value_or(0)) < far_apart;
  add(
      std::string(text(own_starts ? "microscope.row_t_own" : "microscope.row_t", language)),
      [&](const Reading& r) { return number_of(r.t, specimen.precision, language); }, false);
  add(
      std::string(text("microscope.row_t_error", language)),
      [&](const Reading& r) {
        return r.t_error ? fill("microscope.ulp", language, {{"ulps", ulps_text(std::abs(*r.t_error), language)}})
                         : std::string(text("microscope.none", language));
      },
      false);
  add(
      std::string(text("microscope.row_point", language)),
      [&](const Reading& r) { return off_text(specimen, r.off, language); }, false);
  add(
      std::string(text("microscope.row_start", language)),
      [&](const Reading& r) {
        const SpawnPoint& start = r.starts.front();
        // A robust ray knows its source surface, on whichever side rounding put the point.
        const bool knows = specimen.robust && &r == &*specimen.robust;
        if (start.place == r.point && (knows || start.right_side()))
          return std::string(text("microscope.at_point", language));
        return starts_text(specimen, r, language);
      },
      specimen.naive && !specimen.naive->starts.front().right_side());
  if (foretells) return table;
  for (const RayKind kind : {RayKind::shadow, RayKind::reflect, RayKind::refract}) {
    const SpawnedRays *robust = of_kind(specimen.robust, kind), *naive = of_kind(specimen.naive, kind);
    if (robust == nullptr && naive == nullptr) continue;
    const auto said = [&](const SpawnedRays* rays) {
      return rays != nullptr ? leaving_text(*rays, language) : std::string(text("microscope.none", language));
    };
    table.rows.push_back(
        {std::string(short_name(kind, language)), said(robust), said(naive), naive != nullptr && goes_wrong(*naive)});
  }
  return table;
}

}  // namespace raywalk
