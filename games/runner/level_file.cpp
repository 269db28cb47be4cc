// SPDX-License-Identifier: MIT

#include <array>
#include <cstdio>
#include <memory>
#include <stdexcept>

#include <games/runner/level_text.h>

namespace plumb::games::runner {
namespace {

struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
};

}  // namespace

// By the C library: the C++ library for WebAssembly has no file streams.
Level levelIn(const std::string& name) {
    const std::unique_ptr<std::FILE, Close> file(std::fopen(name.c_str(), "rb"));
    std::string text;
    if (file) {
        std::array<char, 4096> part;
        while (const std::size_t count = std::fread(part.data(), 1, part.size(), file.get()))
            text.append(part.data(), count);
    }
    if (!file || std::ferror(file.get()) != 0)
        throw std::invalid_argument(name + ": cannot be read; a level's text was wanted");
    return readLevel(text, name);
}

}  // namespace plumb::games::runner
