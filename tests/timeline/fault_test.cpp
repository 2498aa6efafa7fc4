// Bugs made on purpose: each changes the walk first at the line that it names, and nothing before; nothing else of the
// tracer moves.
#include "trace/fault.h"

#include <nlohmann/json.hpp>
#include <string>

#include "io/scene_file.h"
#include "render/render.h"
#include "support/catch.h"
#include "timeline/event_json.h"
#include "timeline/recorder.h"

using namespace raywalk;

namespace {

// With the arithmetic that a fault breaks, so that only the fault makes a difference.
Scene naive(const std::string& name) {
  Scene scene = read_scene(RAYWALK_SOURCE_DIR "/scenes/" + name + ".toml")->scene;
  scene.render.numerics = Numerics::naive;
  return scene;
}

// A shipped scene in whose strip the fault shows.
Scene scene_for(Fault fault) {
  switch (fault) {
    case Fault::shadow_ray_misaimed:
    case Fault::reflection_flipped:
    case Fault::refraction_inverted:
    case Fault::epsilon_wrong_side:
    case Fault::second_root_dropped:
    case Fault::epsilon_too_small:
      return naive("classic");
    case Fault::attenuation_forgotten:
      return naive("shadows");
    case Fault::depth_not_counted:
      return naive("mirrors");
    case Fault::cosine_counted_twice:
    case Fault::emitter_area_forgotten:
      return naive("cornell");
    case Fault::emission_not_weighted: {
      Scene scene = naive("cornell");
      for (Object& object : scene.objects)
        if (object.name == "Lamp")
          object.shape = Polygon<double>{{{0.3, -1.2, 2.9}, {0.3, 1.2, 2.9}, {2.7, 1.2, 2.9}, {2.7, -1.2, 2.9}}, {}};
      return scene;
    }
    case Fault::second_side_black: {
      Scene scene = naive("cornell");
      for (Object& object : scene.objects)
        if (object.name == "Red wall")
          object.shape = Polygon<double>{{{0, 1.5, 3}, {3, 1.5, 3}, {3, 1.5, 0}, {0, 1.5, 0}}, {}};
      return scene;
    }
    case Fault::photons_from_behind: {
      Scene scene = naive("caustic");
      scene.render.photons.count = 5000;
      scene.camera.eye = {7, 0, 0};
      for (Object& object : scene.objects)
        if (object.name == "Wall") object.shape = Box<double>{{2.6, -4, -1.2}, {2.63, 4, 2.6}};
      return scene;
    }
    case Fault::power_of_another_pass:
    case Fault::pi_forgotten: {
      Scene scene = naive("caustic");
      scene.render.photons.count = 5000;
      return scene;
    }
    case Fault::reflectance_forgotten: {
      Scene scene = naive("radiosity");
      scene.render.radiosity.patch = 2;
      return scene;
    }
  }
  return {};
}

Timeline walk(const Scene& scene, std::optional<Fault> fault, Precision precision = Precision::double_) {
  return record_strip(scene, {precision, {}, fault});
}

bool same_picture(const Image& a, const Image& b) { return a.pixels == b.pixels; }

Image picture(const Scene& scene, std::optional<Fault> fault, Precision precision) {
  const bool is_global = traits_of(scene.render.integrator).is_global;
  RenderSettings settings{is_global ? ImageSize{15, 11} : ImageSize{63, 47}, {}, precision};
  settings.fault = fault;
  return render(scene, settings).value().image();
}

}  // namespace

TEST_CASE("every fault first changes the walk at the line that it breaks") {
  for (const Fault fault : values_of<Fault>) {
    for (const Precision precision : {Precision::double_, Precision::float_}) {
      CAPTURE(name_of(fault), static_cast<int>(precision));
      const Scene scene = scene_for(fault);
      const Timeline whole = walk(scene, {}, precision), broken = walk(scene, fault, precision);
      const auto first = first_difference(scene, broken, whole);
      REQUIRE(first);
      REQUIRE(*first < whole.steps());
      CHECK(broken.event(*first).line == faulty_line(fault));
      CHECK(whole.event(*first).line == faulty_line(fault));
      // Up to there the two are the same bits, and the first differing event is told apart by its own numbers.
      for (int i = 0; i < *first; ++i)
        REQUIRE(event_json(scene, broken.event(i)).dump() == event_json(scene, whole.event(i)).dump());
    }
  }
}

TEST_CASE("every fault shows in the strip and in the picture, watched or not") {
  for (const Fault fault : values_of<Fault>) {
    CAPTURE(name_of(fault));
    const Scene scene = scene_for(fault);
    const Timeline whole = walk(scene, {}), broken = walk(scene, fault);
    REQUIRE(whole.pixels().size() == broken.pixels().size());
    int spoilt = 0;
    for (std::size_t i = 0; i < whole.pixels().size(); ++i)
      spoilt += whole.pixels()[i].shade != broken.pixels()[i].shade;
    CHECK(spoilt > 0);
    for (const Precision precision : {Precision::double_, Precision::float_}) {
      CHECK_FALSE(same_picture(picture(scene, {}, precision), picture(scene, fault, precision)));
      // What is walked is what is seen, but in the flat worlds of photons and patches.
      if (integrator_of(fault) == Integrator::photons || integrator_of(fault) == Integrator::radiosity) continue;
      RenderSettings settings{std::nullopt, {}, precision};
      settings.fault = fault;
      const Image strip = render_strip(scene, settings).value().image();
      const Timeline walked = walk(scene, fault, precision);
      for (std::size_t i = 0; i < strip.pixels.size(); ++i)
        CHECK(Rgb<float>(walked.pixels()[i].shade) == strip.pixels[i]);
    }
  }
}

TEST_CASE("without a fault naive arithmetic walks as ever, whatever the scene's own is") {
  Scene scene = naive("classic");
  const Timeline plain = walk(scene, {});
  Scene robust = scene;
  robust.render.numerics = Numerics::robust;
  // A fault brings its arithmetic along.
  CHECK_FALSE(first_difference(scene, walk(robust, Fault::reflection_flipped), walk(scene, Fault::reflection_flipped)));
  CHECK_FALSE(first_difference(scene, plain, walk(scene, {})));
  // What the fault has nothing to break in, it leaves alone: no light fades here, so none is forgotten to fade.
  CHECK_FALSE(first_difference(scene, walk(scene, Fault::attenuation_forgotten), plain));
}

TEST_CASE("rays whose DEPTH is not counted go deeper than the limit, and come to an end all the same") {
  const Scene scene = scene_for(Fault::depth_not_counted);
  const Timeline broken = walk(scene, Fault::depth_not_counted);
  std::size_t most = 0;
  int deepest = 0;
  for (int position = 0; position <= broken.steps(); ++position) {
    most = std::max(most, broken.stack(position).size());
    if (position > 0) deepest = std::max(deepest, broken.event(position - 1).depth);
  }
  CHECK(most > static_cast<std::size_t>(scene.limits.depth));
  CHECK(deepest < scene.limits.depth);
  // The stack says what the calls were given, and not what they should have been.
  for (const FrameRecord& frame : broken.frames()) CHECK(frame.depth <= scene.limits.depth);
  Scene endless = read_scene(RAYWALK_SOURCE_DIR "/scenes/hard/facing_mirrors.toml")->scene;
  endless.limits = {3, 0};
  CHECK(walk(endless, Fault::depth_not_counted).steps() > walk(endless, {}).steps());
}

TEST_CASE("faults have names, and lines of the procedure that they break") {
  for (const Fault fault : values_of<Fault>) {
    CHECK_FALSE(name_of(fault).empty());
    const Pseudocode& own = pseudocode_with(faulty_line(fault));
    CHECK(&walk(scene_for(fault), fault).pseudocode() == &own);
    CHECK((integrator_of(fault) == Integrator::automatic) == (&own == &pseudocodes.front()));
    for (const Fault other : values_of<Fault>) CHECK((other == fault) == (name_of(other) == name_of(fault)));
  }
}

TEST_CASE("the first difference of two walks is the event, the end of the shorter one, or none") {
  const Scene scene = naive("classic");
  const Timeline one = record_cell(scene, 9), other = record_cell(scene, 10);
  CHECK(first_difference(scene, one, one) == std::nullopt);
  CHECK(first_difference(scene, one, other) == 0);
  CHECK(first_difference(scene, one, Timeline()) == 0);
}
