# Dear ImGui as tools.sh built it, with Emscripten's own GLFW and OpenGL.
find_package(Freetype REQUIRED)
find_path(RAYWALK_imgui_INCLUDE NAMES imgui.h PATH_SUFFIXES imgui REQUIRED)
find_library(RAYWALK_imgui_LIBRARY NAMES imgui REQUIRED)
mark_as_advanced(RAYWALK_imgui_INCLUDE RAYWALK_imgui_LIBRARY)
add_library(dep::imgui INTERFACE IMPORTED)
target_include_directories(dep::imgui SYSTEM INTERFACE "${RAYWALK_imgui_INCLUDE}")
target_link_libraries(dep::imgui INTERFACE "${RAYWALK_imgui_LIBRARY}" Freetype::Freetype)
target_link_options(dep::imgui INTERFACE -sUSE_GLFW=3 -sMIN_WEBGL_VERSION=2 -sMAX_WEBGL_VERSION=2)
