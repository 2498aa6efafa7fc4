// Of the C library's functions, those that `math` has too (math/elementary.h): one set of tables, which no packer makes
// smaller, is enough to fetch.

#include "math/elementary.h"

#include <cmath>
#include <numbers>

extern "C" {

double pow(double x, double y) { return raywalk::portable::pow(x, y); }
double exp(double x) { return raywalk::portable::exp(x); }
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
}
