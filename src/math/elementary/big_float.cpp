#include "math/elementary/big_float.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <tuple>
#include <utility>

namespace raywalk {
namespace {

using Words = std::vector<std::uint32_t>;

constexpr double word_base = 4294967296.0;

std::size_t size_of(int words) { return static_cast<std::size_t>(words); }

}  // namespace

BigFloat::BigFloat(bool negative, std::int64_t exponent, Words digits, int words)
    : negative_(negative), exponent_(exponent), words_(std::move(digits)) {
  const auto first = std::find_if(words_.begin(), words_.end(), [](std::uint32_t word) { return word != 0; });
  exponent_ -= first - words_.begin();
  words_.erase(words_.begin(), first);
  words_.resize(size_of(words));
}

BigFloat::BigFloat(std::uint64_t mantissa, std::int64_t exponent, int words)
    : BigFloat(
          BigFloat(false, 2, {static_cast<std::uint32_t>(mantissa >> 32), static_cast<std::uint32_t>(mantissa)}, words)
              .times_power_of_two(exponent)) {}

BigFloat::BigFloat(double value, int words) : BigFloat(std::uint64_t{0}, 0, words) {
  int exponent = 0;
  const double mantissa = std::frexp(std::abs(value), &exponent);
  *this = BigFloat(static_cast<std::uint64_t>(mantissa * 0x1p53), exponent - 53, words);
  negative_ = std::signbit(value);
}

BigFloat BigFloat::in_words(int words) const { return {negative_, exponent_, words_, words}; }

BigFloat BigFloat::times_power_of_two(std::int64_t power) const {
  const int bits = static_cast<int>(power & 31);
  Words shifted(words_.size() + 1);
  std::uint64_t carry = 0;
  for (std::size_t i = words_.size(); i-- > 0;) {
    carry |= static_cast<std::uint64_t>(words_[i]) << bits;
    shifted[i + 1] = static_cast<std::uint32_t>(carry);
    carry >>= 32;
  }
  shifted[0] = static_cast<std::uint32_t>(carry);
  return {negative_, exponent_ + 1 + (power - bits) / 32, std::move(shifted), words()};
}

BigFloat BigFloat::whole() const {
  Words kept = words_;
  const auto count = std::clamp<std::int64_t>(exponent_, 0, words());
  std::fill(kept.begin() + static_cast<std::ptrdiff_t>(count), kept.end(), 0);
  return {negative_, exponent_, std::move(kept), words()};
}

unsigned BigFloat::modulo_4() const {
  return exponent_ < 1 || exponent_ > words() ? 0 : words_[static_cast<std::size_t>(exponent_ - 1)] & 3;
}

bool BigFloat::outweighs(const BigFloat& term) const {
  return term.is_zero() || (!is_zero() && term.exponent_ < exponent_ - words());
}

double BigFloat::leading() const { return (words_[0] + (words_[1] + words_[2] / word_base) / word_base) / word_base; }

template <class T>
T BigFloat::nearest() const {
  if (is_zero()) return negative_ ? -T(0) : T(0);
  // The 64 leading bits, and whether anything follows them.
  int shift = 0;
  while ((words_[0] << shift & 0x80000000u) == 0) ++shift;
  const std::uint64_t first = static_cast<std::uint64_t>(words_[0]) << 32 | words_[1];
  const std::uint64_t bits = first << shift | static_cast<std::uint64_t>(words_[2]) << shift >> 32;
  const bool more = static_cast<std::uint32_t>(words_[2] << shift) != 0 ||
                    std::any_of(words_.begin() + 3, words_.end(), [](std::uint32_t word) { return word != 0; });
  // The value is bits * 2^exponent. How many of them the float has no room for: more where it is subnormal.
  using Limits = std::numeric_limits<T>;
  const std::int64_t exponent = 32 * exponent_ - shift - 64;
  if (exponent > Limits::max_exponent) return negative_ ? -Limits::infinity() : Limits::infinity();
  const std::int64_t excess =
      std::max<std::int64_t>(64 - Limits::digits, Limits::min_exponent - Limits::digits - exponent);
  std::uint64_t kept = excess < 64 ? bits >> excess : 0;
  if (excess <= 64) {
    const std::uint64_t half = std::uint64_t{1} << (excess - 1), rest = bits & (half | (half - 1));
    if (rest > half || (rest == half && (more || (kept & 1) != 0))) ++kept;
  }
  const T value = std::ldexp(static_cast<T>(kept), static_cast<int>(exponent + excess));
  return negative_ ? -value : value;
}
template float BigFloat::nearest() const;
template double BigFloat::nearest() const;

BigFloat operator-(BigFloat a) {
  a.negative_ = !a.negative_;
  return a;
}

BigFloat operator+(const BigFloat& a, const BigFloat& b) {
  if (a.outweighs(b)) return a;
  if (b.outweighs(a)) return b;
  const bool a_larger = std::tie(a.exponent_, a.words_) > std::tie(b.exponent_, b.words_);
  const BigFloat &large = a_larger ? a : b, &small = a_larger ? b : a;
  const auto lower = static_cast<std::size_t>(large.exponent_ - small.exponent_);
  Words sum(large.words_.size() + lower + 1);  // with a word for the carry, and exact
  std::copy(large.words_.begin(), large.words_.end(), sum.begin() + 1);
  const bool add = large.negative_ == small.negative_;
  std::int64_t carry = 0;
  for (std::size_t i = sum.size(); i-- > 0;) {
    const std::size_t from = i - 1 - lower;  // beyond the end where `small` has no word
    const std::int64_t word = from < small.words_.size() ? small.words_[from] : 0;
    carry += sum[i] + (add ? word : -word);
    sum[i] = static_cast<std::uint32_t>(carry);
    carry >>= 32;
  }
  return {large.negative_, large.exponent_ + 1, std::move(sum), large.words()};
}

BigFloat operator*(const BigFloat& a, const BigFloat& b) {
  const std::size_t n = a.words_.size();
  Words product(2 * n);
  for (std::size_t i = n; i-- > 0;) {
    std::uint64_t carry = 0;
    for (std::size_t j = n; j-- > 0;) {
      carry += static_cast<std::uint64_t>(a.words_[i]) * b.words_[j] + product[i + j + 1];
      product[i + j + 1] = static_cast<std::uint32_t>(carry);
      carry >>= 32;
    }
    product[i] = static_cast<std::uint32_t>(carry);
  }
  return {a.negative_ != b.negative_, a.exponent_ + b.exponent_, std::move(product), a.words()};
}

BigFloat operator/(const BigFloat& a, std::uint32_t b) {
  Words quotient(a.words_.size() + 1);
  std::uint64_t rest = 0;
  for (std::size_t i = 0; i < quotient.size(); ++i) {
    rest = rest << 32 | (i < a.words_.size() ? a.words_[i] : 0);
    quotient[i] = static_cast<std::uint32_t>(rest / b);
    rest %= b;
  }
  return {a.negative_, a.exponent_, std::move(quotient), a.words()};
}

// Newton's method, from a double: each step doubles the number of correct bits, about 50 at first.

BigFloat operator/(const BigFloat& a, const BigFloat& b) {
  const int n = b.words();
  const BigFloat one(1, n);
  BigFloat inverse = BigFloat(1 / b.leading(), n).times_power_of_two(-32 * b.exponent_);
  if (b.negative_) inverse = -inverse;
  for (int bits = 48; bits < 32 * n; bits *= 2) inverse = inverse + inverse * (one - b * inverse);
  return a * inverse;
}

BigFloat sqrt(const BigFloat& a) {
  if (a.is_zero()) return a;
  const int n = a.words();
  const BigFloat one(1, n);
  // 1 / sqrt(a) needs no division.
  BigFloat inverse = BigFloat(1 / std::sqrt(a.leading()), n).times_power_of_two(-16 * a.exponent_);
  for (int bits = 48; bits < 32 * n; bits *= 2)
    inverse = inverse + (inverse * (one - a * inverse * inverse)).times_power_of_two(-1);
  return a * inverse;
}

namespace big {
namespace {

/// z + s z^3 / 3 + z^5 / 5 + s z^7 / 7...: atan(z) for s = -1, the hyperbolic one for s = 1.
BigFloat arc_series(const BigFloat& z, bool hyperbolic) {
  const BigFloat square = hyperbolic ? z * z : -(z * z);
  BigFloat power = z, sum = z;
  for (std::uint32_t divisor = 3;; divisor += 2) {
    power = power * square;
    const BigFloat term = power / divisor;
    if (sum.outweighs(term)) return sum;
    sum = sum + term;
  }
}

/// first + first z / (k (k + 1)) + first z^2 / (k ... (k + 3))..., or, by single steps, / k, / (k (k + 1))...
BigFloat factorial_series(const BigFloat& first, const BigFloat& z, std::uint32_t k, bool double_steps) {
  BigFloat term = first, sum = first;
  for (;; ++k) {
    term = term * z / k;
    if (double_steps) term = term / ++k;
    if (sum.outweighs(term)) return sum;
    sum = sum + term;
  }
}

/// A constant by `evaluate`: kept for the precisions that are asked for every time.
template <class Evaluate>
BigFloat constant(int words, const Evaluate& evaluate) {
  constexpr int usual = 12;
  if (words > usual) return evaluate(words);
  static const BigFloat kept = evaluate(usual);
  return kept.in_words(words);
}

BigFloat ln2(int words) {
  return constant(words, [](int n) { return arc_series(BigFloat(1, n) / 3, true).times_power_of_two(1); });
}

/// The sine for an even number of quarter turns, the cosine for an odd one, from the nearest multiple of pi / 2.
BigFloat sine_ahead(const BigFloat& angle, unsigned quarters) {
  // What is lost: all bits before the point, and some 60, because doubles come that close to a multiple of pi / 2.
  const double size = std::abs(angle.nearest<double>());
  const int n = angle.words(), more = n + 4 + (size > 1 ? std::ilogb(size) / 32 : 0);
  const BigFloat wide = angle.in_words(more), right = pi(more).times_power_of_two(-1);
  const BigFloat half(0.5, more), turns = wide / right;
  const BigFloat count = (turns.is_negative() ? turns - half : turns + half).whole();
  const BigFloat rest = (wide - count * right).in_words(n);
  quarters += count.is_negative() ? 4 - count.modulo_4() : count.modulo_4();
  const BigFloat square = -(rest * rest);
  const BigFloat value =
      quarters % 2 == 0 ? factorial_series(rest, square, 2, true) : factorial_series(BigFloat(1, n), square, 1, true);
  return quarters % 4 < 2 ? value : -value;
}

/// 2 atanh(z) = log((1 + z) / (1 - z)).
BigFloat log_of_ratio(const BigFloat& z) { return arc_series(z, true).times_power_of_two(1); }

}  // namespace

BigFloat pi(int words) {
  return constant(words, [](int n) {  // J. Machin, 1706
    const auto angle = [n](std::uint32_t of) { return arc_series(BigFloat(1, n) / of, false); };
    return angle(5).times_power_of_two(4) - angle(239).times_power_of_two(2);
  });
}

BigFloat sin(const BigFloat& angle) { return sine_ahead(angle, 0); }
BigFloat cos(const BigFloat& angle) { return sine_ahead(angle, 1); }

BigFloat atan2(const BigFloat& y, const BigFloat& x) {
  const int n = x.words();
  const BigFloat one(1, n), high = y.is_negative() ? -y : y, wide = x.is_negative() ? -x : x;
  const bool steep = (wide - high).is_negative();
  BigFloat tangent = steep ? wide / high : high / wide;
  // Three times the half of the angle: below pi / 32.
  for (int i = 0; i < 3; ++i) tangent = tangent / (one + sqrt(one + tangent * tangent));
  BigFloat angle = arc_series(tangent, false).times_power_of_two(3);
  if (steep) angle = pi(n).times_power_of_two(-1) - angle;
  if (x.is_negative()) angle = pi(n) - angle;
  return y.is_negative() ? -angle : angle;
}

BigFloat expm1(const BigFloat& x) {
  const int n = x.words();
  if (std::abs(x.nearest<double>()) > 0.5) return exp(x) - BigFloat(1, n);
  return x.is_zero() ? x : factorial_series(x, x, 2, false);
}

BigFloat exp(const BigFloat& x) {
  const int n = x.words();
  const double twos = std::nearbyint(x.nearest<double>() / std::numbers::ln2);
  const BigFloat rest = x - BigFloat(twos, n) * ln2(n);
  return factorial_series(BigFloat(1, n), rest, 1, false).times_power_of_two(static_cast<std::int64_t>(twos));
}

BigFloat log1p(const BigFloat& x) {
  const BigFloat one(1, x.words());
  if (std::abs(x.nearest<double>()) > 0.5) return log(one + x);
  return log_of_ratio(x / (one + one + x));
}

BigFloat log(const BigFloat& x) {
  const int n = x.words();
  int twos = 0;
  const double mantissa = std::frexp(x.nearest<double>(), &twos);
  if (mantissa < std::numbers::sqrt2 / 2) --twos;
  const BigFloat one(1, n), rest = x.times_power_of_two(-twos);
  return BigFloat(twos, n) * ln2(n) + log_of_ratio((rest - one) / (rest + one));
}

}  // namespace big
}  // namespace raywalk
