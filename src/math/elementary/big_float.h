#pragma once
// Floating point of any precision: the last resort of the elementary functions, for the few arguments whose value lies
// so close to the middle between two floats that quicker arithmetic cannot tell to which side. Short rather than fast:
// some 20 microseconds a function.

#include <cstdint>
#include <vector>

namespace raywalk {

/// A sign, a number of words of 32 bits, and an exponent to the base of 2^32. Results have the precision of the
/// operands, which must agree, and are cut off: the relative error of one operation on n words is below 2^(-32 (n -
/// 1)).
class BigFloat {
 public:
  /// mantissa * 2^exponent, exactly, in at least 4 words.
  BigFloat(std::uint64_t mantissa, std::int64_t exponent, int words);
  /// Finite.
  BigFloat(double value, int words);

  [[nodiscard]] int words() const { return static_cast<int>(words_.size()); }
  [[nodiscard]] bool is_zero() const { return words_.front() == 0; }
  [[nodiscard]] bool is_negative() const { return negative_; }
  /// The same number in more words, or cut to fewer.
  [[nodiscard]] BigFloat in_words(int words) const;
  [[nodiscard]] BigFloat times_power_of_two(std::int64_t power) const;
  /// Rounded towards 0.
  [[nodiscard]] BigFloat whole() const;
  /// The last two binary digits of the absolute value of a whole number.
  [[nodiscard]] unsigned modulo_4() const;
  /// The float or double nearest to it; ties to even. Infinite beyond the largest.
  template <class T>
  [[nodiscard]] T nearest() const;
  /// Whether adding `term` to it changes nothing.
  [[nodiscard]] bool outweighs(const BigFloat& term) const;

  friend BigFloat operator-(BigFloat a);
  friend BigFloat operator+(const BigFloat& a, const BigFloat& b);
  friend BigFloat operator*(const BigFloat& a, const BigFloat& b);
  friend BigFloat sqrt(const BigFloat& a);
  friend BigFloat operator/(const BigFloat& a, const BigFloat& b);
  friend BigFloat operator/(const BigFloat& a, std::uint32_t b);

 private:
  BigFloat(bool negative, std::int64_t exponent, std::vector<std::uint32_t> digits, int words);
  /// The absolute value as a double in 2^-32..1, without the exponent.
  [[nodiscard]] double leading() const;

  bool negative_ = false;
  std::int64_t exponent_ = 0;         ///< value = 0.words * 2^(32 exponent)
  std::vector<std::uint32_t> words_;  ///< most significant first; the first is 0 only in zero
};

BigFloat operator-(BigFloat a);
BigFloat operator+(const BigFloat& a, const BigFloat& b);
inline BigFloat operator-(const BigFloat& a, const BigFloat& b) { return a + -b; }
BigFloat operator*(const BigFloat& a, const BigFloat& b);
/// a >= 0.
BigFloat sqrt(const BigFloat& a);
/// b is not 0.
BigFloat operator/(const BigFloat& a, const BigFloat& b);
BigFloat operator/(const BigFloat& a, std::uint32_t b);

/// The functions on n words, each with a relative error below 2^(-32 (n - 2)).
namespace big {

[[nodiscard]] BigFloat pi(int words);
/// Of any angle, up to the largest double.
[[nodiscard]] BigFloat sin(const BigFloat& angle);
[[nodiscard]] BigFloat cos(const BigFloat& angle);
/// The angle of the point (x, y), not both 0, as atan2 has it.
[[nodiscard]] BigFloat atan2(const BigFloat& y, const BigFloat& x);
/// |x| < 1100.
[[nodiscard]] BigFloat exp(const BigFloat& x);
[[nodiscard]] BigFloat expm1(const BigFloat& x);
/// x > -1.
[[nodiscard]] BigFloat log1p(const BigFloat& x);
/// x > 0.
[[nodiscard]] BigFloat log(const BigFloat& x);

}  // namespace big

/// The T nearest to a value that `evaluate` computes on a given number of words with a relative error below
/// 2^(-32 (words - 2)). It ends unless the value is the middle between two neighbours of T, or 0.
template <class T, class Evaluate>
[[nodiscard]] T correctly_rounded(const Evaluate& evaluate) {
  for (int words = 6;; words *= 2) {
    const BigFloat value = evaluate(words);
    const BigFloat error = value.times_power_of_two(-32 * (words - 2));
    const T low = (value - error).template nearest<T>(), high = (value + error).template nearest<T>();
    if (low == high) return low;
  }
}

}  // namespace raywalk
