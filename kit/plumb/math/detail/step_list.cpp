// SPDX-License-Identifier: MIT
#include <plumb/math/detail/step_list.h>

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

namespace plumb {

namespace {

/// A cache line: no item of a list needs more [bytes].
constexpr std::size_t least = 64;

struct FreeBlocks {
    /// A free block begins with the address of the next one.
    struct Block {
        Block* next = nullptr;
    };
    std::array<Block*, 64> first{};  ///< of each power of two

    ~FreeBlocks() {
        for (Block* block : first)
            while (block != nullptr) ::operator delete (std::exchange(block, block->next), std::align_val_t{least});
    }
};

#if defined(__wasm__)
FreeBlocks freeBlocks;  // a module has one thread, and nothing that would run at its end
#else
thread_local FreeBlocks freeBlocks;
#endif

int powerFor(std::size_t bytes) {
    return static_cast<int>(std::bit_width(std::max(bytes, least) - 1));
}

}  // namespace

void* StepMemory::take(std::size_t bytes) {
    const int power = powerFor(bytes);
    FreeBlocks::Block*& first = freeBlocks.first[static_cast<std::size_t>(power)];
    if (first == nullptr) return ::operator new (std::size_t{1} << power, std::align_val_t{least});
    return std::exchange(first, first->next);
}

void StepMemory::giveBack(void* block, std::size_t bytes) noexcept {
    FreeBlocks::Block*& first = freeBlocks.first[static_cast<std::size_t>(powerFor(bytes))];
    first = new (block) FreeBlocks::Block{first};
}

}  // namespace plumb
