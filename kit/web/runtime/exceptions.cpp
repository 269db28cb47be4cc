// SPDX-License-Identifier: MIT
// How are exceptions thrown and caught in WebAssembly? Debian's C++ library for it was built without them. Here is the
// part of the Itanium C++ ABI that Clang's -fwasm-exceptions calls: for one thread, and without exception_ptr.
// Sources: the Itanium C++ ABI, "Exception handling"; WebAssembly tool conventions, "EHScheme".
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <typeinfo>

// The tag that Clang's code throws and catches. It carries one address.
__asm__(".globl __cpp_exception\n.tagtype __cpp_exception i32\n__cpp_exception:\n");

namespace __cxxabiv1 {

/// Laid out as in libc++abi, which defines it: each type can say whether a handler of it catches another.
class __shim_type_info : public std::type_info {
public:
    ~__shim_type_info() override;
    virtual void noop1() const;
    virtual void noop2() const;
    virtual bool can_catch(const __shim_type_info* thrown, void*& object) const = 0;
};

namespace {

/// Stands in memory before the object that was thrown.
struct alignas(16) Header {
    const __shim_type_info* type;
    void* (*destroy)(void*);  ///< in WebAssembly a destructor returns its argument
    void* seen;               ///< the object as the handler's type sees it: a base may lie elsewhere
    Header* outer;            ///< the exception whose handler was running when this one was caught
    int handlers;             ///< that are running for it
    bool rethrown;
};

Header* innermost = nullptr;  ///< of the exceptions whose handlers are running

Header* headerOf(void* object) {
    return static_cast<Header*>(object) - 1;
}

/// Reads numbers in the LEB128 form: 7 bits a byte, the lowest first.
struct Leb128 {
    const std::uint8_t* at;

    std::uint32_t natural() { return read().value; }
    std::int32_t integer() {
        const Number number = read();
        const bool isNegative = (number.last & 0x40) != 0 && number.bits < 32;
        return static_cast<std::int32_t>(number.value | (isNegative ? ~std::uint32_t{0} << number.bits : 0));
    }

private:
    struct Number {
        std::uint32_t value = 0;
        unsigned bits = 0;  ///< that were given
        std::uint8_t last = 0;
    };
    Number read() {
        Number number;
        do {
            number.last = *at++;
            number.value |= static_cast<std::uint32_t>(number.last & 0x7f) << number.bits;
            number.bits += 7;
        } while ((number.last & 0x80) != 0);
        return number;
    }
};

/// What Clang writes for a function with handlers (the LSDA): for each of its calls a chain of actions, each with a
/// type. Types are counted backwards from their end.
struct HandlerTable {
    const __shim_type_info* const* typesEnd = nullptr;
    Leb128 calls{nullptr};
    const std::uint8_t* actions = nullptr;

    explicit HandlerTable(const std::uint8_t* table) {
        constexpr std::uint8_t omitted = 0xff;
        Leb128 read{table};
        if (*read.at++ != omitted) read.natural();  // where the landing pads begin; Clang never gives it
        if (*read.at++ == omitted) return;          // no handlers, only destructors to run
        const std::uint32_t toTypes = read.natural();
        typesEnd = reinterpret_cast<const __shim_type_info* const*>(read.at + toTypes);
        ++read.at;  // how the calls are written: in LEB128
        const std::uint32_t length = read.natural();
        calls = read;
        actions = read.at + length;
    }

    /// The first action for one of the calls; null for none.
    const std::uint8_t* actionOf(std::uint32_t call) const {
        Leb128 read = calls;
        for (std::uint32_t i = 0; i < call; ++i) read.natural(), read.natural();
        read.natural();
        const std::uint32_t first = read.natural();
        return first == 0 ? nullptr : actions + first - 1;
    }
};

}  // namespace

extern "C" {

/// Where Clang's code asks for a handler, and where it finds the answer.
struct LandingPad {
    std::uint32_t call;
    const std::uint8_t* table;
    std::uint32_t selector;  ///< the number of the type that catches; 0: none does
};
LandingPad __wasm_lpad_context;

int _Unwind_CallPersonality(void* exception) {
    Header* thrown = static_cast<Header*>(exception);
    __wasm_lpad_context.selector = 0;
    const HandlerTable table(__wasm_lpad_context.table);
    if (table.typesEnd == nullptr) return 0;
    for (const std::uint8_t* action = table.actionOf(__wasm_lpad_context.call); action != nullptr;) {
        Leb128 read{action};
        const std::int32_t type = read.integer();
        const std::uint8_t* from = read.at;
        const std::int32_t next = read.integer();
        if (type > 0) {
            const __shim_type_info* wanted = table.typesEnd[-type];
            void* object = thrown + 1;
            if (wanted == nullptr || wanted->can_catch(thrown->type, object)) {
                thrown->seen = object;
                __wasm_lpad_context.selector = static_cast<std::uint32_t>(type);
                return 0;
            }
        }
        action = next == 0 ? nullptr : from + next;
    }
    return 0;
}

/// Clang's tables name it; nothing calls it.
int __gxx_wasm_personality_v0() {
    std::abort();
}

void* __cxa_allocate_exception(std::size_t size) noexcept {
    constexpr std::size_t grain = alignof(Header);
    void* memory = std::aligned_alloc(grain, (sizeof(Header) + size + grain - 1) / grain * grain);
    if (memory == nullptr) std::terminate();
    return static_cast<Header*>(memory) + 1;
}

void __cxa_free_exception(void* object) noexcept {
    std::free(headerOf(object));
}

[[noreturn]] void __cxa_throw(void* object, std::type_info* type, void* (*destroy)(void*)) {
    Header* thrown = headerOf(object);
    *thrown = {static_cast<const __shim_type_info*>(type), destroy, object, nullptr, 0, false};
    __builtin_wasm_throw(0, thrown);
}

void* __cxa_get_exception_ptr(void* exception) noexcept {
    return static_cast<Header*>(exception)->seen;
}

void* __cxa_begin_catch(void* exception) noexcept {
    Header* thrown = static_cast<Header*>(exception);
    if (thrown->handlers++ == 0 && innermost != thrown) {
        thrown->outer = innermost;
        innermost = thrown;
    }
    thrown->rethrown = false;
    return thrown->seen;
}

void __cxa_end_catch() {
    Header* thrown = innermost;
    if (thrown == nullptr || --thrown->handlers > 0) return;
    innermost = thrown->outer;
    if (thrown->rethrown) return;
    if (thrown->destroy != nullptr) thrown->destroy(thrown + 1);
    std::free(thrown);
}

[[noreturn]] void __cxa_rethrow() {
    if (innermost == nullptr) std::terminate();
    innermost->rethrown = true;
    __builtin_wasm_throw(0, innermost);
}

}  // extern "C"

}  // namespace __cxxabiv1
