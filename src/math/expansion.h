#pragma once
// Exact arithmetic on doubles, for the rays that rounded arithmetic cannot decide: every sum, difference and product is
// exact, barring over- and underflow.
//
// J. R. Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates", Discrete and
// Computational Geometry 18, 1997: a number is a sum of doubles whose bits do not overlap.

#include "math/double_double.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace raywalk {

namespace detail {

/// A vector of doubles that uses no heap while it is small, as it nearly always is: allocation took half of the time of
/// exact arithmetic.
class Terms {
 public:
  Terms() {}  // NOLINT(modernize-use-equals-default): the storage stays uninitialised
  Terms(const Terms& other) { *this = other; }
  Terms& operator=(const Terms& other) {
    if (this == &other) return *this;
    size_ = 0;
    reserve(other.size_);
    std::copy_n(other.first_, other.size_, first_);
    size_ = other.size_;
    return *this;
  }
  Terms(Terms&& other) noexcept { *this = std::move(other); }
  Terms& operator=(Terms&& other) noexcept {
    if (this == &other) return *this;
    if (other.first_ == other.few_) {  // it fits into the fixed storage
      std::copy_n(other.few_, other.size_, first_);
    } else {
      many_ = std::move(other.many_);
      first_ = many_.data();
      room_ = many_.size();
      other.first_ = other.few_;
      other.room_ = inline_capacity;
    }
    size_ = std::exchange(other.size_, 0);
    return *this;
  }
  ~Terms() = default;

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] double* begin() { return first_; }
  [[nodiscard]] double* end() { return first_ + size_; }
  [[nodiscard]] const double* begin() const { return first_; }
  [[nodiscard]] const double* end() const { return first_ + size_; }
  [[nodiscard]] double operator[](std::size_t i) const { return first_[i]; }
  [[nodiscard]] double back() const { return first_[size_ - 1]; }

  void push_back(double term) {
    if (size_ == room_) reserve(2 * room_);
    first_[size_++] = term;
  }

 private:
  static constexpr std::size_t inline_capacity = 16;

  void reserve(std::size_t room) {
    if (room <= room_) return;
    std::vector<double> more(room);
    std::copy_n(first_, size_, more.data());
    many_ = std::move(more);
    first_ = many_.data();
    room_ = room;
  }

  double few_[inline_capacity];
  std::vector<double> many_;  ///< the storage once there are more
  double* first_ = few_;
  std::size_t size_ = 0, room_ = inline_capacity;
};

}  // namespace detail

class Expansion {
 public:
  Expansion() {}             // NOLINT(modernize-use-equals-default): the storage for terms stays uninitialised
  Expansion(double value) {  // NOLINT(google-explicit-constructor): every double is exactly representable
    if (value != 0) terms_.push_back(value);
  }

  /// -1, 0 or 1: the sign of the largest term.
  [[nodiscard]] int sign() const { return terms_.empty() ? 0 : terms_.back() > 0 ? 1 : -1; }

  /// The value to about 100 bits, where not only the sign matters.
  [[nodiscard]] DoubleDouble rounded() const {
    DoubleDouble sum;
    for (std::size_t i = terms_.size(); i-- > 0;) sum = sum + DoubleDouble(terms_[i]);
    return sum;
  }

  friend Expansion operator-(Expansion x) {
    for (double& term : x.terms_) term = -term;
    return x;
  }
  friend Expansion operator+(const Expansion& x, const Expansion& y) { return sum(x, y).compressed(); }
  friend Expansion operator-(const Expansion& x, const Expansion& y) { return x + -y; }
  friend Expansion operator*(const Expansion& x, const Expansion& y) {
    const bool x_is_longer = x.terms_.size() > y.terms_.size();
    const Expansion &longer = x_is_longer ? x : y, &shorter = x_is_longer ? y : x;
    Expansion product;
    for (const double term : shorter.terms_) product = sum(product, scaled(longer, term));
    return product.compressed();
  }

 private:
  void keep(double term) {
    if (term != 0) terms_.push_back(term);
  }

  /// Fast-expansion-sum: the terms of both merged by size, each added to the carry of the smaller ones.
  [[nodiscard]] static Expansion sum(const Expansion& x, const Expansion& y) {
    if (x.terms_.empty()) return y;
    if (y.terms_.empty()) return x;
    const double *a = x.terms_.begin(), *b = y.terms_.begin();
    const double *const a_end = x.terms_.end(), *const b_end = y.terms_.end();
    const auto next = [&] { return b == b_end || (a != a_end && std::abs(*a) <= std::abs(*b)) ? *a++ : *b++; };
    Expansion all;
    double carried = next();
    while (a != a_end || b != b_end) {
      const DoubleDouble both = two_sum(carried, next());
      all.keep(both.lo);
      carried = both.hi;
    }
    all.keep(carried);
    return all;
  }

  /// Scale-expansion.
  [[nodiscard]] static Expansion scaled(const Expansion& x, double by) {
    Expansion all;
    double carried = 0;
    for (const double term : x.terms_) {
      const DoubleDouble product = two_product(term, by);
      const DoubleDouble low = two_sum(carried, product.lo);
      const DoubleDouble high = two_sum(product.hi, low.hi);
      all.keep(low.lo);
      all.keep(high.lo);
      carried = high.hi;
    }
    all.keep(carried);
    return all;
  }

  /// The same number in the fewest terms, so that products of products stay short.
  [[nodiscard]] Expansion compressed() const {
    if (terms_.size() < 2) return *this;
    Expansion shorter;
    detail::Terms down;  // descending
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

  detail::Terms terms_;  ///< ascending; none is 0
};

}  // namespace raywalk
