// SPDX-License-Identifier: MIT
// How are records of four floats loaded into lanes and stored back (transposed)?
//
// W records are loaded as a whole, W / 4 side by side in one register, and transposed by shuffles within its quarters:
// a hardware gather takes 1.6 times as long (measured).
#pragma once
#include <cstddef>
#include <cstring>

#include <plumb/math/detail/wide.h>

namespace plumb {

/// One vector per field; lane i has record i.
template <int W>
struct Rows {
    typename Wide<W>::Float x, y, z, w;
};

/// Owner, the number of lanes of the file that uses it, makes the code of each file distinct for the linker.
template <int W, int Owner>
struct Shuffle;

#if defined(__GNUC__)

template <int Owner>
struct Shuffle<4, Owner> {
    using V = Wide<4>::Float;
    [[gnu::always_inline]] static inline V lowPairs(V a, V b) { return __builtin_shufflevector(a, b, 0, 4, 1, 5); }
    [[gnu::always_inline]] static inline V highPairs(V a, V b) { return __builtin_shufflevector(a, b, 2, 6, 3, 7); }
    [[gnu::always_inline]] static inline V lowHalves(V a, V b) { return __builtin_shufflevector(a, b, 0, 1, 4, 5); }
    [[gnu::always_inline]] static inline V highHalves(V a, V b) { return __builtin_shufflevector(a, b, 2, 3, 6, 7); }
    template <int Stride>
    [[gnu::always_inline]] static inline V gather(const float* rows, const std::uint32_t* indices) {
        V v;
        std::memcpy(&v, rows + std::size_t{Stride} * indices[0], sizeof v);
        return v;
    }
    [[gnu::always_inline]] static inline void scatter(float* rows, const std::uint32_t* indices, V v) {
        std::memcpy(rows + std::size_t{4} * indices[0], &v, sizeof v);
    }
};

template <int Owner>
struct Shuffle<8, Owner> {
    using V = Wide<8>::Float;
    [[gnu::always_inline]] static inline V lowPairs(V a, V b) {
        return __builtin_shufflevector(a, b, 0, 8, 1, 9, 4, 12, 5, 13);
    }
    [[gnu::always_inline]] static inline V highPairs(V a, V b) {
        return __builtin_shufflevector(a, b, 2, 10, 3, 11, 6, 14, 7, 15);
    }
    [[gnu::always_inline]] static inline V lowHalves(V a, V b) {
        return __builtin_shufflevector(a, b, 0, 1, 8, 9, 4, 5, 12, 13);
    }
    [[gnu::always_inline]] static inline V highHalves(V a, V b) {
        return __builtin_shufflevector(a, b, 2, 3, 10, 11, 6, 7, 14, 15);
    }
    template <int Stride>
    [[gnu::always_inline]] static inline V gather(const float* rows, const std::uint32_t* indices) {
        return __builtin_shufflevector(Shuffle<4, Owner>::template gather<Stride>(rows, indices),
                                       Shuffle<4, Owner>::template gather<Stride>(rows, indices + 4), 0, 1, 2, 3, 4, 5,
                                       6, 7);
    }
    [[gnu::always_inline]] static inline void scatter(float* rows, const std::uint32_t* indices, V v) {
        Shuffle<4, Owner>::scatter(rows, indices, __builtin_shufflevector(v, v, 0, 1, 2, 3));
        Shuffle<4, Owner>::scatter(rows, indices + 4, __builtin_shufflevector(v, v, 4, 5, 6, 7));
    }
};

template <int Owner>
struct Shuffle<16, Owner> {
    using V = Wide<16>::Float;
    [[gnu::always_inline]] static inline V lowPairs(V a, V b) {
        return __builtin_shufflevector(a, b, 0, 16, 1, 17, 4, 20, 5, 21, 8, 24, 9, 25, 12, 28, 13, 29);
    }
    [[gnu::always_inline]] static inline V highPairs(V a, V b) {
        return __builtin_shufflevector(a, b, 2, 18, 3, 19, 6, 22, 7, 23, 10, 26, 11, 27, 14, 30, 15, 31);
    }
    [[gnu::always_inline]] static inline V lowHalves(V a, V b) {
        return __builtin_shufflevector(a, b, 0, 1, 16, 17, 4, 5, 20, 21, 8, 9, 24, 25, 12, 13, 28, 29);
    }
    [[gnu::always_inline]] static inline V highHalves(V a, V b) {
        return __builtin_shufflevector(a, b, 2, 3, 18, 19, 6, 7, 22, 23, 10, 11, 26, 27, 14, 15, 30, 31);
    }
    template <int Stride>
    [[gnu::always_inline]] static inline V gather(const float* rows, const std::uint32_t* indices) {
        return __builtin_shufflevector(Shuffle<8, Owner>::template gather<Stride>(rows, indices),
                                       Shuffle<8, Owner>::template gather<Stride>(rows, indices + 8), 0, 1, 2, 3, 4, 5,
                                       6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
    }
    [[gnu::always_inline]] static inline void scatter(float* rows, const std::uint32_t* indices, V v) {
        Shuffle<8, Owner>::scatter(rows, indices, __builtin_shufflevector(v, v, 0, 1, 2, 3, 4, 5, 6, 7));
        Shuffle<8, Owner>::scatter(rows, indices + 8, __builtin_shufflevector(v, v, 8, 9, 10, 11, 12, 13, 14, 15));
    }
};

#endif

/// Loads the records at Stride * indices[lane] floats from rows.
template <int W, int Stride = 4>
[[gnu::always_inline]] inline Rows<W> loadRows(const float* rows, const std::uint32_t* indices) {
    if constexpr (W == 1) {
        const float* row = rows + std::size_t{Stride} * indices[0];
        return {row[0], row[1], row[2], row[3]};
    } else {
        using S = Shuffle<W, W>;
        using V = typename Wide<W>::Float;
        const V a = S::template gather<Stride>(rows, indices);
        const V b = S::template gather<Stride>(rows, indices + 1);
        const V c = S::template gather<Stride>(rows, indices + 2);
        const V d = S::template gather<Stride>(rows, indices + 3);
        const V ab = S::lowPairs(a, b), cd = S::lowPairs(c, d);
        const V abHigh = S::highPairs(a, b), cdHigh = S::highPairs(c, d);
        return {S::lowHalves(ab, cd), S::highHalves(ab, cd), S::lowHalves(abHigh, cdHigh),
                S::highHalves(abHigh, cdHigh)};
    }
}

/// No record may be in two lanes, unless both store the value that is there already.
template <int W>
[[gnu::always_inline]] inline void storeRows(float* rows, const std::uint32_t* indices, const Rows<W>& r) {
    if constexpr (W == 1) {
        float* row = rows + std::size_t{4} * indices[0];
        row[0] = r.x;
        row[1] = r.y;
        row[2] = r.z;
        row[3] = r.w;
    } else {
        using S = Shuffle<W, W>;
        using V = typename Wide<W>::Float;
        const V xy = S::lowPairs(r.x, r.y), zw = S::lowPairs(r.z, r.w);
        const V xyHigh = S::highPairs(r.x, r.y), zwHigh = S::highPairs(r.z, r.w);
        S::scatter(rows, indices, S::lowHalves(xy, zw));
        S::scatter(rows, indices + 1, S::highHalves(xy, zw));
        S::scatter(rows, indices + 2, S::lowHalves(xyHigh, zwHigh));
        S::scatter(rows, indices + 3, S::highHalves(xyHigh, zwHigh));
    }
}

}  // namespace plumb
