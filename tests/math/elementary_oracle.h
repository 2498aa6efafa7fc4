// The elementary functions beside what judges them: MPFR, which rounds correctly, and in most cases a quicker filter.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace raywalk::oracle {

/// Two arguments; functions of one leave the second out.
template <class T>
struct Arguments {
  T x, y;
};

struct Function {
  std::string name;
  float (*in_float)(float x, float y);
  double (*in_double)(double x, double y);
  /// The value in extended precision, right up to 2^-61 of it (3 units in its last place, as glibc has it).
  long double (*extended)(long double x, long double y);
  int mpfr;  // which of MPFR's functions
};

/// Of one scalar's: what `function` says.
inline float value(const Function& function, const Arguments<float>& at) { return function.in_float(at.x, at.y); }
inline double value(const Function& function, const Arguments<double>& at) { return function.in_double(at.x, at.y); }

const std::vector<Function>& functions();

/// Whether this build can judge.
bool has_mpfr();
/// MPFR's answer.
template <class T>
T exact(const Function& function, const Arguments<T>& at);
/// Whether `value` is right: decided in extended precision where that is certain, and by MPFR elsewhere; a wrong one
/// always by MPFR.
template <class T>
bool is_right(const Function& function, const Arguments<T>& at, T value);
/// The same bits, or both NaN.
template <class T>
bool same(T a, T b);

/// The i-th of endlessly many arguments: over all binades, in the range that pictures use, and where it is hard.
template <class T>
Arguments<T> arguments(const Function& function, std::uint64_t i);

}  // namespace raywalk::oracle
