// SPDX-License-Identifier: MIT
// What did a session look like after a number of ticks?
#pragma once
#include <vector>

#include <games/frame/session.h>
#include <games/shell/cairo/painter.h>
#include <games/shell/options.h>

namespace plumb::games {

/// Writes each picture when a session reaches its tick.
class Screenshots {
public:
    /// wanted: sorted by tick, the earliest first.
    Screenshots(std::vector<Screenshot> wanted, PixelSize size) : wanted_(std::move(wanted)), size_(size) {}

    void take(const Session& session);  ///< writes the pictures that are due
    bool done() const { return next_ == wanted_.size(); }
    /// Throws std::runtime_error that names the first tick that was not reached.
    void requireDone(std::int64_t ticks) const;

private:
    std::vector<Screenshot> wanted_;
    PixelSize size_;
    Painter painter_;
    std::size_t next_ = 0;
};

void writeScreenshot(const Session& session, const Painter& painter, PixelSize size, const std::string& file);

}  // namespace plumb::games
