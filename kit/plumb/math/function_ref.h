// SPDX-License-Identifier: MIT
// How is a function taken that is called while the call lasts, whatever its type, without a copy of the code a type?
#pragma once
#include <memory>
#include <type_traits>
#include <utility>

namespace plumb {

template <class Signature>
class FunctionRef;

/// Refers to what can be called, and does not own it: for parameters alone. What takes the first argument only may be
/// given too. A call through it costs a pointer's, so it is for what is looked at one by one, and not for the innermost
/// loops.
template <class Result, class First, class... Rest>
class FunctionRef<Result(First, Rest...)> {
public:
    template <class Function>
    requires(!std::is_same_v<std::remove_cvref_t<Function>, FunctionRef> &&
             (std::is_invocable_r_v<Result, Function&, First, Rest...> ||
              std::is_invocable_r_v<Result, Function&, First>)) FunctionRef(Function&& function)
        : function_(const_cast<void*>(static_cast<const void*>(std::addressof(function)))),
          call_([](void* target, First first, Rest... rest) -> Result {
              auto& called = *static_cast<std::remove_reference_t<Function>*>(target);
              if constexpr (std::is_invocable_r_v<Result, Function&, First, Rest...>)
                  return called(std::forward<First>(first), std::forward<Rest>(rest)...);
              else
                  return called(std::forward<First>(first));
          }) {}

    Result operator()(First first, Rest... rest) const {
        return call_(function_, std::forward<First>(first), std::forward<Rest>(rest)...);
    }

private:
    void* function_;
    Result (*call_)(void*, First, Rest...);
};

}  // namespace plumb
