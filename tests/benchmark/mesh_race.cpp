// The race of mesh kernels: Raywalk, at each width that this machine has, against Embree 3 where libembree-dev was
// there when this was built. The same rays for all, one thread, processor time, the runs interleaved and their median
// taken. Where two answers differ, rational arithmetic says who is wrong, and so it does for a sample of all rays.
//
//   benchmark_mesh_race [RAYS] [RUNS] [MESH...]
//
// RAYS of each kind, in thousands; MESH: bunny, million, ten (million; 4.6 GB), slivers or soup, or a number: hills of
// about as many triangles. The bunny is data/bunny_room.ply of the shared folder, a room seen from inside. Exits 1 when
// one of Raywalk's answers is wrong.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <memory>
#include <numbers>
#include <numeric>
#include <optional>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "accel/accelerator.h"
#include "accel/slabs.h"
#include "accel/width.h"
#include "race_meshes.h"

#ifdef RAYWALK_EMBREE
#include <embree3/rtcore.h>
#endif
#ifdef RAYWALK_ORACLE
#include "check/judge.h"
#endif

namespace {

using namespace raywalk;
using namespace raywalk::race_meshes;

// ---------------------------------------------------------------------------------------------------------------------
// Rays

enum class Want { nearest, any };
struct RaySet {
  std::string name;
  Want want = Want::nearest;
  std::vector<Ray<float>> rays;
  std::vector<float> t_max;
  bool coherent = false;
};

// Primary rays in tiles of 4 x 4, shadow rays from where they hit to a point light, two diffuse bounces, mirror rays.
// All start a little off the surface, so that nobody has to know where they come from.
std::vector<RaySet> ray_sets(const Subject& subject, const Accelerator<float>& accelerator, int thousands) {
  Numbers next(5);
  RaySet primary{"primary", Want::nearest, {}, {}, true}, shadow{"shadow", Want::any, {}, {}, true};
  RaySet first{"bounce 1", Want::nearest, {}, {}, false}, second = first, mirror = first;
  RaySet occlusion{"area light", Want::any, {}, {}, false};
  second.name = "bounce 2", mirror.name = "mirror";
  const int tiles = static_cast<int>(std::sqrt(thousands * 1000 / 16.0)), side = 4 * tiles;
  const Vec3d ahead = normalize(subject.look_at - subject.eye), right = normalize(cross(ahead, subject.up));
  const Vec3d above = cross(right, ahead);
  const double half = std::tan(subject.field / 2 * std::numbers::pi / 180);
  double size = 0;
  for (const Vec3d& at : subject.mesh.positions)
    size = std::max({size, std::abs(at.x), std::abs(at.y), std::abs(at.z)});
  TestCounts counts;
  struct Place {
    Vec3d position, normal;
  };
  const auto place = [&](const Ray<float>& ray) -> std::optional<Place> {
    const auto hit = accelerator.closest(ray, infinity<float>, counts);
    if (!hit) return std::nullopt;
    const auto point = accelerator.primitives().surface_at(hit->primitive, ray, Intersection<float>{hit->t, hit->part});
    Vec3d normal(point.normal);
    if (dot(normal, Vec3d(ray.direction)) > 0) normal = -normal;
    return Place{Vec3d(point.position) + 1e-4 * size * normal, normal};
  };
  const auto diffuse = [&](const Vec3d& normal) { return normalize(normal + 0.999 * next.unit()); };
  const auto add = [](RaySet& set, const Vec3d& from, const Vec3d& direction, float t_max = infinity<float>) {
    set.rays.push_back({Vec3<float>(from), Vec3<float>(direction)});
    set.t_max.push_back(t_max);
  };
  for (int tile = 0; tile < tiles * tiles; ++tile)
    for (int pixel = 0; pixel < 16; ++pixel) {
      const int x = tile % tiles * 4 + pixel % 4, y = tile / tiles * 4 + pixel / 4;
      const Vec3d direction =
          normalize(ahead + half * ((2 * x + 1.0) / side - 1) * right - half * ((2 * y + 1.0) / side - 1) * above);
      add(primary, subject.eye, direction);
      const auto seen = place(primary.rays.back());
      if (!seen) continue;
      add(shadow, seen->position, subject.light - seen->position, 1);
      const Vec3d aside = 0.15 * size * Vec3d(next.real(-1, 1), next.real(-1, 1), next.real(-1, 1));
      add(occlusion, seen->position, subject.light + aside - seen->position, 1);
      add(mirror, seen->position, direction - 2 * dot(direction, seen->normal) * seen->normal);
      add(first, seen->position, diffuse(seen->normal));
      if (const auto again = place(first.rays.back())) add(second, again->position, diffuse(again->normal));
    }
  return {primary, shadow, occlusion, first, second, mirror};
}

// ---------------------------------------------------------------------------------------------------------------------
// Those who race

double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct Racer {
  std::string name;
  double build_seconds = 0;
  // The primitive of each ray, -1 for none; of shadow rays 0 or -1.
  std::function<void(const RaySet&, std::vector<int>&)> trace;
};

TestCounts trace_ours(const Accelerator<float>& accelerator, const RaySet& set, std::vector<int>& answers) {
  TestCounts counts;
  for (std::size_t i = 0; i < set.rays.size(); ++i) {
    if (set.want == Want::any) {
      answers[i] = accelerator.occluded(set.rays[i], set.t_max[i], counts) ? 0 : -1;
    } else {
      const auto hit = accelerator.closest(set.rays[i], set.t_max[i], counts);
      answers[i] = hit ? hit->primitive : -1;
    }
  }
  return counts;
}

// The same rays as batches, of which those that are coherent are searched together.
void trace_ours_together(const Accelerator<float>& accelerator, const RaySet& set, std::vector<int>& answers) {
  TestCounts counts;
  constexpr std::size_t most = 64;
  std::array<std::optional<Hit<float>>, most> hits;
  std::array<bool, most> occluded;
  for (std::size_t first = 0; first < set.rays.size(); first += most) {
    const std::size_t count = std::min(most, set.rays.size() - first);
    const std::span rays = std::span(set.rays).subspan(first, count);
    const std::span t_max = std::span(set.t_max).subspan(first, count);
    if (set.want == Want::any)
      accelerator.occluded(rays, t_max, std::span(occluded).first(count), counts);
    else
      accelerator.closest(rays, t_max, std::span(hits).first(count), counts);
    for (std::size_t i = 0; i < count; ++i)
      answers[first + i] = set.want == Want::any ? (occluded[i] ? 0 : -1) : hits[i] ? hits[i]->primitive : -1;
  }
}

#ifdef RAYWALK_EMBREE

struct EmbreeScene {
  RTCDevice device = rtcNewDevice("threads=1");
  RTCScene scene = rtcNewScene(device);
  double build_seconds = 0;
  // What the device holds now; and more than before it built: the tree, with its triangles, without the mesh.
  std::int64_t held_bytes = 0, tree_bytes = 0;

  EmbreeScene(const Mesh& mesh, bool robust) {
    rtcSetDeviceMemoryMonitorFunction(
        device,
        [](void* held, ssize_t bytes, bool) {
          *static_cast<std::int64_t*>(held) += bytes;
          return true;
        },
        &held_bytes);
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* positions = static_cast<float*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), mesh.positions.size()));
    for (const Vec3d& at : mesh.positions)
      for (int axis = 0; axis < 3; ++axis) *positions++ = static_cast<float>(at[axis]);
    auto* corners = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), mesh.triangles.size()));
    for (const Mesh::Corners& triangle : mesh.triangles)
      for (const std::int32_t corner : triangle) *corners++ = static_cast<std::uint32_t>(corner);
    const std::int64_t mesh_bytes = held_bytes;
    const double begin = processor_seconds();
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_HIGH);
    if (robust) rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    rtcCommitScene(scene);
    build_seconds = processor_seconds() - begin;
    tree_bytes = held_bytes - mesh_bytes;
  }
  ~EmbreeScene() {
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
  }
  EmbreeScene(const EmbreeScene&) = delete;
  EmbreeScene& operator=(const EmbreeScene&) = delete;
};

void trace_singly(RTCScene scene, const RaySet& set, std::vector<int>& answers) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  for (std::size_t i = 0; i < set.rays.size(); ++i) {
    const Ray<float>& ray = set.rays[i];
    RTCRayHit all{};
    all.ray.org_x = ray.origin.x, all.ray.org_y = ray.origin.y, all.ray.org_z = ray.origin.z;
    all.ray.dir_x = ray.direction.x, all.ray.dir_y = ray.direction.y, all.ray.dir_z = ray.direction.z;
    all.ray.tfar = set.t_max[i];
    all.ray.mask = ~0U;
    all.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    if (set.want == Want::any) {
      rtcOccluded1(scene, &context, &all.ray);
      answers[i] = all.ray.tfar < 0 ? 0 : -1;
    } else {
      rtcIntersect1(scene, &context, &all);
      answers[i] = all.hit.geomID == RTC_INVALID_GEOMETRY_ID ? -1 : static_cast<int>(all.hit.primID);
    }
  }
}

void trace_by_sixteen(RTCScene scene, const RaySet& set, std::vector<int>& answers) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  if (set.coherent) context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  for (std::size_t first = 0; first < set.rays.size(); first += 16) {
    alignas(64) RTCRayHit16 all{};
    alignas(64) int valid[16];
    const std::size_t count = std::min<std::size_t>(16, set.rays.size() - first);
    for (std::size_t i = 0; i < 16; ++i) {
      valid[i] = i < count ? -1 : 0;
      const Ray<float>& ray = set.rays[i < count ? first + i : first];
      all.ray.org_x[i] = ray.origin.x, all.ray.org_y[i] = ray.origin.y, all.ray.org_z[i] = ray.origin.z;
      all.ray.dir_x[i] = ray.direction.x, all.ray.dir_y[i] = ray.direction.y, all.ray.dir_z[i] = ray.direction.z;
      all.ray.tfar[i] = set.t_max[i < count ? first + i : first];
      all.ray.mask[i] = ~0U;
      all.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
    }
    if (set.want == Want::any)
      rtcOccluded16(valid, scene, &context, &all.ray);
    else
      rtcIntersect16(valid, scene, &context, &all);
    for (std::size_t i = 0; i < count; ++i)
      answers[first + i] = set.want == Want::any                          ? (all.ray.tfar[i] < 0 ? 0 : -1)
                           : all.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID ? -1
                                                                          : static_cast<int>(all.hit.primID[i]);
  }
}

#endif

// ---------------------------------------------------------------------------------------------------------------------
// The judge

#ifdef RAYWALK_ORACLE

// The truth of one ray, by rational arithmetic over all triangles whose boxes it does not clearly miss.
class Judge {
 public:
  explicit Judge(const Primitives<float>& primitives) : primitives_(primitives) {
    for (int id = 0; id < primitives.size(); ++id) boxes_.push_back(primitives.box(id));
  }

  // Whether `answer` is wrong.
  [[nodiscard]] bool wrong(const Ray<float>& ray, float t_max, Want want, int answer) const {
    const SlabRay<double> slabs(Ray<double>{Vec3d(ray.origin), Vec3d(ray.direction)});
    std::optional<check::Rational> nearest;  // that cannot be disputed
    std::optional<check::Rational> answered;
    for (int id = 0; id < primitives_.size(); ++id) {
      const Bounds<float>& box = boxes_[static_cast<std::size_t>(id)];
      if (clip(slabs, Bounds<double>{Vec3d(box.min), Vec3d(box.max)}, {0, infinity<double>}).empty()) continue;
      const auto truth = check::truth<check::Rational>(primitives_.triangles()[id], ray);
      if (truth.crossings.empty()) continue;
      const check::Rational& t = truth.crossings[0].t;
      if (std::isfinite(t_max) && t >= check::Rational(static_cast<double>(t_max))) continue;
      if (id == answer) answered = t;
      if (!truth.optional && (!nearest || t < *nearest)) nearest = t;
    }
    if (want == Want::any) return nearest.has_value() != (answer >= 0);
    if (answer < 0) return nearest.has_value();
    // Two that are nearer to each other than a float tells apart are both right.
    return !answered || (nearest && answered->get_d() > nearest->get_d() * (1 + 0x1p-22));
  }

 private:
  const Primitives<float>& primitives_;
  std::vector<Bounds<float>> boxes_;
};

#endif

double median(std::vector<double> all) {
  std::nth_element(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2), all.end());
  return all[all.size() / 2];
}

// Returns how many of our own answers are wrong.
int race(const Subject& subject, int thousands, int runs) {
  Primitives<float> primitives;
  primitives.add(subject.mesh, {}, false);
  std::printf("\n%s: %zu triangles\n", subject.name.c_str(), subject.mesh.triangles.size());
  // Built in turn, the first time to warm up.
  constexpr std::array qualities{BuildQuality::fast, BuildQuality::good, BuildQuality::best};
  std::array<std::vector<double>, qualities.size()> build_seconds;
  std::array<std::optional<Accelerator<float>>, qualities.size()> built;
  for (int run = 0; run < runs + 1; ++run)
    for (std::size_t i = 0; i < qualities.size(); ++i) {
      built[i].reset();
      const double begin = processor_seconds();
      built[i].emplace(primitives, AcceleratorKind::bvh, BuildOptions{.quality = qualities[i]});
      if (run > 0) build_seconds[i].push_back(processor_seconds() - begin);
    }
  for (std::size_t i = 0; i < qualities.size(); ++i) {
    const AcceleratorStatistics tree = built[i]->statistics();
    std::printf("ours %-4s built in %.3f s, %.1f MB, %zu nodes, SAH cost %.2f\n",
                std::string(name_of(qualities[i])).c_str(), median(build_seconds[i]),
                static_cast<double>(tree.bytes) / 1e6, tree.nodes, tree.expected_cost);
  }
  const Accelerator<float>&fast = *built[0], &accelerator = *built[1], &best = *built[2];
  std::vector<Racer> racers;
  const auto race_ours = [&](const std::string& name, const Accelerator<float>& tree, double seconds) {
    racers.push_back(
        {name, seconds, [&tree](const RaySet& set, std::vector<int>& answers) { trace_ours(tree, set, answers); }});
  };
  race_ours("ours, fast", fast, median(build_seconds[0]));
  race_ours("ours, best", best, median(build_seconds[2]));
  for (const LaneWidth width : lane_widths())
    racers.push_back({"ours, width " + std::string(name_of(width)), median(build_seconds[1]),
                      [&accelerator, width](const RaySet& set, std::vector<int>& answers) {
                        const ForcedWidth forced(width);
                        trace_ours(accelerator, set, answers);
                      }});
  racers.push_back({"ours, together", median(build_seconds[1]), [&](const RaySet& set, std::vector<int>& answers) {
                      trace_ours_together(accelerator, set, answers);
                    }});
  const std::size_t own = racers.size();
#ifdef RAYWALK_EMBREE
  const EmbreeScene plain(subject.mesh, false), robust(subject.mesh, true);
  std::printf("Embree HIGH built in %.3f s, %.1f MB, robust %.3f s, %.1f MB\n", plain.build_seconds,
              static_cast<double>(plain.tree_bytes) / 1e6, robust.build_seconds,
              static_cast<double>(robust.tree_bytes) / 1e6);
  const auto add = [&](const char* name, const EmbreeScene& scene, auto trace) {
    racers.push_back({name, scene.build_seconds,
                      [&scene, trace](const RaySet& set, std::vector<int>& out) { trace(scene.scene, set, out); }});
  };
  add("Embree single", plain, trace_singly);
  add("Embree robust", robust, trace_singly);
  add("Embree by 16", plain, trace_by_sixteen);
#endif
#ifdef RAYWALK_ORACLE
  const Judge judge(accelerator.primitives());
#endif
  int wrong_of_ours = 0;
  std::printf("%-12s", "");
  for (const Racer& racer : racers) std::printf(" %18s", racer.name.c_str());
  std::printf("   million rays a second of processor time (wrong answers)\n");
  for (const RaySet& set : ray_sets(subject, accelerator, thousands)) {
    std::vector<std::vector<int>> answers(racers.size(), std::vector<int>(set.rays.size()));
    std::vector<std::vector<double>> seconds(racers.size());
    // Each traces the rays twice, and the second time counts: its tree is in the caches then as far as they hold it, as
    // amid a picture; else it would depend on who came before. In another order each time.
    std::vector<std::size_t> order(racers.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::mt19937 shuffler(1);
    for (int run = 0; run < std::max(runs, 1); ++run) {
      std::shuffle(order.begin(), order.end(), shuffler);
      for (const std::size_t i : order) {
        racers[i].trace(set, answers[i]);
        const double start = processor_seconds();
        racers[i].trace(set, answers[i]);
        seconds[i].push_back(processor_seconds() - start);
      }
    }
    std::vector<int> wrong(racers.size(), 0);
#ifdef RAYWALK_ORACLE
    for (std::size_t ray = 0; ray < set.rays.size(); ++ray) {
      bool doubted = ray % 997 == 0;
      for (std::size_t i = 1; i < racers.size(); ++i) doubted = doubted || answers[i][ray] != answers[0][ray];
      if (!doubted) continue;
      for (std::size_t i = 0; i < racers.size(); ++i)
        wrong[i] += judge.wrong(set.rays[ray], set.t_max[ray], set.want, answers[i][ray]);
    }
#endif
    std::printf("%-12s", set.name.c_str());
    for (std::size_t i = 0; i < racers.size(); ++i) {
      std::printf("  %9.2f (%5d)", static_cast<double>(set.rays.size()) / median(seconds[i]) / 1e6, wrong[i]);
      if (i < own) wrong_of_ours += wrong[i];
    }
    std::printf("   nodes and triangles a ray, fast, good and best:");
    for (const Accelerator<float>* tree : {&fast, &accelerator, &best}) {
      const TestCounts counts = trace_ours(*tree, set, answers[0]);
      const auto rays = static_cast<double>(set.rays.size());
      std::printf(" %.1f %.1f;", static_cast<double>(counts.nodes) / rays,
                  static_cast<double>(counts.primitives) / rays);
    }
    std::printf("\n");
  }
  return wrong_of_ours;
}

}  // namespace

int main(int argc, char** argv) {
  const int thousands = argc > 1 ? std::atoi(argv[1]) : 1000, runs = argc > 2 ? std::atoi(argv[2]) : 5;
  std::vector<std::string> names(argv + std::min(argc, 3), argv + argc);
  if (names.empty()) names = {"bunny", "million", "slivers", "soup"};
  if (thousands < 1 || runs < 1) {
    std::fputs(
        "usage: benchmark_mesh_race [THOUSANDS OF RAYS] [RUNS] [bunny] [million] [ten] [slivers] [soup] [NUMBER]\n",
        stderr);
    return 2;
  }
  int wrong = 0;
  for (const std::string& name : names) {
    std::optional<Subject> subject;
    if (name == "bunny") subject = bunny();
    if (name == "million") subject = hills("a million triangles", 708);
    if (name == "ten") subject = hills("ten million triangles", 2236);
    if (const double triangles = std::atof(name.c_str()); triangles >= 2 && triangles <= 1e8)
      subject = hills("hills", static_cast<int>(std::lround(std::sqrt(triangles / 2))));
    if (name == "slivers") subject = slivers();
    if (name == "soup") subject = soup();
    if (!subject) {
      std::printf("%s: skipped, there is no such mesh\n", name.c_str());
      continue;
    }
    wrong += race(*subject, thousands, runs);
  }
  if (wrong > 0) std::printf("\n%d of our answers are wrong\n", wrong);
  return wrong > 0 ? 1 : 0;
}
