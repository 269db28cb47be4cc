// SPDX-License-Identifier: MIT
// What comes of work that is done in a process of its own?
#pragma once
#include <functional>
#include <string>

namespace plumb::compare {

struct SpokenApart {
    std::string text;
    int status = 0;  ///< as waitpid gives it
};

/// What a process of its own says, and how it ended. Throws std::runtime_error when the system gives no process.
SpokenApart runApart(const std::function<std::string()>& speak);

}  // namespace plumb::compare
