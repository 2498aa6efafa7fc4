// The stack of the bodies that a ray is inside of, by itself. Stands alone, for tests/mutants.

#include "support/catch.h"
#include "trace/media.h"

using namespace raywalk;

namespace {

// Bodies 0, 1, 2, ... of these priorities.
Bodies of(const std::vector<double>& priorities) {
  Bodies bodies;
  for (const double priority : priorities) bodies.list.push_back({0, priority, false});
  return bodies;
}

// Body n entered as n, left as -n - 1, in turn.
BodyStack after(const std::vector<int>& crossings, const Bodies& bodies) {
  BodyStack stack;
  for (const int each : crossings) each >= 0 ? enter(stack, each, bodies) : leave(stack, -each - 1);
  return stack;
}

}  // namespace

TEST_CASE("among equals the body entered last and not yet left is on top") {
  const Bodies bodies = of({0, 0, 0});
  CHECK(after({}, bodies).empty());
  CHECK(after({0, 1, 2}, bodies) == BodyStack{0, 1, 2});
  CHECK(after({2, 0, 1}, bodies) == BodyStack{2, 0, 1});
  CHECK(after({0, 1, -2}, bodies) == BodyStack{0});
  CHECK(after({0, 1, -1}, bodies) == BodyStack{1});
  CHECK(after({0, 1, -1, -2}, bodies).empty());
}

TEST_CASE("a higher priority lies above, whenever it was entered") {
  const Bodies bodies = of({1, 0, 0, -1, 1});
  CHECK(after({0, 1, 2}, bodies) == BodyStack{1, 2, 0});
  CHECK(after({1, 0, 3}, bodies) == BodyStack{3, 1, 0});
  CHECK(after({0, 1, 4, 2}, bodies) == BodyStack{1, 2, 0, 4});
  CHECK(after({0, 1, 4, 2, -1, -2}, bodies) == BodyStack{2, 4});
}

TEST_CASE("what is entered twice is there once, and what was not entered is not left") {
  const Bodies bodies = of({0, 0});
  CHECK(after({0, 1, 0}, bodies) == BodyStack{0, 1});
  CHECK(after({0, 1, 0, -1}, bodies) == BodyStack{1});
  CHECK(after({0, -2}, bodies) == BodyStack{0});
}
