// SPDX-License-Identifier: MIT
#include <games/shell/headless/screenshots.h>

#include <fmt/format.h>

#include <stdexcept>

namespace plumb::games {

void Screenshots::take(const Session& session) {
    for (; !done() && wanted_[next_].at <= session.ticks(); ++next_)
        writeScreenshot(session, painter_, size_, wanted_[next_].file);
}

void Screenshots::requireDone(std::int64_t ticks) const {
    if (done()) return;
    throw std::runtime_error(
        fmt::format("--at: {} is after the end, which came after {} ticks", wanted_[next_].at, ticks));
}

void writeScreenshot(const Session& session, const Painter& painter, PixelSize size, const std::string& file) {
    Canvas canvas(size);
    session.draw(canvas);
    Picture picture(size);
    painter.paint(canvas.drawing(), picture.view());
    writePng(picture.view(), file);
}

}  // namespace plumb::games
