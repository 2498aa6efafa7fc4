// Compiled for AVX2 function by function, so that no function that other files share is: the linker may take either's.

#include "accel/wide_search_eight.h"

#include "accel/wide_search_loop.h"

#if defined(__x86_64__)

#include <immintrin.h>

namespace raywalk {

namespace {

// No fused multiply-add, although such processors have it: it rounds once where four lanes round twice.
#define RAYWALK_LANE_TARGET [[gnu::target("avx2"), gnu::always_inline]]

namespace eight {

using Group = __m256;
constexpr unsigned group_lanes = 8;
RAYWALK_LANE_TARGET inline Group all_of(float value) { return _mm256_set1_ps(value); }
RAYWALK_LANE_TARGET inline Group loaded(const float* from) { return _mm256_load_ps(from); }
RAYWALK_LANE_TARGET inline void store_entries(BoxEntry* entries, unsigned /*lane*/, Group enters) {
  const __m256i keep = _mm256_set1_epi32(~static_cast<int>(BoxEntry::lane_bits));
  const __m256i bits =
      _mm256_or_si256(_mm256_and_si256(_mm256_castps_si256(enters), keep), _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7));
  _mm256_store_si256(reinterpret_cast<__m256i*>(entries), bits);
}
RAYWALK_LANE_TARGET inline Group min(Group a, Group b) { return _mm256_min_ps(a, b); }
RAYWALK_LANE_TARGET inline Group max(Group a, Group b) { return _mm256_max_ps(a, b); }
RAYWALK_LANE_TARGET inline Group absolute(Group a) { return _mm256_andnot_ps(_mm256_set1_ps(-0.0F), a); }
RAYWALK_LANE_TARGET inline Group with_signs_of(Group signs, Group a) {
  return _mm256_or_ps(a, _mm256_and_ps(signs, _mm256_set1_ps(-0.0F)));
}
template <class Mask>
RAYWALK_LANE_TARGET inline unsigned bits_where(Mask mask) {
  return static_cast<unsigned>(_mm256_movemask_ps(reinterpret_cast<Group>(mask)));
}

#include "accel/lane_tests.h"

}  // namespace eight

// Inlined into `advance` only: the loop itself is compiled for every processor.
struct EightAtATime {
  using Held = eight::HeldRay;
  [[gnu::target("avx2")]] static inline void hold(const MeshRay& ray, float t_far, Held& held) {
    eight::hold(ray, t_far, held);
  }
  [[gnu::target("avx2")]] static inline unsigned meet(const Held& ray, const WideNode& node, BoxEntry* entries) {
    return eight::meet(ray, node, entries);
  }
  [[gnu::target("avx2")]] static inline unsigned sift(const Held& ray, const TrianglePack& pack, unsigned count) {
    return eight::sift(ray, pack, count);
  }
};

#undef RAYWALK_LANE_TARGET

template <bool nearest_first>
[[gnu::target("avx2"), gnu::flatten]] bool advance(WideSearch<MeshRay>& search, float t_far) {
  return SearchLoop::run<EightAtATime, nearest_first, false>(search, t_far);
}

}  // namespace

bool (*advance_eight(bool nearest_first))(WideSearch<MeshRay>&, float) {
  return nearest_first ? &advance<true> : &advance<false>;
}

}  // namespace raywalk

#else

namespace raywalk {

bool (*advance_eight(bool /*nearest_first*/))(WideSearch<MeshRay>&, float) { return nullptr; }

}  // namespace raywalk

#endif
