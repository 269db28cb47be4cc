// SPDX-License-Identifier: MIT
// Where do lists that live no longer than a step get their memory? From those of earlier steps: so once a world is
// warm, its steps ask the system for none. Test: "a warm world steps without asking for memory"
#pragma once
#include <cstddef>
#include <new>
#include <unordered_map>
#include <vector>

namespace plumb {

/// Blocks of memory that were given back, in sizes of powers of two. Each thread has its own, and keeps them.
class StepMemory {
public:
    static void* take(std::size_t bytes);
    static void giveBack(void* block, std::size_t bytes) noexcept;
};

template <class T>
struct StepAllocator {
    using value_type = T;

    StepAllocator() = default;
    template <class Other>
    StepAllocator(const StepAllocator<Other>&) {}
    T* allocate(std::size_t count) { return static_cast<T*>(StepMemory::take(count * sizeof(T))); }
    void deallocate(T* items, std::size_t count) noexcept { StepMemory::giveBack(items, count * sizeof(T)); }
    friend bool operator==(const StepAllocator&, const StepAllocator&) { return true; }
};

/// A vector for use within a step.
template <class T>
using StepList = std::vector<T, StepAllocator<T>>;

/// A hash map for use within a step.
template <class Key, class T>
using StepMap = std::unordered_map<Key, T, std::hash<Key>, std::equal_to<Key>, StepAllocator<std::pair<const Key, T>>>;

}  // namespace plumb
