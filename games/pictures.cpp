// SPDX-License-Identifier: MIT
// plumb-pictures [FOLDER]: every screen of every game, at three sizes, as PNG files in build/pictures.
#include <exception>
#include <iostream>

#include <games/all_games.h>
#include <games/shell/pictures/pictures.h>

int main(int argc, char** argv) {
    const std::string folder = argc > 1 ? argv[1] : "build/pictures";
    try {
        std::size_t count = 0;
        for (const plumb::games::GameInfo& info : plumb::games::allGames())
            count += plumb::games::writePictures(info, folder).size();
        std::cout << count << " pictures in " << folder << '\n';
    } catch (const std::exception& error) {
        std::cerr << "plumb-pictures: " << error.what() << '\n';
        return 2;
    }
}
