// SPDX-License-Identifier: MIT
// What does the command answer when it is called, and what does it leave in files?
#pragma once
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include <compare/command/command.h>

namespace plumb::compare {

struct Called {
    int status;
    std::string out, err;
};

inline Called call(const std::vector<std::string>& args) {
    std::ostringstream out, err;
    const int status = runCommand(args, out, err);
    return {status, out.str(), err.str()};
}

/// A folder of its own for one test, gone with it.
struct Folder {
    std::filesystem::path path;
    explicit Folder(const std::string& name) : path(std::filesystem::temp_directory_path() / name) {
        std::filesystem::remove_all(path);
        std::filesystem::create_directories(path);
    }
    ~Folder() { std::filesystem::remove_all(path); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    std::string operator/(const std::string& name) const { return (path / name).string(); }
};

inline std::string textOf(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace plumb::compare
