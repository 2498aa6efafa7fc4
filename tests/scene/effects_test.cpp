#include "scene/effects.h"

#include <set>
#include <tuple>
#include <vector>

#include "support/catch.h"

using namespace raywalk;

namespace {

constexpr Effect all_effects[] = {
    Effect::shadows,      Effect::reflection,     Effect::refraction,     Effect::gloss,
    Effect::translucency, Effect::penumbra,       Effect::depth_of_field, Effect::motion_blur,
    Effect::antialiasing, Effect::indirect_light, Effect::textures,       Effect::sky,
    Effect::scattering,   Effect::filtering,      Effect::microfacets,    Effect::maps};

Scene scene_of(const Material& material) {
  Scene scene;
  scene.objects.push_back({"Plain", Sphere<double>{}, Material{}});
  scene.objects.push_back({"Ball", Sphere<double>{{3, 0, 0}, 1}, material});
  scene.lights.push_back({"Lamp", Rgbd(1.0), PointLight{}});
  return scene;
}

std::set<Effect> used(const Effects& effects) {
  std::set<Effect> names;
  for (const Effect effect : all_effects)
    if (effects.used(effect)) names.insert(effect);
  return names;
}

}  // namespace

TEST_CASE("effects have names of their own, as the statistics write them") {
  std::set<std::string_view> names;
  for (const Effect effect : all_effects) names.insert(name_of(effect));
  CHECK(names.size() == static_cast<std::size_t>(effect_count));
  CHECK(name_of(Effect::depth_of_field) == "depth_of_field");
  CHECK(name_of(Effect::indirect_light) == "indirect_light");
}

TEST_CASE("each effect has a reason, used or not") {
  for (const Scene& scene : {Scene{}, scene_of({})}) {
    const Effects effects = effects_of(scene);
    for (const Effect effect : all_effects) {
      INFO(name_of(effect));
      CHECK_FALSE(effects[effect].why.empty());
      CHECK((effects[effect].why.rfind("none: ", 0) == 0) == !effects.used(effect));
    }
  }
}

TEST_CASE("shadows need a light that shines and an object to catch it") {
  CHECK(effects_of(Scene{})[Effect::shadows].why == "none: no light shines");
  Scene scene = scene_of({});
  CHECK(effects_of(scene)[Effect::shadows].why == "Lamp shines on objects");
  scene.lights.insert(scene.lights.begin(), {"Dark", Rgbd(0.0), DirectionalLight{}});
  CHECK(effects_of(scene)[Effect::shadows].why == "Lamp shines on objects");
  scene.lights.pop_back();
  CHECK(effects_of(scene)[Effect::shadows].why == "none: no light shines");
  scene.lights = {{"Lamp", Rgbd(1.0), PointLight{}}};
  scene.objects.clear();
  CHECK(effects_of(scene)[Effect::shadows].why == "none: nothing casts or catches a shadow");
}

TEST_CASE("reflection is called for by mirrors, and by whatever transmits") {
  Material material;
  CHECK(effects_of(scene_of(material))[Effect::reflection].why == "none: nothing reflects");
  CHECK(used(effects_of(scene_of(material))) == std::set<Effect>{Effect::shadows});

  material.transmission = Rgbd(0, 0, 0.5);
  CHECK(effects_of(scene_of(material))[Effect::reflection].why == "Ball can reflect totally inside");
  CHECK(effects_of(scene_of(material))[Effect::refraction].why == "Ball transmits");
  material.dielectric = true;
  CHECK(effects_of(scene_of(material))[Effect::reflection].why == "Ball reflects a share of the light as a dielectric");
  material.reflection = Rgbd(0.1, 0, 0);
  CHECK(effects_of(scene_of(material))[Effect::reflection].why == "Ball reflects");
  CHECK(used(effects_of(scene_of(material))) ==
        std::set<Effect>{Effect::shadows, Effect::reflection, Effect::refraction});

  material.transmission = Rgbd(0.0);
  CHECK(used(effects_of(scene_of(material))) == std::set<Effect>{Effect::shadows, Effect::reflection});
}

TEST_CASE("what is enabled but does nothing is not used") {
  Material material;
  material.dielectric = true;  // with nothing to share
  material.shadow = ShadowKind::filtered;
  material.ior = 2;
  CHECK(used(effects_of(scene_of(material))) == std::set<Effect>{Effect::shadows});
  CHECK(effects_of(scene_of(material), 1)[Effect::antialiasing].why == "none: one sample in the centre of each pixel");
}

TEST_CASE("textures and samples") {
  Material material;
  CHECK(effects_of(scene_of(material))[Effect::textures].why == "none: no material has a pattern");
  material.checker = Checker{};
  CHECK(effects_of(scene_of(material))[Effect::textures].why == "Ball is checkered");
  CHECK(effects_of(scene_of(material), 16)[Effect::antialiasing].why == "16 samples are taken in each pixel");
  CHECK(used(effects_of(scene_of(material), 16)) ==
        std::set<Effect>{Effect::shadows, Effect::textures, Effect::antialiasing});
}

TEST_CASE("filtering is called for by a checker or an image with a filter") {
  Material material;
  CHECK(effects_of(scene_of(material))[Effect::filtering].why == "none: no pattern is filtered");
  material.texture = ImageTexture{"wood.png", 1, 1, {}, TextureFilter::ewa};
  CHECK(effects_of(scene_of(material))[Effect::filtering].why == "Ball has its image filtered");
  material.texture->filter = TextureFilter::none;
  material.checker = Checker{};
  CHECK_FALSE(effects_of(scene_of(material)).used(Effect::filtering));
  material.checker->filter = CheckerFilter::closed;
  CHECK(effects_of(scene_of(material))[Effect::filtering].why == "Ball has its checker filtered");
}

TEST_CASE("microfacets are called for by a mirror that is rough or of metal") {
  Material material;
  material.roughness = 0.2, material.mirror = MirrorKind::gold;
  CHECK(effects_of(scene_of(material))[Effect::microfacets].why == "none: nothing is of metal or rough");
  material.reflection = Rgbd(1.0);
  CHECK(effects_of(scene_of(material))[Effect::microfacets].why == "Ball is a mirror of metal");
  CHECK(integrator_of(scene_of(material)) == Integrator::distributed);
  material.mirror = MirrorKind::ideal;
  CHECK(effects_of(scene_of(material))[Effect::microfacets].why == "Ball is a mirror of small mirrors");
  material.roughness = 0;
  CHECK_FALSE(effects_of(scene_of(material)).used(Effect::microfacets));
  material.mirror = MirrorKind::gold;  // smooth gold needs no random numbers
  CHECK(integrator_of(scene_of(material)) == Integrator::whitted);
  Scene scene = scene_of(material);
  scene.render.switches.reflection = false;
  CHECK(effects_of(scene)[Effect::microfacets].why == "none: reflection is switched off");
  scene.render.integrator = Integrator::cast;
  CHECK(effects_of(scene)[Effect::microfacets].why == "none: cast follows no ray beyond the first hit");
}

TEST_CASE("microfacets are called for by rough glass, and by what is matt and rough") {
  Material glass;
  glass.transmission = Rgbd(0.9);
  glass.roughness = 0.2;
  CHECK_FALSE(effects_of(scene_of(glass)).used(Effect::microfacets));  // kr and kt of one's own are not of facets
  glass.dielectric = true;
  Scene scene = scene_of(glass);
  CHECK(effects_of(scene)[Effect::microfacets].why == "Ball is glass of small facets");
  CHECK(integrator_of(scene) == Integrator::distributed);
  CHECK_FALSE(effects_of(scene).used(Effect::translucency));
  scene.render.integrator = Integrator::cones;
  CHECK(effects_of(scene).used(Effect::microfacets));
  scene.render.integrator = Integrator::beams;
  CHECK(effects_of(scene)[Effect::microfacets].why == "none: beams takes rough glass as clear");
  scene.render.integrator = Integrator::path;
  scene.render.switches.refraction = false;
  CHECK_FALSE(effects_of(scene).used(Effect::microfacets));

  Material dust;
  dust.diffuse_roughness = 0.5;
  scene = scene_of(dust);
  for (const Integrator integrator : {Integrator::cast, Integrator::whitted, Integrator::path, Integrator::cones}) {
    scene.render.integrator = integrator;
    CHECK(effects_of(scene)[Effect::microfacets].why == "Ball is matt and rough");
  }
  scene.render.integrator = Integrator::automatic;
  CHECK(integrator_of(scene) == Integrator::whitted);
  scene.render.integrator = Integrator::radiosity;
  CHECK(effects_of(scene)[Effect::microfacets].why == "none: radiosity takes matt surfaces as smooth");
  scene.render.integrator = Integrator::path;
  scene.objects[1].material.diffuse = Rgbd(0.0);
  CHECK_FALSE(effects_of(scene).used(Effect::microfacets));
}

TEST_CASE("indirect light is called for by paths where a surface sends light on") {
  Scene scene;
  Material black;
  black.diffuse = Rgbd(0.0);
  scene.objects = {{"Floor", Plane<double>{}, {}}, {"Coal", Sphere<double>{}, black}};
  const auto indirect = [&] { return effects_of(scene)[Effect::indirect_light]; };
  CHECK_FALSE(indirect().used);
  CHECK(indirect().why == "none: Whitted's algorithm follows mirrors and glass only");
  scene.render.integrator = Integrator::path;
  CHECK(indirect().used);
  CHECK(indirect().why == "Floor sends on the light that comes from other surfaces");
  scene.render.path_length = 1;
  CHECK_FALSE(indirect().used);
  scene.render.path_length = 2;
  CHECK(indirect().used);
  scene.objects.erase(scene.objects.begin());
  CHECK_FALSE(indirect().used);
  CHECK(indirect().why == "none: every surface is black");
  // An object that emits casts shadows for paths only.
  CHECK_FALSE(effects_of(scene).used(Effect::shadows));
  scene.objects[0].material.emission = Rgbd(1.0);
  CHECK_FALSE(effects_of(scene).used(Effect::shadows));  // on nothing
  scene.objects.push_back({"Floor", Plane<double>{}, {}});
  CHECK(effects_of(scene)[Effect::shadows].why == "Coal emits, and paths look for it from all surfaces");
  scene.render.integrator = Integrator::whitted;
  CHECK_FALSE(effects_of(scene).used(Effect::shadows));
}

TEST_CASE("scattering is called for by bodies that light gets into, and only paths walk inside") {
  Material milk;
  milk.scattering = Rgbd(1.0);
  Scene scene = scene_of(milk);
  scene.render.integrator = Integrator::path;
  CHECK(effects_of(scene)[Effect::scattering].why == "none: no body scatters light inside");
  milk.transmission = Rgbd(1.0);
  scene = scene_of(milk);
  CHECK(effects_of(scene)[Effect::scattering].why == "none: whitted takes light that is scattered inside as absorbed");
  scene.render.integrator = Integrator::path;
  CHECK(effects_of(scene)[Effect::scattering].why == "Ball scatters light inside");
}

TEST_CASE("light is scattered only in what encloses something and can be left") {
  Material milk;
  milk.transmission = Rgbd(1.0);
  milk.scattering = Rgbd(1.0);
  CHECK(why_no_walk_inside({"Ball", Sphere<double>{}, milk}).empty());
  CHECK(why_no_walk_inside({"Disk", Disk<double>{}, milk}).find("encloses nothing") != std::string::npos);
  CHECK(why_no_walk_inside({"Sea", Plane<double>{}, milk}).find("has no end") != std::string::npos);
  milk.absorption = Rgbd(0.1);
  CHECK(why_no_walk_inside({"Sea", Plane<double>{}, milk}).empty());
  milk.absorption = Rgbd(0.0);
  Object ball{"Ball", Sphere<double>{}, milk};
  const std::vector<std::tuple<double, double, bool>> cases{
      {1e4, 1, true}, {1e9, 1, false}, {1e9, 1e-6, true}, {10, 1e6, false}};
  for (const auto& [scattering, size, fits] : cases) {
    CAPTURE(scattering, size);
    ball.material.scattering = Rgbd(0.0, scattering, 0.0);
    ball.transform = {{Scale{Vec3d(size)}}};
    CHECK(why_no_walk_inside(ball).empty() == fits);
  }
  ball.material.absorption = Rgbd(1e-3);
  CHECK(why_no_walk_inside(ball).empty());
  ball.material.absorption = Rgbd(1e-9);
  CHECK(why_no_walk_inside(ball).find("turn about 1e+07 times") != std::string::npos);
}

TEST_CASE("maps and masks call for an effect, reliefs where single normals are shaded") {
  Material material;
  CHECK(effects_of(scene_of(material))[Effect::maps].why == "none: every surface is alike all over");
  material.bump_map = BumpMap{{"b.png"}, 0.1};
  CHECK(effects_of(scene_of(material))[Effect::maps].why == "Ball has a relief of normals");
  Scene scene = scene_of(material);
  scene.render.integrator = Integrator::radiosity;
  CHECK(effects_of(scene)[Effect::maps].why == "none: radiosity takes reliefs as flat");
  scene.render.integrator = Integrator::cones;
  CHECK(effects_of(scene)[Effect::maps].why == "none: cones takes reliefs as flat");
  for (const Integrator integrator : {Integrator::cast, Integrator::whitted, Integrator::path, Integrator::photons}) {
    scene.render.integrator = integrator;
    CHECK(effects_of(scene).used(Effect::maps));
  }
  material = {};
  material.mask = Mask{{"m.png"}};
  CHECK(effects_of(scene_of(material))[Effect::maps].why == "Ball is another material from point to point");
  CHECK_FALSE(effects_of(scene_of(material)).used(Effect::reflection));
  // What the second material does, the surface does somewhere.
  material.mask->second.reflection = Rgbd(0.5);
  material.mask->second.roughness = 0.3;
  CHECK(effects_of(scene_of(material)).used(Effect::reflection));
  CHECK(effects_of(scene_of(material)).used(Effect::microfacets));
  material.mask->second = {};
  material.mask->second.emission = Rgbd(1.0);
  CHECK(material.emits());
}
