#include "render/render.h"

#include "render/memory_need.h"
#include "render/parallel.h"
#include "render/picture.h"
#include "render/tiles.h"
#include "trace/recursion.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <mutex>
#include <new>
#include <numeric>
#include <stdexcept>
#include <thread>
#include <utility>

namespace raywalk {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// Calls the progress callback at most a few times a second, in the one thread that may.
class Reporter {
 public:
  Reporter(const RenderSettings& settings, Clock::time_point start) : settings_(settings), start_(start) {}

  void report(double done) {
    if (!settings_.progress || std::this_thread::get_id() != caller_) return;
    const double seconds = seconds_since(start_);
    if (done < 1 && seconds < next_) return;
    next_ = seconds + interval;
    settings_.progress({done, seconds, done > 0 ? seconds * (1 - done) / done : 0});
  }

 private:
  static constexpr double interval = 0.1;
  const RenderSettings& settings_;
  Clock::time_point start_;
  std::thread::id caller_ = std::this_thread::get_id();
  double next_ = interval;
};

/// Roughly, of the whole image: a few to each path, or one to each light.
double expected_rays(const Scene& scene, const RenderSettings& settings, ImageSize size) {
  constexpr double of_path = 8;
  const double of_sample = traits_of(integrator_of(scene, settings.sampling.per_pixel)).is_global
                               ? of_path
                               : 1 + static_cast<double>(scene.lights.size());
  return static_cast<double>(size.width) * size.height * settings.sampling.per_pixel * of_sample;
}

/// `size` pixels, which are the image `whole` or a strip of it.
template <class T>
Rendering render_in(const Scene& scene, const RenderSettings& settings, ImageSize size, ImageSize whole) {
  const auto build_start = Clock::now();
  World<T> world(scene, settings.accelerator, settings.fault,
                 {settings.stop, nullptr, settings.build, expected_rays(scene, settings, size)});
  world.shadow_cache = settings.shadow_cache.value_or(world.accelerator.kind() != AcceleratorKind::none);
  Picture<T> picture(scene, world, size, whole, settings.sampling, settings.tolerance);
  if (settings.share) picture.restrict_to(*settings.share);
  Rendering rendering;
  rendering.effects = effects_of(scene, settings.sampling.per_pixel);
  rendering.accelerator = world.accelerator.kind();
  rendering.structure = world.accelerator.statistics();
  rendering.build_seconds = seconds_since(build_start);

  if (settings.endless && !traits_of(scene.render.integrator).is_global)  // paths do not branch
    if (const auto tree =
            endless_tree(world, picture.kernel(), picture.camera(), size, settings.sampling.per_pixel, settings.stop))
      settings.endless(*tree);

  const auto trace_start = Clock::now();
  const Tiles tiles(size);
  std::vector<int> order(static_cast<std::size_t>(tiles.count()));
  std::iota(order.begin(), order.end(), 0);
  if (settings.reorder_tiles) settings.reorder_tiles(order);

  std::atomic<std::uint64_t> taken{0};
  // Photons are sent before the samples that look for them: all at once or, where each sample has its own, in between.
  const PhotonKernel<T>* photons = picture.kernel().photons();
  const bool in_between = photons && photons->settings().progressive;
  const double all_photons =
      photons ? static_cast<double>(photons->settings().count) * (in_between ? settings.sampling.per_pixel : 1) : 0;
  std::atomic<std::uint64_t> sent{0};
  std::atomic<double> solved{0};  // of radiosity's shots
  const auto done_of = [&](double all_samples) {
    constexpr double of_shots = 0.8;  // of a picture's time, roughly
    if (picture.kernel().shoots_light())
      return of_shots * solved + (1 - of_shots) * static_cast<double>(taken) / all_samples;
    constexpr double photon = 0.25;  // of a sample's time, roughly
    return (static_cast<double>(taken) + photon * static_cast<double>(sent)) / (all_samples + photon * all_photons);
  };
  std::mutex results_mutex;
  std::map<std::thread::id, double> busy;
  int begun = 0;  // rows
  Reporter reporter(settings, trace_start);
  constexpr double almost = 0.9999;  // completion is reported once, when no thread is working any more
  // A ray through a long list takes long, and the tracer asks whether it is cancelled only where a pixel has many rays.
  constexpr int long_list = 1000;
  const bool slow = rendering.accelerator == AcceleratorKind::none && world.accelerator.primitives().size() > long_list;
  int from = 0, to = 0;  // samples
  // Each tile's pixels are written by one thread only, and statistics are integers: neither the order of the tiles nor
  // their threads can change the result.
  const auto trace_tile = [&](int position) {
    const auto tile_start = Clock::now();
    Statistics statistics;
    const PixelBlock tile = tiles.block(order[static_cast<std::size_t>(position)]);
    int begun_here = 0;
    std::uint64_t put_here = 0;  // pixels of a row that is cancelled half-way count too
    const auto count = [&put_here] { ++put_here; };
    PixelBlock run = tile;
    run.stop = settings.stop;
    const int max_samples = slow ? 1 : 16, max_columns = slow ? 1 : tile.column_end;
    const auto trace_rows = [&] {
      run.samples = std::min(max_samples, to - run.sample);
      for (run.row_begin = tile.row_begin; run.row_begin < tile.row_end; ++run.row_begin) {
        run.row_end = run.row_begin + 1;
        for (run.column_begin = tile.column_begin; run.column_begin < tile.column_end;
             run.column_begin = run.column_end) {
          settings.stop.check();
          run.column_end = std::min(tile.column_end, run.column_begin + max_columns);
          begun_here = std::max(begun_here, run.row_end);
          statistics += picture.trace(run, count);
        }
        const double all = static_cast<double>(picture.expected());
        taken += std::exchange(put_here, 0);
        reporter.report(std::min(almost, done_of(all)));
      }
    };
    try {
      for (run.sample = from; run.sample < to; run.sample += run.samples) trace_rows();
    } catch (const Stopped&) {
      taken += put_here;
    }
    const std::lock_guard lock(results_mutex);
    rendering.statistics += statistics;
    begun = std::max(begun, begun_here);
    busy[std::this_thread::get_id()] += seconds_since(tile_start);
  };
  const std::size_t stack = std::max(default_stack, stack_for(scene.limits.depth));
  const RunAll in_threads = [&](int count, const std::function<void(int)>& body) {
    parallel_for(count, settings.threads, body, stack, [&] { static_cast<void>(settings.stop.asked()); });
  };
  const auto count_sent = [&](int more) {
    sent += static_cast<std::uint64_t>(more);
    reporter.report(std::min(almost, done_of(static_cast<double>(picture.expected()))));
  };
  const auto shoot_light = [&] {
    Shooting shooting{in_threads};
    // Unshot light falls ever more slowly: its fourth root falls about evenly.
    const auto far = [](double share) { return std::sqrt(std::sqrt(share)); };
    const double least = std::clamp(scene.render.radiosity.tolerance, 1e-9, 0.5);
    shooting.shot = [&](double share) {
      solved = std::clamp((1 - far(share)) / (1 - far(least)), 0.0, 1.0);
      reporter.report(std::min(almost, done_of(static_cast<double>(picture.expected()))));
    };
    picture.kernel().shoot_light(settings.stop, shooting);
    solved = 1;
  };
  const auto trace_samples = [&] {
    try {
      shoot_light();
      rendering.statistics +=
          picture.kernel().send_photons(settings.sampling.seed, from, to, settings.stop, in_threads, count_sent);
    } catch (const Stopped&) {
      return;
    }
    rendering.threads = std::max(rendering.threads, parallel_for(tiles.count(), settings.threads, trace_tile, stack));
  };
  do {
    for (from = picture.from(); from < picture.to() && !settings.stop.asked(); from = to) {
      to = in_between ? from + 1 : picture.to();
      trace_samples();
    }
  } while (!settings.stop.asked() && picture.next());

  rendering.finished = taken == picture.expected();
  rendering.done = static_cast<double>(taken) / static_cast<double>(picture.expected());
  rendering.trace_seconds = seconds_since(trace_start);
  for (const auto& [thread, seconds] : busy) rendering.busy_seconds.push_back(seconds);
  if (rendering.finished) reporter.report(1);
  picture.film().set_begun(begun);
  const bool from_corners = settings.sampling.corners && !settings.share;
  Film<T> film = from_corners ? mean_of_corners(picture.film()) : std::move(picture.film());
  const bool pixel_is_sample = settings.sampling.per_pixel == 1 && !from_corners;
  rendering.not_finite_pixels =
      pixel_is_sample ? static_cast<std::size_t>(rendering.statistics.not_finite) : not_finite(film);
  rendering.film = std::move(film);
  return rendering;
}

/// The larger one is named first, and the hint is about it.
tl::unexpected<Error> no_memory(const Scene& scene, ImageSize size) {
  constexpr double of_a_pixel = 24, of_an_entry = 150;  // bytes, roughly
  const double pixels = static_cast<double>(size.width) * size.height, entries = entries_of(scene.objects);
  const std::string picture =
      "the picture of " + std::to_string(size.width) + " x " + std::to_string(size.height) + " pixels";
  const std::string content =
      "the scene of " + std::to_string(static_cast<std::int64_t>(entries)) + " objects and triangles";
  const bool is_large = pixels * of_a_pixel > entries * of_an_entry;
  return tl::unexpected(Error{
      "", 0, 0, (is_large ? picture : content) + " does not fit into memory, beside " + (is_large ? content : picture),
      is_large ? "choose a smaller size" : "close other programs, use smaller meshes, or --precision float"});
}

/// Of a render that was stopped before its first pixel: not even a film, which may be large.
Rendering stopped_before(const RenderSettings& settings) {
  Rendering nothing;
  if (settings.precision == Precision::float_)
    nothing.film = Film<float>();
  else
    nothing.film = Film<double>();
  nothing.done = 0;
  nothing.finished = false;
  return nothing;
}

Result<Rendering> render_pixels(const Scene& scene, const RenderSettings& settings, ImageSize size, ImageSize whole) {
  if (const auto error = why_too_deep(scene.limits.depth)) return tl::unexpected(*error);
  RenderSettings of_picture = settings;
  of_picture.size = size;
  if (const auto error = why_too_large(memory_needed(scene, of_picture), "")) return tl::unexpected(*error);
  try {
    if (cuts_patches(scene))
      if (const auto error = why_no_patches(scene, settings.stop)) return tl::unexpected(*error);
    switch (settings.precision) {
      case Precision::float_:
        return render_in<float>(scene, settings, size, whole);
      case Precision::double_:
        return render_in<double>(scene, settings, size, whole);
    }
  } catch (const Stopped&) {
    return stopped_before(settings);
  } catch (const std::bad_alloc&) {
    return no_memory(scene, size);
  } catch (const std::length_error&) {
    return no_memory(scene, size);
  }
  return Rendering{};
}

}  // namespace

Result<Rendering> render(const Scene& scene, const RenderSettings& settings) {
  const ImageSize size = settings.size.value_or(scene.image);
  const int more = settings.sampling.corners ? 1 : 0;
  return render_pixels(scene, settings, {size.width + more, size.height + more}, size);
}

Result<Rendering> render_strip(const Scene& scene, const RenderSettings& settings) {
  RenderSettings of_cells = settings;
  of_cells.sampling.corners = false;
  return render_pixels(scene, of_cells, {scene.camera.screen.cells, 1}, settings.size.value_or(scene.image));
}

}  // namespace raywalk
