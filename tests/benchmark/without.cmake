# For hooks.sh and effects.sh: benchmark_hooks once more, over copies of a few files of src from which some code is taken
# out. So the program itself need not know that it is measured.

# In the program NAME, NEW stands for OLD, which must be in src/FILE.
function(benchmark_replace name file old new)
  set(from "${CMAKE_SOURCE_DIR}/src/${file}")
  set(to "${CMAKE_CURRENT_BINARY_DIR}/benchmark/${name}/${file}")
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${from}")
  file(READ "${from}" text)
  string(REPLACE "${old}" "${new}" changed "${text}")
  if(changed STREQUAL text)
    message(FATAL_ERROR "tests/benchmark/without.cmake: src/${file} does not have: ${old}")
  endif()
  set(before "")
  if(EXISTS "${to}")
    file(READ "${to}" before)
  endif()
  if(NOT before STREQUAL changed)
    file(WRITE "${to}" "${changed}")
  endif()
endfunction()

# What the change reaches is compiled again; the linker leaves the library's own out.
function(benchmark_without name)
  set(changed "${CMAKE_CURRENT_BINARY_DIR}/benchmark/${name}")
  set(sources "")
  if(EXISTS "${changed}/accel")
    list(APPEND sources "${CMAKE_SOURCE_DIR}/src/accel/accelerator.cpp")
  endif()
  if(EXISTS "${changed}/trace/ray_generator.cpp")
    list(APPEND sources "${changed}/trace/ray_generator.cpp")
  endif()
  add_executable(benchmark_${name} EXCLUDE_FROM_ALL benchmark/hooks.cpp ${sources})
  target_include_directories(benchmark_${name} BEFORE PRIVATE "${changed}")
  target_link_libraries(benchmark_${name} PRIVATE raywalk_app)
endfunction()

benchmark_replace(hooks_removed trace/tracer.h
  "if constexpr (Observer::watches) observer_.record(Event{line, depth, make()})"
  "static_cast<void>(line), static_cast<void>(depth), static_cast<void>(make)")

foreach(effect shadows reflection refraction penumbra textures sky filtering microfacets maps)
  set(also "")
  if(effect STREQUAL "refraction")
    set(also " = set.nesting")
  endif()
  benchmark_replace(without_${effect} trace/policy.h "effects = Set"
    "effects = [](HitEffects set) { set.${effect}${also} = false; return set; }(Set)")
endforeach()
foreach(effect gloss translucency)
  benchmark_replace(without_${effect} trace/tracer_draws.h "if (one_minus_cos > 0)"
    "if (effect != Effect::${effect} && one_minus_cos > 0)")
endforeach()
benchmark_replace(without_depth_of_field trace/ray_generator.cpp "if (lens_radius_ > 0)" "if (false)")
benchmark_replace(without_antialiasing trace/ray_generator.cpp "if (sampling_.per_pixel > 1)" "if (false)")
benchmark_replace(without_motion_blur trace/ray_generator.cpp "if (moves_)" "if (false)")
benchmark_replace(without_motion_blur accel/primitives.h "return may ?" "return may && false ?")

set(removed hooks_removed)
foreach(effect shadows reflection refraction gloss translucency penumbra depth_of_field motion_blur antialiasing textures sky filtering microfacets maps)
  list(APPEND removed without_${effect})
endforeach()
foreach(name IN LISTS removed)
  benchmark_without(${name})
endforeach()
set_target_properties(benchmark_hooks_removed PROPERTIES EXCLUDE_FROM_ALL FALSE)
add_dependencies(tests benchmark_hooks_removed)
