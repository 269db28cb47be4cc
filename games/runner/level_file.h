// SPDX-License-Identifier: MIT
// How is a level read from a file?
#pragma once
#include <string>

#include <games/runner/level.h>

namespace plumb::games::runner {

/// Throws std::invalid_argument when the file cannot be read, and as readLevel() does. In a browser there are no files.
Level levelIn(const std::string& file);

}  // namespace plumb::games::runner
