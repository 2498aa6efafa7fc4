# The page: raywalk.js and raywalk.wasm, which holds all data too, unpack.wasm, and what pack.mjs makes of them.
set(page "${CMAKE_SOURCE_DIR}/src/gui/web")

# What a person watches, what is wrong on purpose, exact arithmetic and what is made once of a scene need not be fast either.
# The path tracer, photons, radiosity and single precision are small rather than fast, too, and take about half and two
# thirds as long again: so the site stays near 1.5 MB.
set(smallest
  math/elementary/arc_tangent.cpp math/elementary/big_float.cpp math/elementary/trigonometric.cpp math/exact.cpp
  math/motion.cpp math/sampler.cpp math/sampling.cpp
  shape/exactly.cpp shape/mesh.cpp shape/polygon.cpp
  accel/accelerator_float.cpp accel/accelerator_naive.cpp accel/binary_tree.cpp accel/library.cpp
  accel/mesh_copies.cpp accel/reinsertion.cpp accel/search_record.cpp accel/spatial_split.cpp
  accel/structures.cpp accel/watched.cpp accel/wide_tree.cpp
  trace/beam_faces.cpp trace/beam_kernel.cpp trace/beam_scene.cpp trace/beam_window.cpp trace/bodies.cpp
  trace/checker_filter.cpp trace/clear_sky.cpp trace/cone_bodies.cpp trace/cone_cover.cpp trace/cone_kernel.cpp
  trace/cone_scene.cpp trace/dipole_limits.cpp trace/emitters.cpp trace/form_factor.cpp trace/kernel_faulty.cpp
  trace/kernel_filtering.cpp trace/kernel_float.cpp trace/kernel_naive.cpp trace/kernel_watched.cpp
  trace/microfacets.cpp trace/outlines.cpp trace/patch_cutter.cpp trace/patch_elements.cpp trace/patch_light.cpp
  trace/patches.cpp trace/pencil_kernel.cpp trace/photon_kernel.cpp trace/photon_lights.cpp trace/photon_limits.cpp
  trace/photon_map.cpp trace/plan_marks.cpp trace/radiosity_kernel.cpp trace/radiosity_pass.cpp trace/ray_cone.cpp
  trace/ray_generator.cpp trace/recursion.cpp trace/rough_dielectric.cpp trace/scene_kernel.cpp trace/sky_light.cpp
  trace/space_beam_kernel.cpp trace/surface_maps.cpp trace/texture_pyramid.cpp trace/unfolded_plan.cpp trace/world.cpp)
list(TRANSFORM smallest PREPEND "${CMAKE_SOURCE_DIR}/src/")
set_source_files_properties(${smallest} PROPERTIES COMPILE_OPTIONS -Oz SKIP_PRECOMPILE_HEADERS ON)
target_compile_definitions(raywalk_trace PUBLIC RAYWALK_FEW_KERNELS)

# Fonts, scenes, lessons and texts, as the installed program has them. Of the fonts only what is drawn: the ranges of
# `glyphs` in gui/fonts.cpp. The hints of TrueType fonts are left out, for nothing follows them.
# Outlines are written out, for what packs the page shares their parts better than a font does.
set(data "${CMAKE_BINARY_DIR}/data")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${CMAKE_SOURCE_DIR}/src/gui/fonts.cpp")
file(READ "${CMAKE_SOURCE_DIR}/src/gui/fonts.cpp" glyphs)
string(REGEX MATCH "glyphs{[^}]*}" glyphs "${glyphs}")
string(REGEX MATCHALL "0x[0-9A-F]+,[ \n]*0x[0-9A-F]+" glyphs "${glyphs}")
string(REGEX REPLACE ",[ \n]*" "-" glyphs "${glyphs}")
string(REGEX REPLACE "0x" "" glyphs "${glyphs}")
string(REPLACE ";" "," glyphs "${glyphs}")
find_package(Python3 REQUIRED COMPONENTS Interpreter)
set(subset "${CMAKE_COMMAND}" -E env "PYTHONPATH=${CMAKE_SOURCE_DIR}/build/emscripten/root/usr/lib/python3/dist-packages"
    "${Python3_EXECUTABLE}" -m fontTools.subset
    --unicodes=${glyphs} --layout-features= --name-IDs=0,1,2,13,14 --desubroutinize
    --drop-tables+=GDEF,GPOS,GSUB,gasp)
set(fonts)
set(subset_fonts)
foreach(font IN ITEMS opentype/inter/Inter-Regular.otf opentype/inter/Inter-SemiBold.otf
        truetype/jetbrains-mono/JetBrainsMono-Regular.ttf truetype/jetbrains-mono/JetBrainsMono-Bold.ttf)
  if(NOT EXISTS "/usr/share/fonts/${font}")
    message(FATAL_ERROR "The page holds its fonts, and /usr/share/fonts/${font} is not here. On Debian and Ubuntu:\n"
                        "    sudo apt-get install fonts-inter fonts-jetbrains-mono")
  endif()
  list(APPEND fonts "/usr/share/fonts/${font}")
  get_filename_component(name "${font}" NAME)
  list(APPEND subset_fonts COMMAND ${subset} "/usr/share/fonts/${font}" "--output-file=${data}/fonts/${name}")
  if(font MATCHES "[.]ttf$")
    list(APPEND subset_fonts --no-hinting)
  endif()
endforeach()
# What the licences of all this ask to be shown, for the help.
set(licences "${CMAKE_BINARY_DIR}/licences.txt")
file(GLOB of_libraries CONFIGURE_DEPENDS "${CMAKE_SOURCE_DIR}/build/web-libraries/prefix/share/licences/*")
file(WRITE "${licences}.new" "")
foreach(licence IN ITEMS "Raywalk=${CMAKE_SOURCE_DIR}/LICENSE" ${of_libraries}
        "Inter=/usr/share/doc/fonts-inter/copyright" "JetBrains Mono=/usr/share/doc/fonts-jetbrains-mono/copyright")
  if(licence MATCHES "^(.*)=(.*)$")
    set(name "${CMAKE_MATCH_1}")
    set(licence "${CMAKE_MATCH_2}")
  else()
    get_filename_component(name "${licence}" NAME)
  endif()
  file(READ "${licence}" text)
  if(text MATCHES "^Format: ")  # without what is said of Debian's own files, of tests and of tools
    string(REGEX REPLACE "Files-Excluded:[^\n]*\n( [^\n]*\n)*" "" text "${text}")
    string(REGEX REPLACE "Files: *(debian|tests|tools|amiga|contrib)[^\n]*\n([^\n]+\n)*\n?" "" text "${text}")
    string(REGEX REPLACE "License: (GPL-2[+]|U-OF-I-BSD-LIKE|BSD-3-clause)\n([^\n]+\n)*\n?" "" text "${text}")
  endif()
  file(APPEND "${licences}.new" "== ${name} ==\n${text}\n")
endforeach()
configure_file("${licences}.new" "${licences}" COPYONLY)  # newer only if it changed
file(GLOB scenes CONFIGURE_DEPENDS "${CMAKE_SOURCE_DIR}/scenes/*.toml" "${CMAKE_SOURCE_DIR}/scenes/*.ply"
  "${CMAKE_SOURCE_DIR}/scenes/*.hdr" "${CMAKE_SOURCE_DIR}/scenes/*.png")
file(GLOB_RECURSE lessons CONFIGURE_DEPENDS "${CMAKE_SOURCE_DIR}/lessons/*")
file(GLOB texts CONFIGURE_DEPENDS "${CMAKE_SOURCE_DIR}/src/text/*.toml")
list(FILTER texts EXCLUDE REGEX "/en[.]toml$") # it is part of the program
list(FILTER lessons EXCLUDE REGEX "/README[.]md$")
add_custom_command(
  OUTPUT "${data}.done"
  COMMAND "${CMAKE_COMMAND}" -E rm -rf "${data}"
  COMMAND "${CMAKE_COMMAND}" -E make_directory "${data}/fonts" "${data}/scenes" "${data}/text"
  ${subset_fonts}
  COMMAND "${CMAKE_COMMAND}" -E copy ${scenes} "${data}/scenes"
  COMMAND "${CMAKE_COMMAND}" -E copy_directory "${CMAKE_SOURCE_DIR}/lessons" "${data}/lessons"
  COMMAND "${CMAKE_COMMAND}" -E rm -r "${data}/lessons/README.md" "${data}/lessons/words" # for `lesson check` alone
  COMMAND find "${data}/lessons" -name "*.toml" -exec sed -i "/^ *#/d" {} + # what they say to their writers
  # What to try in a shell; the classic scene's comments say how a scene is written.
  COMMAND find "${data}/scenes" -name "*.toml" ! -name classic.toml -exec sed -i "/^ *#/d" {} +
  COMMAND "${CMAKE_COMMAND}" -E copy ${texts} "${data}/text"
  COMMAND "${CMAKE_COMMAND}" -E copy "${licences}" "${data}"
  COMMAND "${CMAKE_COMMAND}" -E touch "${data}.done"
  DEPENDS ${fonts} ${scenes} ${lessons} ${texts} "${licences}"
  VERBATIM)
add_custom_target(raywalk_data DEPENDS "${data}.done")

# Of a function of which several files hold a copy the linker takes the first: these come before what is small. In an order
# of chance, the tracer ran the small copies, and took a third as long again. More is inlined into them: a call costs more
# here than in a native program.
set(fastest trace/kernel_double.cpp accel/accelerator.cpp)
list(TRANSFORM fastest PREPEND src/)
set_source_files_properties(${fastest} PROPERTIES COMPILE_OPTIONS
  "-O3;-mllvm;-inline-threshold=2500" SKIP_PRECOMPILE_HEADERS ON)
list(JOIN fastest "|" fastest)
add_executable(raywalk "${page}/main.cpp" "${page}/mirror.cpp" "${page}/worker.cpp" "${page}/libm.cpp"
  "$<FILTER:$<TARGET_OBJECTS:raywalk_trace>,INCLUDE,${fastest}>" "$<FILTER:$<TARGET_OBJECTS:raywalk_accel>,INCLUDE,${fastest}>")
target_link_libraries(raywalk PRIVATE raywalk_gui)
target_compile_options(raywalk PRIVATE -Oz)
add_dependencies(raywalk raywalk_data)
set_target_properties(raywalk PROPERTIES LINK_DEPENDS "${data}.done")
target_link_options(raywalk PRIVATE
  "SHELL:--embed-file ${data}@/raywalk"
  # No eval, which a Content-Security-Policy forbids. Under Node, tests call what they want themselves.
  -sMODULARIZE -sEXPORT_NAME=Raywalk -sENVIRONMENT=web,worker,node -sDYNAMIC_EXECUTION=0
  -Os # of what is linked only; each floor was compiled as it wants to be. -Oz would copy memory byte by byte
  -sSTACK_SIZE=8MB -sINITIAL_MEMORY=32MB -sALLOW_MEMORY_GROWTH=1 -sMAXIMUM_MEMORY=2GB
  -sEXPORTED_RUNTIME_METHODS=FS,ccall -sFORCE_FILESYSTEM=1
  # Of its JavaScript, what page.js, worker.js and tests ask of it.
  -sINCOMING_MODULE_JS_API=canvas,arguments,preRun,noInitialRun,instantiateWasm,onAbort
  -sGL_ENABLE_GET_PROC_ADDRESS=0 -sGL_SUPPORT_AUTOMATIC_ENABLE_EXTENSIONS=0 -sGL_SUPPORT_SIMPLE_ENABLE_EXTENSIONS=0
  --profiling-funcs) # order.mjs wants to see the names, and drops them
set(without)
if(NOT CMAKE_CXX_FLAGS MATCHES "-msimd128")
  set(without no-simd)
endif()
find_program(RAYWALK_NODE node REQUIRED)
add_custom_command(TARGET raywalk POST_BUILD COMMAND "${RAYWALK_NODE}" "${page}/order.mjs" "${CMAKE_BINARY_DIR}/raywalk.wasm"
  "${CMAKE_SOURCE_DIR}/build/emscripten/binaryen/bin/wasm-opt" ${without} VERBATIM)
set_property(TARGET raywalk APPEND PROPERTY LINK_DEPENDS "${page}/order.mjs")

# Modules of their own, without imports: unpack.cpp takes the memory that it needs itself. What packs runs here alone.
find_path(RAYWALK_7zip_INCLUDE NAMES LzmaDec.h REQUIRED)
find_library(RAYWALK_7zip_LIBRARY NAMES 7zip REQUIRED)
mark_as_advanced(RAYWALK_7zip_INCLUDE RAYWALK_7zip_LIBRARY)
foreach(tool IN ITEMS unpack text_packer)
  add_executable(${tool} "${page}/${tool}.cpp")
  set_target_properties(${tool} PROPERTIES SUFFIX .wasm)
  target_include_directories(${tool} SYSTEM PRIVATE "${RAYWALK_7zip_INCLUDE}")
  target_link_libraries(${tool} PRIVATE raywalk_flags "${RAYWALK_7zip_LIBRARY}")
  target_compile_options(${tool} PRIVATE -Oz)
  target_link_options(${tool} PRIVATE -Oz -sSTANDALONE_WASM --no-entry -sSTACK_SIZE=16KB)
endforeach()
target_link_options(unpack PRIVATE -sINITIAL_MEMORY=192KB -sALLOW_MEMORY_GROWTH=1 -sMAXIMUM_MEMORY=128MB)
target_link_options(text_packer PRIVATE -sINITIAL_MEMORY=48MB)

file(GLOB page_parts CONFIGURE_DEPENDS "${page}/*.html" "${page}/*.css" "${page}/*.js" "${page}/*.svg" "${page}/*.webmanifest")
add_custom_command(
  OUTPUT "${CMAKE_BINARY_DIR}/site/raywalk.html"
  COMMAND "${RAYWALK_NODE}" "${page}/pack.mjs" "${CMAKE_BINARY_DIR}" "${CMAKE_BINARY_DIR}/site" ${without}
  DEPENDS raywalk unpack text_packer "${page}/pack.mjs" "${page}/prune.mjs" "${page}/streams.mjs" ${page_parts} ${texts}
  VERBATIM)
add_custom_target(site ALL DEPENDS "${CMAKE_BINARY_DIR}/site/raywalk.html")
