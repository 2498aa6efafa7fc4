// Faces through a window: what is seen, what a mirror shows, and where shadows lie, against every face asked by itself.

#include "trace/beam_faces.h"

#include "trace/window_places.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "support/catch.h"
#include "support/effort.h"

namespace raywalk::beam_faces_test {

using namespace raywalk::test;

namespace {

BeamFace face_of(const std::vector<Vec3d>& corners, int primitive) {
  BeamFace face{corners, {}};
  face.plane.normal = normalize(cross(corners[1] - corners[0], corners[2] - corners[0]));
  face.plane.offset = dot(face.plane.normal, corners[0]);
  face.primitive = primitive;
  return face;
}

/// Triangles that cross each other, a plane without end, and a square.
std::vector<BeamFace> crossing_faces(Draw& draw) {
  std::vector<BeamFace> faces;
  for (int i = 0; i < 25; ++i) {
    const Vec3d middle = draw.place(1.5);
    faces.push_back(face_of({middle + draw.place(0.9), middle + draw.place(0.9), middle + draw.place(0.9)}, i));
  }
  BeamFace floor;
  floor.plane = {normalize(Vec3d(0.1, 0, 1)), -1.3};
  floor.primitive = 25;
  faces.push_back(floor);
  faces.push_back(face_of({{-2, 2, -2}, {2, 2, -2}, {2, 2.4, 2}, {-2, 2.4, 2}}, 26));
  return faces;
}

/// t of a ray on a face; nothing where it misses it, or nearly so.
std::optional<double> met(const BeamFace& face, const Vec3d& from, const Vec3d& direction, bool* doubtful) {
  const double rate = dot(face.plane.normal, direction), t = -face.plane.above(from) / rate;
  if (!(t > 0)) return std::nullopt;
  const Vec3d at = from + t * direction;
  double least = 1;
  detail::for_each_side(face, [&](const Vec3d& corner, const Vec3d& next) {
    const Vec3d along = next - corner;
    least = std::min(least, dot(cross(face.plane.normal, along), at - corner) / length(along));
  });
  if (std::abs(least) < 1e-7) *doubtful = true;
  return least > 0 ? std::optional(t) : std::nullopt;
}

struct Nearest {
  int face = -1;
  double t = infinity<double>;
  bool doubtful = false;
};
Nearest nearest_of(const std::vector<BeamFace>& faces, const Vec3d& from, const Vec3d& direction,
                   const BeamPlane* beyond = nullptr) {
  Nearest nearest;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const auto t = met(faces[i], from, direction, &nearest.doubtful);
    if (!t) continue;
    if (beyond != nullptr) {
      const double above = beyond->above(from + *t * direction);
      nearest.doubtful = nearest.doubtful || std::abs(above) < 1e-7;
      if (above < 0) continue;
    }
    if (std::abs(*t - nearest.t) < 1e-7) nearest.doubtful = true;
    if (*t < nearest.t) nearest.t = *t, nearest.face = static_cast<int>(i);
  }
  return nearest;
}

template <class Piece>
const Piece* piece_at(const std::vector<Piece>& pieces, const Vec2d& place) {
  for (const Piece& piece : pieces)
    if (inside_by(piece.window, place) > 1e-7) return &piece;
  return nullptr;
}

template <class Piece>
double area_of_all(const std::vector<Piece>& pieces) {
  double sum = 0;
  for (const Piece& piece : pieces) sum += area_of(piece.window);
  return sum;
}

BeamView view_from(const Vec3d& eye, double wide) {
  const Vec3d ahead = normalize(-eye), right = normalize(cross(ahead, Vec3d(0.1, 0.2, 1))), down = cross(ahead, right);
  return {eye, ahead - wide * right - wide * down, 2 * wide * right, 2 * wide * down};
}
const WindowPiece whole{{0, 0}, {1, 0}, {1, 1}, {0, 1}};

constexpr auto all_stop = [](int /*primitive*/) { return ShadowRole::stops; };

}  // namespace

TEST_CASE("both halves of a window are what was cut, and lie on their sides") {
  Draw draw(1);
  for (int round = 0; round < 2000; ++round) {
    WindowPiece piece = whole;
    for (int cut = 0; cut < 5; ++cut) {
      const double angle = draw(0, 6.3);
      WindowLine line{std::cos(angle), std::sin(angle), 0, 1e-10};
      line.c = -line.at({draw(0.2, 0.8), draw(0.2, 0.8)});
      const WindowHalves halves = halves_of(piece, line);
      CHECK(area_of(halves.inside) + area_of(halves.outside) == Approx(area_of(piece)).epsilon(1e-13));
      for (const Vec2d& corner : halves.inside) CHECK(line.at(corner) > -2e-10);
      for (const Vec2d& corner : halves.outside) CHECK(line.at(corner) < 2e-10);
      piece = halves.inside.empty() ? halves.outside : halves.inside;
      CHECK(inside_by(piece, middle_of(piece)) > 0);
    }
  }
  // Along an edge, nothing is cut off.
  CHECK(halves_of(whole, {1, 0, 0, 1e-10}).outside.empty());
  CHECK(halves_of(whole, {-1, 0, 0, 1e-10}).inside.empty());
  CHECK(halves_of(whole, {1, 0, -1e-12, 1e-10}).inside == whole);
  CHECK(area_of(whole) == 1);
  CHECK(middle_of(whole) == Vec2d(0.5, 0.5));
}

TEST_CASE("each part of a window sees the nearest face there") {
  int compared = 0;
  for (int seed = 0; seed < rounds(40); ++seed) {
    Draw draw(seed);
    const std::vector<BeamFace> list = crossing_faces(draw);
    const BeamFaces faces(list);
    const BeamView view = view_from(normalize(draw.place(1)) * 5.0, draw(0.01, 0.6));
    const std::vector<SeenFace> seen = faces_seen(faces, view, whole);
    CHECK(area_of_all(seen) == Approx(1).epsilon(1e-12));
    for (int i = 0; i < 300; ++i) {
      const Vec2d place{draw(0, 1), draw(0, 1)};
      const SeenFace* part = piece_at(seen, place);
      const Nearest nearest = nearest_of(list, view.eye, view.direction(place));
      if (part == nullptr || nearest.doubtful) continue;
      ++compared;
      CHECK(part->face == nearest.face);
      if (nearest.face >= 0) CHECK(1 / part->nearness.at(place) == Approx(nearest.t).epsilon(1e-9));
    }
  }
  CHECK(compared > rounds(40) * 200);
}

TEST_CASE("before a wall that leads away, what stands near its far end is seen, and what is behind it is not") {
  int standing = 0;
  for (int seed = 0; seed < rounds(20); ++seed) {
    Draw draw(seed);
    const BeamView view{{0, 0, 0}, {1, -0.2, -0.2}, {0, 0.4, 0}, {0, 0, 0.4}};
    // Across the window its distance grows from 2 to 10.
    std::vector<BeamFace> list{face_of({{2, -0.6, -9}, {2, -0.6, 9}, {12, 2.6, 9}, {12, 2.6, -9}}, 0)};
    for (int i = 1; i < 200; ++i) {
      const Vec3d place = draw(5, 11) * Vec3d(1, draw(0.1, 0.2), draw(-0.2, 0.2));
      list.push_back(face_of({place, place + draw.place(0.25), place + draw.place(0.25)}, i));
    }
    const std::vector<SeenFace> seen = faces_seen(BeamFaces(list), view, whole);
    for (int i = 0; i < 400; ++i) {
      const Vec2d place{draw(0.75, 1), draw(0, 1)};
      const SeenFace* part = piece_at(seen, place);
      const Nearest nearest = nearest_of(list, view.eye, view.direction(place));
      if (part == nullptr || nearest.doubtful) continue;
      CHECK(part->face == nearest.face);
      standing += nearest.face > 0 && nearest.t > 7 ? 1 : 0;
    }
  }
  CHECK(standing > 20 * rounds(20));
}

TEST_CASE("a mirror shows what lies beyond it, seen from the image of the eye") {
  int compared = 0;
  for (int seed = 0; seed < rounds(40); ++seed) {
    Draw draw(1000 + seed);
    const std::vector<BeamFace> list = crossing_faces(draw);
    const BeamFaces faces(list);
    const BeamPlane mirror{normalize(draw.place(1)), draw(-0.5, 0.5)};
    const BeamView direct = view_from(normalize(draw.place(1)) * 5.0, draw(0.01, 0.4));
    const BeamView view = direct.mirrored(mirror);
    CHECK(mirror.above(view.eye) == Approx(-mirror.above(direct.eye)));
    // On the side of the eye itself.
    const double side = mirror.above(direct.eye) > 0 ? 1 : -1;
    const BeamPlane beyond{side * mirror.normal, side * mirror.offset};
    const std::vector<SeenFace> seen = faces_seen(faces, view, whole, &beyond);
    CHECK(area_of_all(seen) == Approx(1).epsilon(1e-12));
    for (int i = 0; i < 200; ++i) {
      const Vec2d place{draw(0, 1), draw(0, 1)};
      // Both eyes see a place of the mirror through the same place of the window.
      const Vec3d ray = direct.direction(place);
      const Vec3d mirrored = direct.eye - mirror.above(direct.eye) / dot(mirror.normal, ray) * ray;
      const double t = -mirror.above(view.eye) / dot(mirror.normal, view.direction(place));
      CHECK(length(view.eye + t * view.direction(place) - mirrored) < 1e-9 * (1 + length(mirrored)));
      const SeenFace* part = piece_at(seen, place);
      const Nearest nearest = nearest_of(list, view.eye, view.direction(place), &beyond);
      if (part == nullptr || nearest.doubtful) continue;
      ++compared;
      CHECK(part->face == nearest.face);
    }
  }
  CHECK(compared > rounds(40) * 100);
}

TEST_CASE("a face is dark where another one stands before the light, a point or the sun") {
  int compared = 0, dark = 0;
  for (int seed = 0; seed < rounds(40); ++seed) {
    Draw draw(2000 + seed);
    const std::vector<BeamFace> list = crossing_faces(draw);
    const BeamFaces faces(list);
    const BeamView view = view_from(normalize(draw.place(1)) * 5.0, draw(0.1, 0.5));
    const bool distant = seed % 2 == 0;
    const BeamLight light{distant ? normalize(draw.place(1)) : draw.place(3), distant};
    for (const SeenFace& part : faces_seen(faces, view, whole)) {
      if (part.face < 0) continue;
      const std::vector<LitPiece> pieces = shadows_on(faces, view, part, light, all_stop);
      CHECK(area_of_all(pieces) == Approx(area_of(part.window)).epsilon(0).margin(1e-13));
      for (int i = 0; i < 40; ++i) {
        const Vec2d place{draw(0, 1), draw(0, 1)};
        if (inside_by(part.window, place) < 1e-6) continue;
        const LitPiece* piece = piece_at(pieces, place);
        if (piece == nullptr) continue;
        const Vec3d at = view.eye + view.direction(place) / part.nearness.at(place);
        const Vec3d towards = distant ? light.place : light.place - at;
        bool doubtful = false, hidden = false;
        for (std::size_t other = 0; other < list.size(); ++other) {
          if (static_cast<int>(other) == part.face) continue;
          const auto t = met(list[other], at, towards, &doubtful);
          if (t && *t < 1e-6) doubtful = true;
          hidden = hidden || (t && (distant || *t < 1));
        }
        if (doubtful) continue;
        ++compared;
        dark += hidden;
        CHECK(piece->stopped == hidden);
      }
    }
  }
  CHECK(compared > rounds(40) * 30);
  CHECK(dark > compared / 20);
}

TEST_CASE(
    "what filters light only weakens it, what is ignored does neither, and a round body shades itself inside alone") {
  const auto square = [](double z, double size, int primitive) {
    return face_of({{-size, -size, z}, {size, -size, z}, {size, size, z}, {-size, size, z}}, primitive);
  };
  std::vector<BeamFace> list{square(0, 3, 0), square(1, 0.5, 1)};
  BeamView view = view_from({0.3, 0.2, 5}, 0.5);
  BeamLight light{normalize(Vec3d(1, 0.3, 1)), true};
  const auto shadow = [&](ShadowRole does) {
    const BeamFaces faces(list);
    double stopped = 0, weakened = 0;
    for (const SeenFace& part : faces_seen(faces, view, whole))
      if (part.face == 0)
        for (const LitPiece& piece : shadows_on(faces, view, part, light, [=](int) { return does; })) {
          if (piece.stopped) stopped += area_of(piece.window);
          if (piece.weakened) weakened += area_of(piece.window);
        }
    return std::pair(stopped, weakened);
  };
  CHECK(shadow(ShadowRole::stops).first > 0.001);
  CHECK(shadow(ShadowRole::stops).second == 0);
  CHECK(shadow(ShadowRole::filters).first == 0);
  CHECK(shadow(ShadowRole::filters).second == Approx(shadow(ShadowRole::stops).first));
  CHECK(shadow(ShadowRole::ignored) == std::pair(0.0, 0.0));
  list[0].is_flat = list[1].is_flat = false;
  list[1].primitive = 0;
  CHECK(shadow(ShadowRole::stops) == std::pair(0.0, 0.0));
  // Seen from behind, which is from inside.
  list[1] = square(-1, 0.5, 0);
  list[1].is_flat = false;
  view.eye.z = -view.eye.z, view.corner.z = -view.corner.z;
  light.place.z = -light.place.z;
  CHECK(shadow(ShadowRole::stops).first > 0.001);
}

TEST_CASE("of a rectangle of light is open what nothing stands before") {
  int compared = 0;
  for (int seed = 0; seed < rounds(40); ++seed) {
    Draw draw(3000 + seed);
    const std::vector<BeamFace> list = crossing_faces(draw);
    const BeamFaces faces(list);
    const BeamFace from = face_of({{-9, -9, -1}, {9, -9, -1}, {0, 9, -1}}, 99);
    const Vec3d eye{draw(-1, 1), draw(-1, 1), -1};
    const Vec3d corner = draw.place(2) + Vec3d(0, 0, 3), u = draw.place(1), v = draw.place(1);
    const BeamView view{eye, corner - eye, u, v};
    const std::vector<LitPiece> pieces = open_light(faces, view, whole, from, false, all_stop);
    CHECK(area_of_all(pieces) == Approx(1).epsilon(1e-12));
    for (int i = 0; i < 200; ++i) {
      const Vec2d place{draw(0, 1), draw(0, 1)};
      const LitPiece* piece = piece_at(pieces, place);
      bool doubtful = false, hidden = false;
      for (const BeamFace& face : list) {
        const auto t = met(face, eye, view.direction(place), &doubtful);
        if (t && std::abs(*t - 1) < 1e-7) doubtful = true;
        hidden = hidden || (t && *t < 1);
      }
      if (piece == nullptr || doubtful) continue;
      ++compared;
      CHECK(piece->stopped == hidden);
    }
  }
  CHECK(compared > rounds(40) * 100);
}

TEST_CASE("of faces in one place that of the lower primitive is seen, whichever comes first") {
  const BeamView view = view_from({0.3, 0.2, 5}, 0.1);
  const std::vector<Vec3d> square{{-3, -3, 0.1}, {3, -3, 0.1}, {3, 3, 0.1}, {-3, 3, 0.1}};
  for (const bool turned : {false, true}) {
    std::vector<BeamFace> list{face_of(square, 7), face_of({square[2], square[3], square[0], square[1]}, 4)};
    if (turned) std::swap(list[0], list[1]);
    const std::vector<SeenFace> seen = faces_seen(BeamFaces(list), view, whole);
    REQUIRE(seen.size() == 1);
    CHECK(list[static_cast<std::size_t>(seen[0].face)].primitive == 4);
  }
}

TEST_CASE("beams stop between faces when they are asked to") {
  Stopper stopper;
  stopper.raised = true;
  const Stop stop(stopper);
  const BeamFaces faces(
      {face_of({{-1, 3, -1}, {1, 3, -1}, {0, 3, 1}}, 0), face_of({{-1, 5, -1}, {1, 5, -1}, {0, 5, 1}}, 1)});
  const BeamView view{Vec3d(0.0), {-1, 2, 1}, {2, 0, 0}, {0, 0, -2}};
  CHECK(faces_seen(faces, view, whole).size() > 1);
  CHECK_THROWS_AS(faces_seen(faces, view, whole, nullptr, stop), Stopped);
  const auto stops = [](int) { return ShadowRole::stops; };
  const SeenFace on{whole, 1, view.nearness(faces[1].plane)};
  CHECK_THROWS_AS(shadows_on(faces, view, on, {{0, 1, 0}}, stops, stop), Stopped);
  BeamFace from;
  CHECK_THROWS_AS(open_light(faces, view, whole, from, false, stops, stop), Stopped);
}

}  // namespace raywalk::beam_faces_test
