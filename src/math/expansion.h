#pragma once
// Exact arithmetic on doubles, for the rays that no rounded arithmetic can decide: every sum, difference and product is
// exact, short of over- and underflow.
//
// J. R. Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates", Discrete and
// Computational Geometry 18, 1997: a number is a sum of doubles whose bits do not overlap.

#include "math/double_double.h"

#include <cstddef>
#include <vector>

namespace raywalk {

class Expansion {
 public:
  Expansion() = default;
  Expansion(double value) {  // NOLINT(google-explicit-constructor): every double is one exactly
    if (value != 0) terms_.push_back(value);
  }

  /// -1, 0 or 1: that of the largest term.
  [[nodiscard]] int sign() const { return terms_.empty() ? 0 : terms_.back() > 0 ? 1 : -1; }

  /// The value to about 100 bits, for what is not a sign.
  [[nodiscard]] DoubleDouble rounded() const {
    DoubleDouble sum;
    for (std::size_t i = terms_.size(); i-- > 0;) sum = sum + DoubleDouble(terms_[i]);
    return sum;
  }

  friend Expansion operator-(Expansion x) {
    for (double& term : x.terms_) term = -term;
    return x;
  }
  friend Expansion operator+(const Expansion& x, const Expansion& y) {
    Expansion sum = x;
    for (const double term : y.terms_) sum.add(term);
    return sum.compressed();
  }
  friend Expansion operator-(const Expansion& x, const Expansion& y) { return x + -y; }
  friend Expansion operator*(const Expansion& x, const Expansion& y) {
    Expansion product;
    for (const double a : x.terms_)
      for (const double b : y.terms_) {
        const DoubleDouble both = two_product(a, b);
        product.add(both.lo);
        product.add(both.hi);
      }
    return product.compressed();
  }

 private:
  /// Grow-expansion: the terms stay in ascending order and do not overlap.
  void add(double value) {
    std::size_t kept = 0;
    for (const double term : terms_) {
      const DoubleDouble sum = two_sum(value, term);
      if (sum.lo != 0) terms_[kept++] = sum.lo;
      value = sum.hi;
    }
    terms_.resize(kept);
    if (value != 0) terms_.push_back(value);
  }

  /// The same number in the fewest terms, so that products of products stay short.
  [[nodiscard]] Expansion compressed() const {
    Expansion shorter;
    if (terms_.empty()) return shorter;
    std::vector<double> down;  // descending
    double carried = terms_.back();
    for (std::size_t i = terms_.size() - 1; i-- > 0;) {
      const DoubleDouble sum = two_sum(carried, terms_[i]);
      carried = sum.hi;
      if (sum.lo != 0) down.push_back(sum.hi), carried = sum.lo;
    }
    for (std::size_t i = down.size(); i-- > 0;) {
      const DoubleDouble sum = two_sum(down[i], carried);
      if (sum.lo != 0) shorter.terms_.push_back(sum.lo);
      carried = sum.hi;
    }
    if (carried != 0) shorter.terms_.push_back(carried);
    return shorter;
  }

  std::vector<double> terms_;  ///< ascending; none is 0
};

}  // namespace raywalk
