// SPDX-License-Identifier: MIT
#include <games/shell/desktop/scores_file.h>

#include <SDL.h>

#include <fstream>
#include <memory>

namespace plumb::games {

std::string scoresFileOf(const std::string& game) {
    const std::unique_ptr<char, decltype(&SDL_free)> folder(SDL_GetPrefPath("plumb", game.c_str()), &SDL_free);
    return folder ? std::string(folder.get()) + "scores.txt" : std::string();
}

std::vector<std::int64_t> readScores(const std::string& file) {
    std::vector<std::int64_t> scores;
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);) {
        char* end = nullptr;
        const long long score = std::strtoll(line.c_str(), &end, 10);
        if (end != line.c_str() && *end == '\0') scores.push_back(score);
    }
    return scores;
}

void writeScores(const std::string& file, const std::vector<std::int64_t>& scores) {
    if (file.empty()) return;
    std::ofstream out(file);
    for (const std::int64_t score : scores) out << score << '\n';
}

}  // namespace plumb::games
