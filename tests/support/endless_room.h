#pragma once

namespace raywalk::test {

// Two glass balls in a mirror: two rays of every hit, to a depth that nobody lives to see.
inline constexpr const char* endless_room = R"(background = [0.2, 0.2, 0.2]
[camera]
eye = [-6, 0.3, 0]
look_at = [0, 0, 0]
fov = 45
[image]
width = 41
height = 31
[limits]
depth = 60
threshold = 0
[[light]]
name = "Lamp"
type = "point"
position = [-5, 3, 2]
[[object]]
name = "Left"
type = "sphere"
centre = [0, -1.1, 0]
radius = 1
material = { diffuse = 0.1, reflection = 0.4, transmission = 0.5 }
[[object]]
name = "Right"
type = "sphere"
centre = [0, 1.1, 0]
radius = 1
material = { diffuse = 0.1, reflection = 0.4, transmission = 0.5 }
[[object]]
name = "Room"
type = "sphere"
centre = [0, 0, 0]
radius = 50
material = { diffuse = 0.1, reflection = 0.9 }
)";

}  // namespace raywalk::test
