// SPDX-License-Identifier: MIT
// Where are the looks at a run kept until it has been timed?
#pragma once
#include <cstdio>
#include <memory>
#include <vector>

#include <compare/engine/engine.h>

namespace plumb::compare {

/// In a file that has no name, so that they are no memory of the engine's.
class LookFile {
public:
    /// Throws std::runtime_error when the system gives no file.
    LookFile();

    void write(const std::vector<BodyState>& states, const Broken& broken);
    /// From the first on; false when there is no other.
    bool read(std::vector<BodyState>& states, Broken& broken);

private:
    struct Close {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    std::unique_ptr<std::FILE, Close> file_;
    bool reading_ = false;
};

}  // namespace plumb::compare
