// SPDX-License-Identifier: MIT
#include <compare/scene/scene_file.h>

#include <fstream>
#include <iterator>
#include <stdexcept>
#include <system_error>

#include <compare/scene/json.h>

namespace plumb::compare {

Scene readScene(const std::filesystem::path& path) {
    std::error_code error;
    if (std::filesystem::is_directory(path, error)) {
        throw std::invalid_argument(path.string() + ": is a folder, wanted a scene's JSON file");
    }
    std::ifstream file(path, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    if (!file) throw std::invalid_argument(path.string() + ": cannot be read, wanted a scene's JSON file");
    return fromJson(text, path.string());
}

}  // namespace plumb::compare
