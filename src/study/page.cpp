// The page that a study writes: one file, without scripts, for screens light and dark and for paper.
#include "study/study.h"
#include "text/markup.h"

#include <fmt/format.h>

#include <cmath>

namespace raywalk::study {

namespace {

constexpr const char* style = R"(<style>
:root{color-scheme:light dark;--fg:#1b1d22;--bg:#fff;--soft:#4a4f5a;--line:#d9dbe0;--good:#00664a;--bad:#a33500}
@media (prefers-color-scheme:dark){:root{--fg:#e8eaef;--bg:#15171c;--soft:#b4b9c6;--line:#343842;--good:#2fcb9f;--bad:#ff8b3d}}
body{font:17px/1.55 Inter,'Segoe UI','Liberation Sans',sans-serif;color:var(--fg);background:var(--bg);
max-width:54rem;margin:2.5rem auto;padding:0 1.2rem}
h1{font-size:2rem;line-height:1.2}h2{font-size:1.45rem;margin-top:3.2rem;border-top:1px solid var(--line);padding-top:1.4rem}
sup{line-height:0;font-size:.75em}p.ask{font-size:1.12rem;font-style:italic}p.soft,td.soft,figcaption{color:var(--soft)}
figure{margin:1.4rem 0}svg{max-width:100%;height:auto;border:1px solid var(--line);border-radius:6px}
table{border-collapse:collapse;width:100%;font-size:.92rem}td,th{text-align:left;padding:.35rem .6rem;
border-bottom:1px solid var(--line);vertical-align:top}th[scope=row]{font-weight:400}td.n,th.n{text-align:right;font-variant-numeric:tabular-nums;white-space:nowrap}
.yes{color:var(--good);font-weight:600;white-space:nowrap}.no{color:var(--bad);font-weight:600}
code{font-family:'JetBrains Mono','DejaVu Sans Mono',monospace;font-size:.9em}
.strips{display:grid;grid-template-columns:repeat(auto-fit,minmax(16rem,1fr));gap:.8rem}.strips figure{margin:0}
.strips img{width:100%;image-rendering:pixelated;border:1px solid var(--line)}
@media (max-width:44rem){figure{overflow-x:auto}svg{max-width:none;min-width:42rem}code{overflow-wrap:anywhere}
thead{position:absolute;clip-path:inset(50%)}tr{display:block;padding:.6rem 0;border-bottom:1px solid var(--line)}
td,th[scope=row]{display:block;border:0;padding:.1rem 0}th[scope=row]{font-weight:600}td.n{text-align:left}
td[data-is]::before{content:attr(data-is) ': ';color:var(--soft)}}
@media print{body{max-width:none;margin:0}h2{break-before:page}figure{break-inside:avoid}}
</style>
)";

std::string base64(const std::string& bytes) {
  constexpr const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
      bits = bits << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k) out += i + k <= bytes.size() ? digits[bits >> (18 - 6 * k) & 63] : '=';
  }
  return out;
}

std::string prose(const std::string& text) { return escaped_with_powers(text, "<sup>", "</sup>"); }

std::string number(double value) {
  if (value == 0) return "0";
  const double size = std::abs(value);
  const std::string digits = size >= 0.01 && size < 1e5 ? fmt::format("{:.4f}", size) : fmt::format("{:.2e}", size);
  return value < 0 ? "\u2212" + digits : digits;
}

std::string expected_text(const Law& law) {
  const std::string expected = number(shown(law, law.expected));
  switch (law.kind) {
    case LawKind::equals:
      return expected;
    case LawKind::at_most:
      return "at most " + expected;
    case LawKind::at_least:
      return "at least " + expected;
    case LawKind::exact:
      return law.tolerance > 0 ? fmt::format("{} ± {:.0e}", expected, law.tolerance) : expected;
  }
  return "";
}

std::string interval_text(const Law& law, const Verdict& verdict) {
  if (law.kind == LawKind::exact) return "no chance in it";
  return fmt::format("{} to {}", number(shown(law, verdict.interval.low)), number(shown(law, verdict.interval.high)));
}

std::string law_rows(const Concluded& c) {
  std::string rows;
  for (std::size_t i = 0; i < c.verdicts.size(); ++i) {
    const Law& law = c.report.laws[i];
    const Verdict& verdict = c.verdicts[i];
    rows += fmt::format(
        "<tr><th scope='row'>{}</th><td class='soft'>{}{}</td><td class='n' data-is='Expected'>{}</td>"
        "<td class='n' data-is='Measured'>{}</td><td class='n' data-is='Interval'>{}</td><td class='{}'>{}</td></tr>\n",
        escaped(law.name), prose(law.says),
        law.number.empty() ? "" : "<br><small>The number: " + prose(law.number) + ".</small>", expected_text(law),
        number(shown(law, law.measured.value)), interval_text(law, verdict), verdict.holds ? "yes" : "no",
        verdict.holds ? "✓ holds" : "✗ does not hold. " + prose(law.otherwise));
  }
  return rows;
}

constexpr const char* law_head =
    "<table><thead><tr><th>Law</th><th>What it says</th><th class='n'>Expected</th><th class='n'>Measured</th>"
    "<th class='n'>Interval</th><th>Verdict</th></tr></thead><tbody>\n";

std::string section(const Concluded& c, Effort effort) {
  const Experiment& e = c.experiment;
  std::string html = fmt::format("<h2 id='{}'>{} · {}</h2>\n<p class='ask'>{}</p>\n", e.name, e.number,
                                 escaped(e.title), escaped(e.question));
  for (const Figure& figure : c.report.figures)
    html += fmt::format("<figure>\n{}</figure>\n<p>{}</p>\n", svg_of(figure.plot), prose(figure.text));
  if (!c.report.pictures.empty()) {
    html += "<div class='strips'>\n";
    for (const CaptionedImage& picture : c.report.pictures) {
      const auto png = encode_png(picture.image);
      if (!png) continue;
      html +=
          fmt::format("<figure><img alt='{0}' src='data:image/png;base64,{1}'><figcaption>{0}</figcaption></figure>\n",
                      escaped(picture.caption), base64(*png));
    }
    html += "</div>\n";
  }
  html += law_head + law_rows(c) + "</tbody></table>\n";
  html += fmt::format(
      "<p class='soft'>Every trial, with its rays, nodes, tests, random draws and processor seconds: "
      "<a href='{0}.csv'>{0}.csv</a>. Repeat: <code>raywalk study {0} -o DIR{1}</code></p>\n",
      e.name, effort == Effort::quick ? " --quick" : "");
  return html;
}

}  // namespace

std::string page_of(const StudyResult& result, const StudyOptions& options) {
  const auto broken = result.broken().size();
  const int laws = result.laws();
  std::string html =
      "<!DOCTYPE html>\n<html lang='en'><head><meta charset='utf-8'><meta name='viewport' "
      "content='width=device-width'><title>" +
      std::string(page_title) + "</title>\n" + std::string(style) + "</head><body>\n<h1>What accuracy costs</h1>\n";
  html += fmt::format(
      "<p>Each part turns one knob of a ray tracer and shows the error and the bill. Errors are measured against "
      "pictures that are known in closed form, or where no formula is known, against two references that share no "
      "random "
      "number; every point stands for {} rounds with random numbers of their own, its bar for a 95% interval. A dotted "
      "line is what theory expects. <b>{}</b></p>\n",
      result.concluded.empty() ? 0 : result.concluded.front().experiment.rounds,
      broken == 0 ? fmt::format("All {} laws hold.", laws) : fmt::format("{} of {} laws do not hold.", broken, laws));
  html += "<p>";
  for (const Concluded& c : result.concluded)
    html += fmt::format("<a href='#{}'>{} {}</a>{}", c.experiment.name, c.experiment.number,
                        escaped(c.experiment.title), &c == &result.concluded.back() ? "" : " · ");
  html += "</p>\n";
  for (const Concluded& c : result.concluded) html += section(c, options.effort);
  html += fmt::format(
      "<h2>How it was measured</h2>\n<p>Machine: {}. Effort: {}. Command: <code>{}</code>.</p>\n"
      "<p>Seeds are fixed: all numbers but the seconds are the same in each run. Methods take turns within a round, "
      "after "
      "one round to warm up; seconds are those that the processor worked for the trial, medians over the rounds, with "
      "the "
      "order statistics between which the median lies in 95% of all cases. Other intervals are bootstrapped over the "
      "rounds (B. Efron 1979), widened for their number (T. Hesterberg 2015). Slopes are fitted to the logarithms by "
      "least squares. A law is judged at the level that Holm's procedure (1979) leaves it among all laws of this page, "
      "so "
      "that the chance of condemning any true law is at most 5%; the interval in the table is the one of that level. "
      "No "
      "trial was left out.</p>\n</body></html>\n",
      escaped(options.machine), effort_name(options.effort), escaped(options.command));
  return html;
}

}  // namespace raywalk::study
