#include "timeline/recorder.h"

#include "trace/beam_kernel.h"
#include "trace/scene_kernel.h"

namespace raywalk {

namespace {

template <class T>
Timeline record_in(const Scene& scene, ImageSize size, ImageSize whole, const PixelBlock& block, const Recording& how) {
  const bool flat = size.height == 1 && is_planar(scene);
  WorldCache own;
  const auto world =
      (how.worlds != nullptr ? *how.worlds : own).of<T>(scene, AcceleratorKind::automatic, how.fault, how.stop);
  const RayGenerator<T> camera(scene, size, whole, how.sampling);
  Recorder recorder;
  const SceneKernel<T> kernel(scene, *world, std::nullopt, flat);
  if (kernel.photons()) {
    static_cast<void>(kernel.send_photons(how.sampling.seed, 0, how.sampling.per_pixel, how.stop));
    kernel.photons()->watch_photons(how.photons, recorder, how.stop);
  }
  if (kernel.radiosity()) {
    kernel.shoot_light(how.stop);
    Shooting watched;
    if (flat) watched.walked = how.shots, watched.single = how.single_shots;
    kernel.radiosity()->watch_shots(watched, recorder, how.stop);
  }
  Statistics statistics;
  // Pixel by pixel, each with all its samples, so that one can watch them accumulate.
  for (int row = block.row_begin; row < block.row_end; ++row)
    for (int column = block.column_begin; column < block.column_end; ++column)
      for (int sample = 0; sample < how.sampling.per_pixel; ++sample)
        statistics += kernel.watched(camera, {column, column + 1, row, row + 1, sample, 1, 1, how.stop}, recorder);
  Timeline timeline = recorder.take(size, statistics);
  if (kernel.photons()) timeline.set_photons(kernel.photons()->shared_maps(), flat);
  if (kernel.radiosity()) timeline.set_patches(kernel.radiosity()->patches(), flat);
  if (kernel.has_flat_cones()) timeline.set_flat();
  return timeline;
}

/// In double whatever is asked for: their places have twice its bits. One sample: a beam is all of them.
Timeline record_beams(const Scene& scene, ImageSize size, ImageSize whole, const PixelBlock& block,
                      const Recording& how) {
  WorldCache own;
  const auto world =
      (how.worlds != nullptr ? *how.worlds : own).of<double>(scene, AcceleratorKind::automatic, {}, how.stop);
  const RayGenerator<double> camera(scene, size, whole);
  const std::vector<Outline> outlines = outlines_of(scene);
  Recorder recorder;
  PixelBlock pixels = block;
  pixels.stop = how.stop;
  const Statistics statistics = trace_beams_watched(*world, outlines, camera, pixels, recorder);
  return recorder.take(size, statistics);
}

Timeline record(const Scene& scene, ImageSize size, ImageSize whole, const PixelBlock& block, const Recording& how) {
  if (follows_beams(scene, how) && size.height == 1) return record_beams(scene, size, whole, block, how);
  switch (how.precision) {
    case Precision::float_:
      return record_in<float>(scene, size, whole, block, how);
    case Precision::double_:
      return record_in<double>(scene, size, whole, block, how);
  }
  return {};
}

}  // namespace

bool follows_beams(const Scene& scene, const Recording& how) {
  return scene.render.integrator == Integrator::beams && !how.fault && why_no_beams(scene).empty();
}

Timeline record_strip(const Scene& scene, const Recording& how) {
  const int cells = scene.camera.screen.cells;
  return record(scene, {cells, 1}, scene.image, {0, cells, 0, 1}, how);
}

Timeline record_cell(const Scene& scene, int cell, const Recording& how) {
  return record(scene, {scene.camera.screen.cells, 1}, scene.image, {cell, cell + 1, 0, 1}, how);
}

Timeline record_pixel(const Scene& scene, ImageSize size, int column, int row, const Recording& how) {
  return record(scene, size, size, {column, column + 1, row, row + 1}, how);
}

}  // namespace raywalk
