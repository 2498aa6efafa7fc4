#pragma once
// What packs the page's texts (text_packer.cpp) and what unpacks them (unpack.cpp) take a text's next letter to be:
// PPMd, variant H, of Dmitry Shkarin. It forgets all when its memory is full, and then packs worse.

namespace raywalk {

inline constexpr unsigned text_order = 12;         ///< letters before it that it looks at, at most
inline constexpr unsigned text_memory = 24 << 20;  ///< bytes; these texts fill some 21 MiB

}  // namespace raywalk
