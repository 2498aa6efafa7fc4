#pragma once

namespace raywalk {

/// Lambdas as one, for std::visit: `std::visit(Overloaded{[](int) {...}, [](const auto&) {...}}, variant)`.
template <class... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};
template <class... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;

}  // namespace raywalk
