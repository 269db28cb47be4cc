// SPDX-License-Identifier: MIT
// How is a function taken that is called while the call lasts, whatever its type, without a copy of the code a type?
#pragma once
#include <memory>
#include <type_traits>
#include <utility>

namespace plumb {

template <class Signature>
class FunctionRef;

/// Refers to what can be called, and does not own it: for parameters alone. A call through it costs a pointer's, so it
/// is for what is looked at one by one, and not for the innermost loops.
template <class Result, class... Arguments>
class FunctionRef<Result(Arguments...)> {
public:
    template <class Function>
    requires(!std::is_same_v<std::remove_cvref_t<Function>, FunctionRef> &&
             std::is_invocable_r_v<Result, Function&, Arguments...>) FunctionRef(Function&& function)
        : function_(const_cast<void*>(static_cast<const void*>(std::addressof(function)))),
          call_([](void* target, Arguments... arguments) -> Result {
              return (*static_cast<std::remove_reference_t<Function>*>(target))(std::forward<Arguments>(arguments)...);
          }) {}

    Result operator()(Arguments... arguments) const { return call_(function_, std::forward<Arguments>(arguments)...); }

private:
    void* function_;
    Result (*call_)(void*, Arguments...);
};

}  // namespace plumb
