#include "scene/transform_step.h"

namespace raywalk {

namespace {

Affine<double> affine_of(const Translate& step) { return translation(step.by); }

Affine<double> affine_of(const Rotate& step) { return rotation(step.axis, step.degrees); }

Affine<double> affine_of(const Scale& step) { return scaling(step.by); }

Affine<double> affine_of(const Mirror& step) {
  const Vec3d n = normalize(step.normal);
  const auto image = [&](const Vec3d& v) { return v - 2 * dot(v, n) * n; };
  return {image({1, 0, 0}), image({0, 1, 0}), image({0, 0, 1}), Vec3d(0.0)};
}

Affine<double> affine_of(const Shear& step) {
  return {{1, step.yx, step.zx}, {step.xy, 1, step.zy}, {step.xz, step.yz, 1}, Vec3d(0.0)};
}

Affine<double> affine_of(const Matrix& step) {
  const auto& r = step.rows;
  return {{r[0], r[4], r[8]}, {r[1], r[5], r[9]}, {r[2], r[6], r[10]}, {r[3], r[7], r[11]}};
}

}  // namespace

Affine<double> affine_of(const std::vector<TransformStep>& steps) {
  Affine<double> all;
  for (const TransformStep& step : steps)
    all = std::visit([](const auto& kind) { return affine_of(kind); }, step.kind) * all;
  return all;
}

}  // namespace raywalk
