// SPDX-License-Identifier: MIT
#include <compare/scene/scene_file.h>

#include <fstream>
#include <iterator>
#include <stdexcept>
#include <system_error>

#include <compare/scene/json.h>

namespace plumb::compare {

std::string readText(const std::filesystem::path& path, const std::string& wanted) {
    std::error_code error;
    if (std::filesystem::is_directory(path, error)) {
        throw std::invalid_argument(path.string() + ": is a folder, wanted " + wanted);
    }
    std::ifstream file(path, std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    if (!file) throw std::invalid_argument(path.string() + ": cannot be read, wanted " + wanted);
    return text;
}

Scene readScene(const std::filesystem::path& path) {
    return fromJson(readText(path, "a scene's JSON file"), path.string());
}

}  // namespace plumb::compare
