// Rows that others trace give the picture that this program's threads give, whoever is late.
#include "render/row_tracer.h"

#include "render/preview.h"
#include "render/scenes.h"

#include "support/catch.h"

#include <algorithm>
#include <deque>
#include <random>

using namespace raywalk;
using namespace raywalk::test;

namespace {

Preview refined(const Scene& scene, const PreviewSettings& settings) {
  Preview preview(scene, settings);
  while (preview.refine(1000)) {
  }
  return preview;
}

/// Hands out a few rows at a time, and takes them back in an order of its own.
Preview traced_elsewhere(const Scene& scene, const PreviewSettings& settings, unsigned seed) {
  std::mt19937 random(seed);
  WorldCache worlds;
  const RowTracer tracer(scene, settings, worlds);
  Preview preview;
  preview.reset_elsewhere(scene, settings);
  CHECK_FALSE(preview.refine(1000));
  std::deque<PreviewRow> out;
  while (!preview.finished()) {
    for (const PreviewRow& row : preview.hand_out(1 + static_cast<int>(random() % 5))) out.push_back(row);
    REQUIRE(!out.empty());
    std::vector<TracedRow> some;
    for (std::size_t i = 0; i < 3 && !out.empty(); ++i) {
      const auto at = static_cast<std::ptrdiff_t>(random() % out.size());
      some.push_back(tracer.trace(out[static_cast<std::size_t>(at)]));
      out.erase(out.begin() + at);
    }
    const double before = preview.done();
    preview.take(std::move(some));
    CHECK(preview.done() >= before);
  }
  CHECK(out.empty());
  CHECK(preview.hand_out(10).empty());
  return preview;
}

}  // namespace

TEST_CASE("rows traced elsewhere, in any order, give the same bits") {
  const Scene scene = planar_scenes().front().scene;
  for (const Precision precision : {Precision::float_, Precision::double_})
    for (const Heat heat : {Heat::none, Heat::rays, Heat::tests, Heat::noise})
      for (const int samples : {1, 3}) {
        PreviewSettings settings{.size = {37, 21}, .precision = precision, .samples = samples, .heat = heat};
        const Preview here = refined(scene, settings);
        for (unsigned seed = 0; seed < 3; ++seed) {
          CAPTURE(seed, samples, static_cast<int>(heat));
          const Preview there = traced_elsewhere(scene, settings, seed);
          CHECK(there.rgba() == here.rgba());
          CHECK(there.hottest() == here.hottest());
          CHECK(there.statistics().rays == here.statistics().rays);
          if (precision == Precision::float_) CHECK(there.film<float>().pixels() == here.film<float>().pixels());
          if (precision == Precision::double_) CHECK(there.film<double>().pixels() == here.film<double>().pixels());
        }
      }
}

TEST_CASE("a picture begun anew elsewhere forgets what was handed out, and keeps what it shows") {
  const Scene scene = planar_scenes().front().scene;
  const PreviewSettings settings{.size = {37, 21}, .samples = 1};
  Preview preview = refined(scene, settings);
  const auto shown = preview.rgba();
  preview.reset_elsewhere(scene, settings);
  CHECK(preview.rgba() == shown);
  const auto rows = preview.hand_out(1000);
  CHECK(preview.done() == 0);
  CHECK(preview.hand_out(1000).empty());  // beyond the next pass
  CHECK(std::all_of(rows.begin(), rows.end(), [](const PreviewRow& row) { return row.pass.stride >= 4; }));
  preview.reset_elsewhere(scene, settings);
  CHECK(preview.hand_out(1000).size() == rows.size());
}
