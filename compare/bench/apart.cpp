// SPDX-License-Identifier: MIT
#include <compare/bench/apart.h>

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <stdexcept>

namespace plumb::compare {
namespace {

void writeAll(int file, const std::string& text) {
    for (std::size_t sent = 0; sent < text.size();) {
        const ssize_t count = write(file, text.data() + sent, text.size() - sent);
        if (count < 0 && errno != EINTR) return;
        if (count > 0) sent += static_cast<std::size_t>(count);
    }
}

std::string readAll(int file) {
    std::string text;
    std::array<char, 4096> buffer;
    for (;;) {
        const ssize_t count = read(file, buffer.data(), buffer.size());
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return text;
        text.append(buffer.data(), static_cast<std::size_t>(count));
    }
}

}  // namespace

SpokenApart runApart(const std::function<std::string()>& speak) {
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0) throw std::runtime_error("bench: the system gives no pipe");
    const pid_t child = fork();
    if (child == 0) {
        close(ends[0]);
        writeAll(ends[1], speak());
        _exit(0);
    }
    close(ends[1]);
    SpokenApart ended;
    if (child > 0) ended.text = readAll(ends[0]);
    close(ends[0]);
    if (child < 0) throw std::runtime_error("bench: the system gives no process");
    while (waitpid(child, &ended.status, 0) < 0 && errno == EINTR) {
    }
    return ended;
}

}  // namespace plumb::compare
