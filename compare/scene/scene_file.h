// SPDX-License-Identifier: MIT
// How is a scene read from a file?
#pragma once
#include <filesystem>
#include <string>

#include <compare/scene/scene.h>

namespace plumb::compare {

/// The text in a file. Throws std::invalid_argument if it cannot be read; wanted: what the file should be, for the
/// message.
std::string readText(const std::filesystem::path& path, const std::string& wanted);

/// The scene in a file. Throws as fromJson does, and when the file cannot be read.
Scene readScene(const std::filesystem::path& path);

}  // namespace plumb::compare
