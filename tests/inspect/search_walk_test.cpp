// The searches that are watched are those that the tracer made.
#include "inspect/search_walk.h"

#include <set>
#include <string>

#include "io/scene_file.h"
#include "support/catch.h"
#include "timeline/recorder.h"

using namespace raywalk;

namespace {

Scene scene_of(const std::string& name) {
  return read_scene(std::string(RAYWALK_SOURCE_DIR) + "/scenes/" + name + ".toml")->scene;
}

SearchWalks walks_of(const Scene& scene, Precision precision = Precision::double_) {
  return {scene, std::make_shared<const Timeline>(record_strip(scene, {precision})), precision};
}

// What the renderer counts for the strip in one accelerator.
template <class T>
TestCounts rendered(const Scene& scene, AcceleratorKind kind) {
  const World<T> world(scene, kind);
  const int cells = scene.camera.screen.cells;
  const RayGenerator<T> camera(scene, {cells, 1}, scene.image);
  return trace(world, camera, {0, cells, 0, 1}, [](const Pixel&, const Rgb<T>&) {}).tests;
}

}  // namespace

TEST_CASE("over a strip the watched searches cost what the renderer counts, in each accelerator") {
  for (const std::string name : {"many_circles", "classic", "mirrors"}) {
    for (const Numerics numerics : {Numerics::robust, Numerics::naive}) {
      for (const Precision precision : {Precision::double_, Precision::float_}) {
        Scene scene = scene_of(name);
        scene.render.numerics = numerics;
        const SearchWalks walks = walks_of(scene, precision);
        std::array<TestCounts, watched_count> sums{};
        for (int ray = 0; ray < static_cast<int>(walks.timeline()->rays().size()); ++ray) {
          const auto searches = walks.search(ray);
          REQUIRE((searches != nullptr) == walks.timeline()->rays()[static_cast<std::size_t>(ray)].formed);
          for (std::size_t i = 0; searches && i < watched_count; ++i) sums[i] += searches->in[i].counts;
        }
        // What weakens a shadow ray is crossed once more when the search is over, in whatever structure it was found.
        const std::size_t brute = watched_index(AcceleratorKind::none);
        const auto all = precision == Precision::float_ ? rendered<float>(scene, AcceleratorKind::none)
                                                        : rendered<double>(scene, AcceleratorKind::none);
        const std::uint64_t afterwards = all.primitives - sums[brute].primitives;
        CHECK((afterwards > 0) == (name == "classic"));
        for (std::size_t i = 0; i < watched_count; ++i) {
          CAPTURE(name, name_of(watched_accelerators[i]), name_of(numerics), static_cast<int>(precision));
          const TestCounts counts = precision == Precision::float_ ? rendered<float>(scene, watched_accelerators[i])
                                                                   : rendered<double>(scene, watched_accelerators[i]);
          CHECK(sums[i].nodes == counts.nodes);
          CHECK(sums[i].primitives + afterwards == counts.primitives);
        }
      }
    }
  }
}

TEST_CASE("every search finds what testing everything finds, which is what the recording has") {
  const Scene scene = scene_of("many_circles");
  const SearchWalks walks = walks_of(scene);
  const auto& brute_at = [](const RaySearches& searches) -> const WatchedSearch& {
    return searches.in[watched_index(AcceleratorKind::none)];
  };
  int hits = 0, blocked = 0;
  for (int ray = 0; ray < static_cast<int>(walks.timeline()->rays().size()); ++ray) {
    const auto searches = walks.search(ray);
    if (!searches) continue;
    const RayRecord& record = walks.timeline()->rays()[static_cast<std::size_t>(ray)];
    const WatchedSearch& brute = brute_at(*searches);
    CHECK(brute.t.has_value() == (record.ending == Ending::hit || record.ending == Ending::blocked));
    for (const WatchedSearch& search : searches->in) {
      CHECK(search.t.has_value() == brute.t.has_value());
      CHECK(search.events.back().kind == SearchEvent::Kind::ended);
      if (record.kind == RayKind::shadow || !search.t || !brute.t) continue;
      CHECK(*search.t == *brute.t);
      CHECK(search.primitive == brute.primitive);
      CHECK(walks.name(search.primitive, Language()) == scene.objects[static_cast<std::size_t>(record.object)].name);
    }
    hits += record.ending == Ending::hit;
    blocked += record.ending == Ending::blocked;
  }
  CHECK(hits > 10);
  CHECK(blocked > 5);
}

TEST_CASE("the scene of many circles shows everything that a search can do") {
  const SearchWalks walks = walks_of(scene_of("many_circles"));
  std::array<std::set<Skip>, watched_count> skips;
  std::set<SearchEnd> ends;
  std::set<SearchEvent::Kind> kinds;
  std::set<SearchEvent::Test> tests;
  bool outside = false, again = false;
  std::array<std::uint64_t, watched_count> sums{};
  for (int ray = 0; ray < static_cast<int>(walks.timeline()->rays().size()); ++ray) {
    const auto searches = walks.search(ray);
    if (!searches) continue;
    for (std::size_t i = 0; i < watched_count; ++i) {
      sums[i] += searches->in[i].counts.primitives;
      for (const SearchEvent& event : searches->in[i].events) {
        kinds.insert(event.kind);
        if (event.kind == SearchEvent::Kind::skipped) skips[i].insert(event.skip);
        if (event.kind == SearchEvent::Kind::ended) ends.insert(event.end);
        if (event.kind == SearchEvent::Kind::tested) tests.insert(event.test);
        outside = outside || event.outside;
        again = again || event.again;
      }
    }
  }
  const std::set all{Skip::missed, Skip::behind, Skip::beyond};
  for (const AcceleratorKind kind : {AcceleratorKind::bvh, AcceleratorKind::octree, AcceleratorKind::kdtree})
    CHECK(skips[watched_index(kind)] == all);
  CHECK(ends == std::set{SearchEnd::all_seen, SearchEnd::blocked, SearchEnd::beyond, SearchEnd::left});
  CHECK(kinds.size() == 6);
  CHECK(tests == std::set{SearchEvent::Test::missed, SearchEvent::Test::nearest, SearchEvent::Test::farther});
  CHECK(outside);
  CHECK(again);
  // Worth showing: each structure spares more than half of the tests.
  for (const AcceleratorKind kind : watched_accelerators)
    if (kind != AcceleratorKind::none)
      CHECK(2 * sums[watched_index(kind)] < sums[watched_index(AcceleratorKind::none)]);
}

TEST_CASE("a member of a group and a triangle are called by their own names") {
  Scene scene = scene_of("sphereflake");
  const SearchWalks flake(scene, std::make_shared<const Timeline>(record_pixel(scene, {9, 7}, 4, 3)),
                          Precision::double_);
  CHECK_FALSE(flake.too_large());
  CHECK(flake.primitives() > 7000);
  bool named = false;
  for (int i = 0; i < flake.primitives(); ++i)
    named = named || flake.name(i, Language()).find(" / ") != std::string::npos;
  CHECK(named);
  scene = scene_of("mesh");
  const SearchWalks mesh(scene, std::make_shared<const Timeline>(record_pixel(scene, {9, 7}, 4, 3)),
                         Precision::double_);
  CHECK(mesh.name(mesh.primitives() - 1, Language()).find(" #") != std::string::npos);
}
