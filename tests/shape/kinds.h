#pragma once

#include "shape/quadric.h"

#include <type_traits>
#include <utility>

namespace raywalk::test {

/// Calls `body` with each kind of quadric, as a type.
template <class Body>
void for_each_kind(Body body) {
  const auto call = [&]<QuadricKind... Kinds>(std::integer_sequence<QuadricKind, Kinds...>) {
    (body(std::integral_constant<QuadricKind, Kinds>{}), ...);
  };
  call(std::integer_sequence<QuadricKind, QuadricKind::ellipsoid, QuadricKind::elliptic_paraboloid, QuadricKind::cone,
                             QuadricKind::cylinder, QuadricKind::hyperboloid_one_sheet,
                             QuadricKind::hyperboloid_two_sheets>{});
}

}  // namespace raywalk::test
