#pragma once
// The elementary functions that pictures depend on, the same on every processor, C library, compiler and in
// WebAssembly. Every result is correctly rounded: it is the exact value, rounded once, to nearest and ties to even. So
// there is one right answer, and any implementation that finds it gives the same bits. C libraries' own functions may
// be off in the last bit, and are so in different places, even one library's on different processors. Only +, -, *, /,
// sqrt, fma and rounding are the same everywhere, and only these are used here.
//
// How (A. Ziv, "Fast evaluation of elementary mathematical functions with correctly rounded last bit", TOMS 17(3),
// 1991): a quick evaluation comes with a bound on its error. Where all values within the bound round to the same
// number, that is the result; elsewhere the evaluation is repeated with as many digits as it takes
// (elementary/big_float.h). About one argument in 100,000 is such.
//
// Special values (NaN, infinities, zeros and their signs) are those that IEEE 754 recommends. No flags, no errno; the
// rounding mode is to nearest.

namespace raywalk::portable {

template <class T>
struct SineCosine {
  T sin, cos;
};

/// Of an angle in radians. Up to 2^15 they are quick; beyond, right but slow. NaN for infinities.
[[nodiscard]] float sin(float angle);
[[nodiscard]] double sin(double angle);
[[nodiscard]] float cos(float angle);
[[nodiscard]] double cos(double angle);
/// Both of one angle, for little more than the price of one.
[[nodiscard]] SineCosine<float> sin_cos(float angle);
[[nodiscard]] SineCosine<double> sin_cos(double angle);

/// The angle of the point (x, y), in -pi..pi, from the x axis towards the y axis; the sign is y's, of a zero too.
[[nodiscard]] float atan2(float y, float x);
[[nodiscard]] double atan2(double y, double x);

/// e^x, and e^x - 1 without cancellation near 0.
[[nodiscard]] float exp(float x);
[[nodiscard]] double exp(double x);
[[nodiscard]] float expm1(float x);
[[nodiscard]] double expm1(double x);

/// The natural logarithm of 1 + x, without cancellation near 0. -infinity at -1, NaN below.
[[nodiscard]] float log1p(float x);
[[nodiscard]] double log1p(double x);

/// x^y. 1 for y = 0; NaN for x < 0, unless y is whole.
[[nodiscard]] float pow(float x, float y);
[[nodiscard]] double pow(double x, double y);

}  // namespace raywalk::portable
