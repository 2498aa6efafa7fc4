// Of the C library's functions, those that `math` has too (math/elementary.h): one set of tables, which no packer makes
// smaller, is enough to fetch.

#include "math/elementary.h"

#include <cmath>
#include <numbers>

extern "C" {

double pow(double x, double y) { return raywalk::portable::pow(x, y); }
double exp(double x) { return raywalk::portable::exp(x); }
double sin(double angle) { return raywalk::portable::sin(angle); }
double cos(double angle) { return raywalk::portable::cos(angle); }
double tan(double angle) {
  const auto [sine, cosine] = raywalk::portable::sin_cos(angle);
  return sine / cosine;
}
double atan2(double y, double x) { return raywalk::portable::atan2(y, x); }
double atan(double x) { return raywalk::portable::atan2(x, 1.0); }
float sinf(float angle) { return raywalk::portable::sin(angle); }
float cosf(float angle) { return raywalk::portable::cos(angle); }
float atan2f(float y, float x) { return raywalk::portable::atan2(y, x); }
float powf(float x, float y) { return raywalk::portable::pow(x, y); }
double exp2(double x) { return raywalk::portable::pow(2.0, x); }

double log(double x) {
  int power = 0;
  double part = std::frexp(x, &power);  // a half to 1
  if (part < std::numbers::sqrt2 / 2) {
    part *= 2;
    --power;
  }
  return power * std::numbers::ln2 + raywalk::portable::log1p(part - 1);
}
float logf(float x) { return static_cast<float>(log(static_cast<double>(x))); }
}
