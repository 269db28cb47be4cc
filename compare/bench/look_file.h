// SPDX-License-Identifier: MIT
// Where are the looks at a run stored until all of its steps are timed?
#pragma once
#include <cstdio>
#include <memory>
#include <vector>

#include <compare/engine/engine.h>

namespace plumb::compare {

/// They are stored in a file without a name, so that they do not count as the engine's memory.
class LookFile {
public:
    /// Throws std::runtime_error when the system gives no file.
    LookFile();

    void write(const std::vector<BodyState>& states, const Broken& broken);
    /// Reads the looks one by one, from the first; false if there are no more.
    bool read(std::vector<BodyState>& states, Broken& broken);

private:
    struct Close {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    std::unique_ptr<std::FILE, Close> file_;
    bool reading_ = false;
};

}  // namespace plumb::compare
