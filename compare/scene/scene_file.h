// SPDX-License-Identifier: MIT
// How is a scene read from a file?
#pragma once
#include <filesystem>

#include <compare/scene/scene.h>

namespace plumb::compare {

/// The scene in a file. Throws as fromJson does, and when the file cannot be read.
Scene readScene(const std::filesystem::path& path);

}  // namespace plumb::compare
