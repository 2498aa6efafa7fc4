#include "io/transform_words.h"

#include <algorithm>

namespace raywalk::detail {

namespace {

std::vector<double> numbers(const Translate& step) { return {step.by.x, step.by.y, step.by.z}; }
std::vector<double> numbers(const Rotate& step) { return {step.axis.x, step.axis.y, step.axis.z, step.degrees}; }
std::vector<double> numbers(const Scale& step) { return {step.by.x, step.by.y, step.by.z}; }
std::vector<double> numbers(const Mirror& step) { return {step.normal.x, step.normal.y, step.normal.z}; }
std::vector<double> numbers(const Shear& step) { return {step.xy, step.xz, step.yx, step.yz, step.zx, step.zy}; }
std::vector<double> numbers(const Matrix& step) { return {step.rows.begin(), step.rows.end()}; }

}  // namespace

TransformStep step_from(std::size_t index, const std::vector<double>& n) {
  switch (index) {
    case 0:
      return {Translate{{n[0], n[1], n[2]}}};
    case 1:
      return {Rotate{{n[0], n[1], n[2]}, n[3]}};
    case 2:
      return {Scale{{n[0], n[1], n[2]}}};
    case 3:
      return {Mirror{{n[0], n[1], n[2]}}};
    case 4:
      return {Shear{n[0], n[1], n[2], n[3], n[4], n[5]}};
  }
  Matrix matrix;
  std::copy(n.begin(), n.end(), matrix.rows.begin());
  return {matrix};
}

std::vector<double> numbers_of(const TransformStep& step) {
  return std::visit([](const auto& kind) { return numbers(kind); }, step.kind);
}

}  // namespace raywalk::detail
