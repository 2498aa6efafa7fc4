#!/usr/bin/env bash
# What the page is built with: tools.sh BUILD unpacks Emscripten into BUILD/emscripten, and builds the libraries that the
# page uses from Debian's sources into BUILD/web-libraries. Neither touches the system, and neither is done twice.
#
# Emscripten is Debian 13's, whatever this system is: Debian 12's has a standard library without ranges. Its compiler is
# the clang of this system. The libraries are Debian 12's, so that the page has the versions that the window is tested
# with.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
build=$(realpath -m "$1")
emscripten=$build/emscripten
libraries=$build/web-libraries
tools_suite=trixie
sources_suite=bookworm

say() { printf '%s\n' "raywalk: $*" >&2; }
fail() {
  say "$1"
  [[ $# -gt 1 ]] && printf '%s\n' "    $2" >&2
  exit 1
}

# once FOLDER FUNCTION: calls FUNCTION, which makes FOLDER, unless it was called as it stands here.
once() {
  [[ -f $1/done && $(<"$1/done") == "$(declare -f "$2")" ]] && return
  rm -rf "$1"
  "$2"
  declare -f "$2" >"$1/done"
}

# --- A private apt, which knows two suites of the mirror that this system uses ---------------------------------------

apt=()

open_apt() {
  ((${#apt[@]} == 0)) || return 0
  command -v apt-get >/dev/null && command -v dpkg-deb >/dev/null ||
    fail "the page's tools come from Debian's packages, and there is no apt-get here." \
      "Build the page on Debian, or in a container of it."
  local mirror key=/usr/share/keyrings/debian-archive-keyring.gpg folder=$build/web-apt
  mirror=$(apt-get indextargets --format '$(ORIGIN) $(LABEL) $(REPO_URI)' 'Created-By: Packages' |
    awk '$1 == "Debian" && $2 == "Debian" { print $3; exit }')
  [[ -n $mirror ]] || fail "this system's apt knows no mirror of Debian, which has the page's tools." \
    "Build the page on Debian 12 or 13, or in a container of it."
  [[ -f $key ]] || fail "the key of Debian's archive is not here ($key)." "apt-get install debian-archive-keyring"
  mkdir -p "$folder"/{lists/partial,archives/partial}
  printf 'deb%s [signed-by=%s] %s %s main\n' '' "$key" "$mirror" "$tools_suite" -src "$key" "$mirror" "$sources_suite" \
    >"$folder/sources.list"
  apt=(apt-get -qq -o "Dir::Etc::sourcelist=$folder/sources.list" -o Dir::Etc::sourceparts=/dev/null
    -o "Dir::State::lists=$folder/lists" -o "Dir::Cache=$folder" -o "APT::Sandbox::User=$(id -un)")
  "${apt[@]}" update || fail "the lists of Debian's packages could not be fetched (apt's message is above)."
}

# --- Emscripten ------------------------------------------------------------------------------------------------------

unpack_emscripten() {
  say "fetching Emscripten (once)"
  open_apt
  mkdir -p "$emscripten"/{packages,root,binaryen/bin}
  (cd "$emscripten/packages" && "${apt[@]}" download emscripten binaryen python3-fonttools {libc6,libstdc++6,libgcc-s1}/$tools_suite) ||
    fail "Emscripten's packages could not be fetched (apt's message is above)."
  local package tool root=$emscripten/root
  for package in "$emscripten"/packages/*.deb; do dpkg-deb -x "$package" "$root"; done
  rm -rf "$emscripten/packages" "$root/usr/share/"{doc,man} "$root/usr/share/emscripten/"{test,docs}
  ln -sfn /usr/share/nodejs "$root/usr/share/emscripten/node_modules"

  # Its optimiser was linked with a newer C library than this system's may be: it runs with the one unpacked beside it.
  local own
  own=$(dirname "$(find "$root" -name 'ld-linux-*.so.*' -print -quit)")
  [[ -d $own ]] || fail "Emscripten's packages hold no loader for this processor."
  own=$(cd "$own" && pwd)
  for tool in "$root"/usr/bin/wasm-*; do
    printf '#!/bin/sh\nexec "%s" --library-path "%s" "%s" "$@"\n' "$(echo "$own"/ld-linux-*.so.*)" \
      "$own:$(dirname "$(find "$root" -name 'libbinaryen.so*' -print -quit)")" "$tool" >"$emscripten/binaryen/bin/${tool##*/}"
  done
  chmod +x "$emscripten"/binaryen/bin/*
  sed -i "s#^BINARYEN_ROOT.*#BINARYEN_ROOT = '$emscripten/binaryen'#" "$root/usr/share/emscripten/.emscripten"
}

# --- Libraries -------------------------------------------------------------------------------------------------------

prefix=$libraries/prefix

# by_cmake NAME TARGET ARGS...: configures it and builds this target, which may be `install`.
by_cmake() {
  local name=$1 target=$2
  shift 2
  emcmake cmake -G Ninja -S "$libraries/sources/$name" -B "$libraries/work/$name" -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_INSTALL_PREFIX="$prefix" -DCMAKE_C_FLAGS="$flags" -DCMAKE_CXX_FLAGS="$flags" \
    -DCMAKE_C_FLAGS_RELEASE= -DCMAKE_CXX_FLAGS_RELEASE= -DCMAKE_FIND_ROOT_PATH="$prefix" \
    -DBUILD_SHARED_LIBS=OFF "$@" >/dev/null &&
    ninja -C "$libraries/work/$name" "$target" >/dev/null
}

# by_hand NAME LIBRARY FLAGS -- FILES...: compiles these files of it into libLIBRARY.a; all at once, for the compiler's
# driver takes longer to start than most of them to compile.
by_hand() {
  local name=$1 library=$2 folder=$libraries/sources/$1 own=()
  shift 2
  while [[ $1 != -- ]]; do own+=("$1"); shift; done
  shift
  mkdir -p "$libraries/work/$name"
  # shellcheck disable=SC2086  # the flags are words
  (cd "$libraries/work/$name" && emcc $flags "${own[@]}" "-I$folder" "-I$prefix/include" -c "${@/#/$folder/}" &&
    emar rcs "$prefix/lib/lib$library.a" ./*.o)
}

build_libraries() {
  # Small rather than fast: pictures and glyphs are read once. Like all of the page, they throw by WebAssembly's own means;
  # they do without its vectors, for a page that does. What they warn of is their authors' business.
  local flags="-w -Oz -DNDEBUG -fwasm-exceptions -sSUPPORT_LONGJMP=wasm"
  say "building the page's libraries (once)"
  open_apt
  mkdir -p "$libraries"/{packages,sources,work} "$prefix"/{include,lib}
  (cd "$libraries/packages" &&
    "${apt[@]}" source --download-only zlib libpng1.6 giflib libjpeg-turbo freetype fmtlib imgui 7zip >/dev/null &&
    "${apt[@]}" source --download-only --tar-only qrencode >/dev/null) ||
    fail "the libraries' sources could not be fetched (apt's message is above)."
  local description name from=$libraries/sources
  for description in "$libraries"/packages/*.dsc; do
    name=${description##*/}
    dpkg-source --no-check -x "$description" "$libraries/sources/${name%%_*}" >/dev/null
  done
  mkdir "$from/qrencode" # as its authors gave it: what Debian adds is not of the library
  tar -xf "$libraries"/packages/qrencode_*.orig.tar.* -C "$from/qrencode" --strip-components=1
  export PATH=$emscripten/root/usr/share/emscripten:$PATH

  # Its tables of checksums are made when they are first used: no packer makes random numbers smaller.
  by_hand zlib z -DDYNAMIC_CRC_TABLE -- adler32.c compress.c crc32.c deflate.c inffast.c inflate.c inftrees.c trees.c uncompr.c zutil.c
  cp "$from"/zlib/{zlib,zconf}.h "$prefix/include"
  # Without what says something beside the picture.
  local chunks='eXIf|hIST|oFFs|pCAL|pHYs|sCAL|sPLT|tIME|TEXT|tEXt|zTXt|iTXt'
  sed -E "s/^#define (PNG_(READ_|WRITE_)?($chunks)_SUPPORTED)/#undef \1/" \
    "$from"/libpng1.6/scripts/pnglibconf.h.prebuilt >"$from"/libpng1.6/pnglibconf.h
  by_hand libpng1.6 png -- png.c pngerror.c pngget.c pngmem.c pngpread.c pngread.c pngrio.c pngrtran.c pngrutil.c \
    pngset.c pngtrans.c pngwio.c pngwrite.c pngwtran.c pngwutil.c
  cp "$from"/libpng1.6/{png,pngconf,pnglibconf}.h "$prefix/include"
  by_hand giflib gif -DHAVE_REALLOCARRAY=1 -- dgif_lib.c egif_lib.c gif_err.c gif_hash.c gifalloc.c openbsd-reallocarray.c
  cp "$from"/giflib/gif_lib.h "$prefix/include"
  by_cmake libjpeg-turbo turbojpeg-static -DENABLE_SHARED=0 -DWITH_SIMD=0 -DWITH_JAVA=0 -DWITH_ARITH_ENC=0 -DWITH_ARITH_DEC=0
  cp "$libraries/work/libjpeg-turbo/libturbojpeg.a" "$prefix/lib"
  cp "$from/libjpeg-turbo/turbojpeg.h" "$prefix/include"
  # What the page's four fonts need: nothing packed, whose reader would be a second zlib, no names of glyphs in place of
  # codes, no pictures, no scripts of Asia, no tables of characters but the two kinds that fonts have today, and none of
  # TrueType's hints, which light hinting does not follow.
  sed -i -E '/FT_USE_MODULE/{/ (autofit|tt_driver|cff_driver|psaux|psnames|pshinter|sfnt|ft_smooth_renderer)_/!d}' \
    "$from"/freetype/include/freetype/config/ftmodule.h
  local unused='FT_CONFIG_OPTION_(USE_ZLIB|USE_LZW|ADOBE_GLYPH_LIST|MAC_FONTS|INCREMENTAL|ENVIRONMENT_PROPERTIES|SVG)'
  unused+='|TT_CONFIG_OPTION_(BYTECODE_INTERPRETER|GX_VAR_SUPPORT|EMBEDDED_BITMAPS|COLOR_LAYERS|BDF)'
  unused+='|TT_CONFIG_CMAP_FORMAT_(0|2|6|8|10|13|14)|AF_CONFIG_OPTION_CJK'
  sed -i -E "s/^#define ($unused)/#undef \1/; s/^#undef (T1_CONFIG_OPTION_NO_AFM)/#define \1/" "$from"/freetype/include/freetype/config/ftoption.h
  by_cmake freetype install -DFT_DISABLE_ZLIB=ON -DFT_DISABLE_BZIP2=ON -DFT_DISABLE_PNG=ON -DFT_DISABLE_HARFBUZZ=ON \
    -DFT_DISABLE_BROTLI=ON
  # Nobody asks for digits in groups, for which it would look into the standard library's locales.
  by_cmake fmtlib install -DFMT_TEST=OFF -DFMT_DOC=OFF "-DCMAKE_CXX_FLAGS=$flags -DFMT_STATIC_THOUSANDS_SEPARATOR=44"
  by_hand qrencode qrencode -DSTATIC_IN_RELEASE=static -DMAJOR_VERSION=4 -DMINOR_VERSION=1 -DMICRO_VERSION=1 '-DVERSION="4.1.1"' -- \
    bitstream.c mask.c mmask.c mqrspec.c qrencode.c qrinput.c qrspec.c rsecc.c split.c
  cp "$from"/qrencode/qrencode.h "$prefix/include"
  # Of 7-Zip the decoders of LZMA and PPMd, and PPMd's encoder, which their authors have put into the public domain. They
  # ask for nothing but memory, and LZMA's is less than half as large as liblzma's, of xz.
  by_hand 7zip 7zip -- C/LzmaDec.c C/Ppmd7.c C/Ppmd7Dec.c C/Ppmd7Enc.c
  cp "$from"/7zip/C/{7zTypes,CpuArch,LzmaDec,Ppmd,Ppmd7}.h "$prefix/include"
  # With the parts that Debian's own has, but the font that it holds for who loads none. GLFW is Emscripten's, which needs
  # no library.
  sed -i '/^static const char proggy_clean_ttf_compressed_data_base85/,/;$/c static const char proggy_clean_ttf_compressed_data_base85[] = "";' \
    "$from"/imgui/imgui_draw.cpp
  # Its table of checksums is made when it is first used, too.
  sed -i -e '/^static const ImU32 GCrc32LookupTable\[256\] =/,/^};/d' -e 's/= GCrc32LookupTable;/= checksums();/' \
    -e '/^ImGuiID ImHashData(/i static const ImU32* checksums() {\n  static const struct Table {\n    ImU32 of[256];\n    Table() {\n      for (ImU32 i = 0; i < 256; ++i) {\n        of[i] = i;\n        for (int k = 0; k < 8; ++k) of[i] = (of[i] \& 1) ? (of[i] >> 1) ^ 0xEDB88320u : of[i] >> 1;\n      }\n    }\n  } table;\n  return table.of;\n}' \
    "$from"/imgui/imgui.cpp
  # It draws alone, and need not put back the state of WebGL, which it would ask for: an answer waits until all before is
  # drawn.
  sed -i '/^void *ImGui_ImplOpenGL3_RenderDrawData/,/^}/{s/if (last_enable_scissor_test).*/glDisable(GL_SCISSOR_TEST);/;/last_/d}' \
    "$from"/imgui/backends/imgui_impl_opengl3.cpp
  by_hand imgui imgui -std=c++17 "-I$prefix/include/freetype2" "-I$from/imgui/backends" -DIMGUI_ENABLE_FREETYPE \
    -DIMGUI_IMPL_OPENGL_ES3 -DIMGUI_DISABLE_DEMO_WINDOWS -- imgui.cpp imgui_draw.cpp imgui_tables.cpp imgui_widgets.cpp \
    backends/imgui_impl_glfw.cpp backends/imgui_impl_opengl3.cpp misc/freetype/imgui_freetype.cpp
  mkdir -p "$prefix/include/imgui/backends"
  cp "$from"/imgui/{imgui,imgui_internal,imconfig,imstb_textedit}.h "$from"/imgui/misc/freetype/imgui_freetype.h "$prefix/include/imgui"
  cp "$from"/imgui/backends/imgui_impl_{glfw,opengl3}.h "$prefix/include/imgui/backends"
  # Libraries that are only headers are this system's own.
  local header
  for header in glm tl nlohmann; do ln -sfn "/usr/include/$header" "$prefix/include/$header"; done
  # This standard library's from_chars knows no fractions, which toml++ then reads by a stream: the only one of the page,
  # and it would bring its locales along.
  cp -rL /usr/include/toml++ "$prefix/include"
  sed -i '/^\t*std::stringstream ss;$/,/^\t*if ((ss >> result))$/c\
				const std::string text(chars, length);\
				char* end = nullptr;\
				result = std::strtod(text.c_str(), \&end);\
				if (end == text.c_str() + length \&\& (result == 0 || result - result == 0))' \
    "$prefix"/include/toml++/impl/parser.inl

  # The page shows in its help what each of them asks to be shown.
  local licences=$prefix/share/licences
  mkdir -p "$licences"
  cp "$from/zlib/debian/copyright" "$licences/zlib"
  cp "$from/libpng1.6/LICENSE" "$licences/libpng"
  cp "$from/giflib/COPYING" "$licences/giflib"
  cp "$from/libjpeg-turbo/LICENSE.md" "$licences/libjpeg-turbo"
  cp "$from/freetype/docs/FTL.TXT" "$licences/FreeType"
  cp "$from"/fmtlib/LICENSE* "$licences/fmt"
  cp "$from/qrencode/COPYING" "$licences/libqrencode"
  (cd "$from/7zip/C" && head -2 LzmaDec.c && head -3 Ppmd7.c) >"$licences/LZMA SDK"
  cp "$from/imgui/LICENSE.txt" "$licences/Dear ImGui"
  cp /usr/share/doc/libglm-dev/copyright "$licences/GLM"
  cp /usr/share/doc/libexpected-dev/copyright "$licences/expected"
  cp /usr/share/doc/libtomlplusplus-dev/copyright "$licences/toml++"
  cp /usr/share/doc/nlohmann-json3-dev/copyright "$licences/JSON for Modern C++"
  cp "$emscripten/root/usr/share/emscripten/system/lib/libc/musl/COPYRIGHT" "$licences/musl"
  cat >"$licences/Emscripten" <<'MIT'
Copyright (c) 2010-2014 Emscripten authors, see its AUTHORS file.

Permission is hereby granted, free of charge, to any person obtaining a copy of this software and associated documentation
files (the "Software"), to deal in the Software without restriction, including without limitation the rights to use, copy,
modify, merge, publish, distribute, sublicense, and/or sell copies of the Software, and to permit persons to whom the
Software is furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in all copies or substantial portions of the
Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR IMPLIED, INCLUDING BUT NOT LIMITED TO THE
WARRANTIES OF MERCHANTABILITY, FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE AUTHORS OR
COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR
OTHERWISE, ARISING FROM, OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN THE SOFTWARE.
MIT
  rm -rf "$libraries"/{packages,sources,work}
}

once "$emscripten" unpack_emscripten
once "$libraries" build_libraries
