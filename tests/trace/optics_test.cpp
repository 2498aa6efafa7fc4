#include "trace/optics.h"

#include <limits>
#include <map>
#include <numbers>

#include "shape/numbers.h"
#include "shape/quad.h"
#include "support/catch.h"
#include "support/table.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

using std::numbers::pi;

// A unit ray at `angle` (radians from the normal) onto a surface whose normal is +z.
template <class T = double>
Refraction<T> at_angle(double angle, double n1, double n2) {
  const Vec3<T> incident(static_cast<T>(std::sin(angle)), 0, static_cast<T>(-std::cos(angle)));
  return refraction_at(incident, Vec3<T>(0, 0, 1), static_cast<T>(n1), static_cast<T>(n2));
}

}  // namespace

TEST_CASE("optics is what optics.tsv says") {
  std::map<std::string, int> rows;
  for (const Row& row : read_table("optics.tsv")) {
    const std::string& quantity = row.text("quantity");
    ++rows[quantity];
    INFO(row.text("id") << " " << quantity);
    const double tolerance = row.number("tol");
    const auto expect = [&](double got) { CHECK(got == Approx(row.number("expected")).margin(tolerance).epsilon(0)); };
    if (quantity == "reflect_dir") {
      CHECK(length(reflect(row.vector("incident"), row.vector("normal")) - row.vector("expected")) <= tolerance);
      continue;
    }
    const double n1 = row.number("n1"), n2 = row.number("n2");
    if (quantity == "refract_dir") {
      const Vec3d incident = normalize(row.vector("incident")), normal = row.vector("normal");
      const Refraction<double> at = refraction_at(incident, normal, n1, n2);
      const auto direction = refract(incident, normal, at);
      REQUIRE(direction.has_value() == (row.text("expected") != "TIR"));
      if (direction) CHECK(length(*direction - row.vector("expected")) <= tolerance);
      continue;
    }
    if (quantity == "critical_deg") {
      const double critical = row.number("expected") * pi / 180;
      CHECK_FALSE(at_angle(critical - 1e-6, n1, n2).total());
      CHECK(at_angle(critical + 1e-6, n1, n2).total());
      continue;
    }
    if (quantity == "schlick_F") continue;  // an approximation that we have no use for
    const Refraction<double> at = at_angle(row.number("angle_deg") * pi / 180, n1, n2);
    if (quantity == "refract_deg") {
      REQUIRE(at.total() == (row.text("expected") == "TIR"));
      if (!at.total()) expect(std::acos(at.cos_out) * 180 / pi);
    } else if (quantity == "fresnel_F") {
      expect(at.fresnel());
    } else {
      // Amplitudes are not handed out; they are recomputed from the cosines, which checks those.
      const bool s = quantity == "fresnel_rs";
      REQUIRE((s || quantity == "fresnel_rp"));
      const double a = s ? n1 * at.cos_in : n2 * at.cos_in, b = s ? n2 * at.cos_out : n1 * at.cos_out;
      expect(at.total() ? 1 : std::abs((a - b) / (a + b)));
    }
  }
  CHECK(rows["reflect_dir"] >= 4);
  CHECK(rows["refract_dir"] >= 6);
  CHECK(rows["refract_deg"] >= 6);
  CHECK(rows["fresnel_F"] >= 6);
  CHECK(rows["critical_deg"] >= 1);
}

TEMPLATE_TEST_CASE("mirrored directions keep their length and their angle", "", float, double) {
  using T = TestType;
  Numbers next(1);
  const T eps = 8 * std::numeric_limits<T>::epsilon();
  for (int i = 0; i < 2000; ++i) {
    const Vec3<T> incident = next.in_box<T>(2), normal = next.unit<T>();
    const Vec3<T> mirrored = reflect(incident, normal);
    if (std::abs(length(mirrored) - length(incident)) > eps * 2) FAIL("length at " << i);
    if (std::abs(dot(mirrored, normal) + dot(incident, normal)) > eps * 2) FAIL("angle at " << i);
    if (length(reflect(mirrored, normal) - incident) > 2 * eps) FAIL("not back at " << i);
  }
  CHECK(reflect(Vec3<T>(1, 2, -3), Vec3<T>(0, 0, 1)) == Vec3<T>(1, 2, 3));
}

TEMPLATE_TEST_CASE("refraction obeys Snell's law in the plane of incidence", "", float, double) {
  using T = TestType;
  Numbers next(2);
  const T eps = 64 * std::numeric_limits<T>::epsilon();
  int refracted = 0, total = 0;
  for (int i = 0; i < 5000; ++i) {
    const Vec3<T> normal = next.unit<T>();
    Vec3<T> incident = next.unit<T>();
    if (dot(incident, normal) > 0) incident = -incident;
    const T n1 = static_cast<T>(next.real(0.5, 3)), n2 = static_cast<T>(next.real(0.5, 3));
    const Refraction<T> at = refraction_at(incident, normal, n1, n2);
    const T sin_in = length(cross(incident, normal));
    const auto out = refract(incident, normal, at);
    if (at.total()) {
      ++total;
      if (out) FAIL("refracted under total internal reflection");
      if (n1 * sin_in < n2 * (1 - eps)) FAIL("total too early");
      if (at.fresnel() != 1 || at.cos_out != 0) FAIL("not all reflected");
      continue;
    }
    ++refracted;
    REQUIRE(out);
    if (std::abs(length(*out) - 1) > eps) FAIL("not a unit at " << i);
    const T sin_out = length(cross(*out, normal));
    if (std::abs(n1 * sin_in - n2 * sin_out) > 4 * eps) FAIL("Snell at " << i);
    if (std::abs(dot(cross(incident, normal), *out)) > eps) FAIL("out of plane at " << i);
    if (dot(*out, normal) > eps) FAIL("not beyond at " << i);
    if (!(at.fresnel() >= 0 && at.fresnel() <= 1)) FAIL("reflectance " << at.fresnel());
  }
  CHECK(refracted > 2500);
  CHECK(total > 500);
}

TEST_CASE("reflected and transmitted power add up, amplitudes by amplitudes") {
  // Fresnel's transmission coefficients, computed independently of the reflection coefficients.
  Numbers next(3);
  for (int i = 0; i < 2000; ++i) {
    const double n1 = next.real(0.8, 2.5), n2 = next.real(0.8, 2.5);
    const Refraction<double> at = at_angle(next.real(0, pi / 2), n1, n2);
    if (at.total()) continue;
    const double ts = 2 * n1 * at.cos_in / (n1 * at.cos_in + n2 * at.cos_out);
    const double tp = 2 * n1 * at.cos_in / (n2 * at.cos_in + n1 * at.cos_out);
    const double passes = n2 * at.cos_out / (n1 * at.cos_in) * (ts * ts + tp * tp) / 2;
    CHECK(at.fresnel() + passes == Approx(1).epsilon(1e-9));
  }
}

TEST_CASE("the way back reflects as much") {
  Numbers next(4);
  for (int i = 0; i < 1000; ++i) {
    const double n1 = next.real(1, 2.5), n2 = next.real(1, 2.5);
    const Refraction<double> there = at_angle(next.real(0, pi / 2), n1, n2);
    if (there.total()) continue;
    const Refraction<double> back = at_angle(std::acos(there.cos_out), n2, n1);
    CHECK(back.fresnel() == Approx(there.fresnel()).epsilon(0).margin(1e-6));
  }
}

TEST_CASE("special angles of glass") {
  CHECK(at_angle(0, 1, 1.5).fresnel() == Approx(0.04));
  CHECK(at_angle(0, 1.5, 1).fresnel() == Approx(0.04));
  // At Brewster's angle nothing parallel is reflected: half of rs^2 remains.
  const double brewster = std::atan(1.5);
  const double rs = (std::cos(brewster) - 1.5 * std::cos(pi / 2 - brewster)) /
                    (std::cos(brewster) + 1.5 * std::cos(pi / 2 - brewster));
  CHECK(at_angle(brewster, 1, 1.5).fresnel() == Approx(rs * rs / 2));
  // Grazing: everything is reflected, and nothing is NaN.
  const Refraction<double> grazing = refraction_at(Vec3d(1, 0, 0), Vec3d(0, 0, 1), 1.0, 1.5);
  CHECK(grazing.fresnel() == 1);
  CHECK(grazing.cos_in == 0);
  CHECK(refract(Vec3d(1, 0, 0), Vec3d(0, 0, 1), grazing).has_value());
}

TEST_CASE("equal indices bend nothing and reflect nothing, grazing or not") {
  const Vec3d incident = normalize(Vec3d(1, 2, -2));
  const Refraction<double> at = refraction_at(incident, Vec3d(0, 0, 1), 1.3, 1.3);
  CHECK(at.fresnel() == 0);
  CHECK(length(*refract(incident, Vec3d(0, 0, 1), at) - incident) < 1e-15);
  const Refraction<double> along = refraction_at(Vec3d(1, 0, 0), Vec3d(0, 0, 1), 1.3, 1.3);
  CHECK(std::isfinite(along.fresnel()));
  CHECK(*refract(Vec3d(1, 0, 0), Vec3d(0, 0, 1), along) == Vec3d(1, 0, 0));
}

TEST_CASE("at exactly the critical angle the ray leaves along the surface") {
  // n1 / n2 = 5 / 4 and a cosine of 3 / 5: k is exactly 0 by integers, and in double too.
  const Refraction<double> at = refraction_at(Vec3d(0.8, 0, -0.6), Vec3d(0, 0, 1), 1.25, 1.0);
  CHECK(at.k == 0);
  CHECK_FALSE(at.total());
  CHECK(at.cos_out == 0);
  CHECK(at.fresnel() == 1);
  const auto out = refract(Vec3d(0.8, 0, -0.6), Vec3d(0, 0, 1), at);
  REQUIRE(out);
  CHECK(out->x == 1);
  CHECK(out->z == 0);
  // One step of the cosine to either side decides.
  CHECK(refraction_at(Vec3d(0.8, 0, -std::nextafter(0.6, 0.0)), Vec3d(0, 0, 1), 1.25, 1.0).k <= 0);
  CHECK_FALSE(refraction_at(Vec3d(0.8, 0, -(0.6 + 1e-15)), Vec3d(0, 0, 1), 1.25, 1.0).total());
  CHECK(refraction_at(Vec3d(0.8, 0, -(0.6 - 1e-15)), Vec3d(0, 0, 1), 1.25, 1.0).total());
}

TEST_CASE("near equal indices and near the critical angle the cosine keeps its digits") {
  Numbers next(5);
  double worst = 0;
  int total = 0;
  for (int i = 0; i < 20000; ++i) {
    const double n1 = next.real(1, 2);
    // Indices that differ in the 4th to the 15th digit, and rays as grazing as makes the cosine beyond about as small.
    const double n2 = n1 * (1 + next.real() * std::pow(10.0, -next.integer(3, 14)));
    const double cosine = next.real(0.1, 2) * std::sqrt(2 * std::abs(n2 / n1 - 1));
    const Refraction<double> at =
        refraction_at(Vec3d(std::sqrt(1 - cosine * cosine), 0, -cosine), Vec3d(0, 0, 1), n1, n2);
    const Quad a = n1, b = n2, c = cosine;
    const Quad two_terms[] = {(b - a) * (b + a) / (b * b), a * a * c * c / (b * b)};
    const Quad expected = two_terms[0] + two_terms[1];
    // Where the two cancel, at the critical angle itself, it is the larger that counts.
    const double size = std::abs(static_cast<double>(two_terms[0])) + static_cast<double>(two_terms[1]);
    worst = std::max(worst, std::abs(static_cast<double>(at.k - expected)) / size);
    total += at.total();
  }
  CHECK(worst / std::numeric_limits<double>::epsilon() <= 4);
  CHECK(total > 1000);
}

TEMPLATE_TEST_CASE("a power by multiplications is the power", "", float, double) {
  using T = TestType;
  Numbers next(5);
  for (int i = 0; i < 20000; ++i) {
    const T base = static_cast<T>(next.real(0, 1));
    const T exponent = i % 2 == 0 ? static_cast<T>(next.integer(0, 600)) : static_cast<T>(next.real(0, 600));
    const double expected = std::pow(static_cast<double>(base), static_cast<double>(exponent));
    // Half an ulp for each of the multiplications that it stands for.
    const double error = (static_cast<double>(exponent) / 2 + 2) * std::numeric_limits<T>::epsilon() * expected;
    const double least = 4 * std::numeric_limits<T>::min();  // below it digits are lost
    if (std::abs(static_cast<double>(power(base, exponent)) - expected) > error + least)
      FAIL(base << "^" << exponent << " = " << power(base, exponent));
  }
  CHECK(power(T(0), T(0)) == 1);
  CHECK(power(T(0.5), T(10)) == T(1) / 1024);
  CHECK(power(T(0), T(3)) == 0);
  CHECK(power(T(1), T(1e30)) == 1);
}

TEMPLATE_TEST_CASE("the power of a cosine is that of the quotient, even or odd, whole or not", "", float, double) {
  using T = TestType;
  Numbers next(6);
  for (const T exponent : {T(0), T(1), T(2), T(3), T(7.5), T(20), T(81), T(200), T(5000), T(100000)})
    for (int i = 0; i < 300; ++i) {
      const T square = static_cast<T>(next.real(0.01, 4));
      const T along = static_cast<T>(next.real(0.9, 1)) * std::sqrt(square);
      const double expected =
          std::pow(static_cast<double>(along) / std::sqrt(static_cast<double>(square)), static_cast<double>(exponent));
      const double error = (2 * static_cast<double>(exponent) + 4) * std::numeric_limits<T>::epsilon() * expected;
      CHECK(std::abs(static_cast<double>(power_of_cosine(along, square, exponent)) - expected) <=
            error + 4 * static_cast<double>(std::numeric_limits<T>::min()));
    }
  CHECK(power_of_cosine(T(-0.5), T(1), T(2)) == 0);  // an even power would forget the sign
  CHECK(power_of_cosine(T(-0.5), T(1), T(0)) == 1);
  CHECK(power_of_cosine(T(0), T(0), T(10)) == 0);
}
