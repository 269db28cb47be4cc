// SPDX-License-Identifier: MIT
// How does one operation act on several floats at once?
//
// Wide<W>::Float is W floats, and Wide<W>::Double half as many doubles, that are added, multiplied and compared lane by
// lane, with the compiler's vector extensions, so that it works on any machine. Code for W lanes is a template over W.
// W = 8 and 16 are compiled in files of their own, named ..._8.cpp and ..._16.cpp, with wider instruction sets. These
// files must not emit any other code: an inline function that is not a template over W would be merged by the linker
// with the copies of other files, and run on machines that lack the instructions. W = 1 is a plain float, so that the
// same code serves vectors and scalars.
#pragma once
#include <cstdint>

namespace plumb {

/// Number of pairs, contacts or joints that are stored side by side, so that one vector operation can load a value of
/// several of them.
inline constexpr int batchLanes = 16;

/// One value for each of them. A plain array, so that code compiled for wider machines can use it.
template <class T>
using Lanes = T[batchLanes];

template <int W>
struct Wide;

template <>
struct Wide<1> {
    using Float = float;
    using Double = double;
    static constexpr int doubles = 1;
    using Int = std::int32_t;
    using Mask = bool;
};
#if defined(__GNUC__)
template <>
struct Wide<4> {
    typedef double Double __attribute__((vector_size(16)));
    static constexpr int doubles = 2;
    typedef float Float __attribute__((vector_size(16)));
    typedef std::int32_t Int __attribute__((vector_size(16)));
    using Mask = Int;  ///< of a comparison: -1 where it is true, else 0
};
template <>
struct Wide<8> {
    typedef double Double __attribute__((vector_size(32)));
    static constexpr int doubles = 4;
    typedef float Float __attribute__((vector_size(32)));
    typedef std::int32_t Int __attribute__((vector_size(32)));
    using Mask = Int;
};
template <>
struct Wide<16> {
    typedef double Double __attribute__((vector_size(64)));
    static constexpr int doubles = 8;
    typedef float Float __attribute__((vector_size(64)));
    typedef std::int32_t Int __attribute__((vector_size(64)));
    using Mask = Int;
};
#endif

/// The fewest and the most lanes for which there is code. WebAssembly has 4, and code for one would be loaded in vain.
#if !defined(__GNUC__)
inline constexpr int fewestLanes = 1, mostLanes = 1;
#elif defined(__wasm__)
inline constexpr int fewestLanes = 4, mostLanes = 4;
#else
inline constexpr int fewestLanes = 1, mostLanes = 16;
#endif

}  // namespace plumb
