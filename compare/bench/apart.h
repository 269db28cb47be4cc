// SPDX-License-Identifier: MIT
// What is the result of work that is done in a separate process?
#pragma once
#include <functional>
#include <string>

namespace plumb::compare {

struct SpokenApart {
    std::string text;
    int status = 0;  ///< as returned by waitpid
};

/// Calls speak in a new process, and returns its text and how the process ended. Throws std::runtime_error when the
/// system gives no process.
SpokenApart runApart(const std::function<std::string()>& speak);

}  // namespace plumb::compare
