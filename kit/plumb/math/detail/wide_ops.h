// SPDX-License-Identifier: MIT
// Which operations are there on several floats at once? The same code works for a single float, and gives the same
// result.
#pragma once
#include <cmath>
#include <cstring>
#if defined(__x86_64__)
#include <immintrin.h>
#elif defined(__wasm_simd128__)
#include <wasm_simd128.h>
#endif

#include <plumb/math/detail/wide.h>

namespace plumb {

/// The larger one; b where the two compare as equal or not at all.
template <class F>
inline F larger(F a, F b) {
    return a > b ? a : b;
}
/// The smaller one; b where the two compare as equal or not at all.
template <class F>
inline F smaller(F a, F b) {
    return a < b ? a : b;
}

/// Where two comparisons are both true.
template <class M>
inline M both(M a, M b) {
    return a ? b : M{};
}

/// Where one of two comparisons is true.
template <class M>
inline M either(M a, M b) {
    return a ? a : b;
}

template <class F>
inline F magnitude(F a) {
    return larger(a, -a);
}

template <int W, class T>
struct LanesOf;
template <int W>
struct LanesOf<W, float> {
    using Type = typename Wide<W>::Float;
};
template <int W>
struct LanesOf<W, std::int32_t> {
    using Type = typename Wide<W>::Int;
};

template <int W>
struct LanesOf<W, double> {
    using Type = typename Wide<W>::Double;
};

/// W consecutive values.
template <int W, class T>
inline typename LanesOf<W, T>::Type loadLanes(const T* from) {
    typename LanesOf<W, T>::Type v;
    std::memcpy(&v, from, sizeof v);
    return v;
}
/// As a vector, not by memcpy: after that, compilers read all pointers and counts again, since it may have changed
/// them.
template <class V, class T>
inline void storeLanes(T* to, const V& v) {
    typedef V Lanes __attribute__((aligned(alignof(T))));
    *reinterpret_cast<Lanes*>(to) = v;
}

/// Correctly rounded (IEEE 754), so the same everywhere.
template <int W>
inline typename Wide<W>::Float squareRoot(typename Wide<W>::Float v) {
#if defined(__x86_64__)
    if constexpr (W == 4) return _mm_sqrt_ps(v);
    if constexpr (W == 8) return _mm256_sqrt_ps(v);
    if constexpr (W == 16) return _mm512_maskz_sqrt_ps(0xFFFF, v);  // GCC 12 warns of the plain one
#elif defined(__wasm_simd128__)
    if constexpr (W == 4) return typename Wide<W>::Float(wasm_f32x4_sqrt(v128_t(v)));
#endif
#if defined(__GNUC__)
    constexpr std::size_t count = W;
    float lanes[count];
    std::memcpy(lanes, &v, sizeof v);
    for (float& lane : lanes) lane = __builtin_sqrtf(lane);
    std::memcpy(&v, lanes, sizeof v);
    return v;
#else
    return std::sqrt(v);  // there is one lane only
#endif
}

template <int W>
inline typename Wide<W>::Double squareRoot(typename Wide<W>::Double v) {
#if defined(__x86_64__)
    if constexpr (W == 4) return _mm_sqrt_pd(v);
    if constexpr (W == 8) return _mm256_sqrt_pd(v);
    if constexpr (W == 16) return _mm512_maskz_sqrt_pd(0xFF, v);
#elif defined(__wasm_simd128__)
    if constexpr (W == 4) return typename Wide<W>::Double(wasm_f64x2_sqrt(v128_t(v)));
#endif
#if defined(__GNUC__)
    constexpr std::size_t count = Wide<W>::doubles;
    double lanes[count];
    std::memcpy(lanes, &v, sizeof v);
    for (double& lane : lanes) lane = __builtin_sqrt(lane);
    std::memcpy(&v, lanes, sizeof v);
    return v;
#else
    return std::sqrt(v);  // there is one lane only
#endif
}

/// Is a comparison of doubles true in some lane?
template <int W, class M>
[[gnu::always_inline]] inline bool anyOf(const M& mask) {
    if constexpr (W == 1) {
        return mask;
    } else {
        bool some = false;
        for (int i = 0; i < Wide<W>::doubles; ++i) some |= mask[i] != 0;
        return some;
    }
}

/// Bit i tells whether the comparison is true in lane i.
template <int W>
[[gnu::always_inline]] inline std::uint32_t bitsOf(const typename Wide<W>::Mask& mask) {
    if constexpr (W == 1) {
        return mask ? 1 : 0;
#if defined(__x86_64__)
    } else if constexpr (W == 4) {
        return static_cast<std::uint32_t>(__builtin_ia32_movmskps(typename Wide<W>::Float(mask)));
    } else if constexpr (W == 8) {
        return static_cast<std::uint32_t>(__builtin_ia32_movmskps256(typename Wide<W>::Float(mask)));
    } else if constexpr (W == 16) {
        typedef int Ints __attribute__((vector_size(64)));
        return static_cast<std::uint32_t>(__builtin_ia32_cvtd2mask512(Ints(mask)));
#elif defined(__wasm_simd128__)
    } else if constexpr (W == 4) {
        return wasm_i32x4_bitmask(v128_t(mask));
#endif
    } else {
        std::uint32_t bits = 0;
        for (int i = 0; i < W; ++i) bits |= static_cast<std::uint32_t>(mask[i] & 1) << i;
        return bits;
    }
}

}  // namespace plumb
