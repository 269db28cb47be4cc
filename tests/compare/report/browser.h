// SPDX-License-Identifier: MIT
// How does a page look to a browser without a screen?
#pragma once
#include <compare/report/report.h>

#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <string>
#include <vector>

#include "catch.h"
#include "compare/scripted.h"
#include "house/shell.h"

namespace plumb::compare {

namespace fs = std::filesystem;

/// A folder of its own that goes when the test does.
struct BrowserFolder {
    fs::path path = fs::temp_directory_path() / "plumb_browser_test";
    BrowserFolder() {
        fs::remove_all(path);
        fs::create_directories(path);
    }
    ~BrowserFolder() { fs::remove_all(path); }
};

struct Opened {
    std::string page;      ///< as it was after three seconds of the browser's time
    std::string messages;  ///< what the page's console and the network complained of
};

/// Empty where there is none.
inline std::string browser() {
    const std::string found =
        test::shell("command -v chromium || command -v chromium-browser || command -v google-chrome").output;
    return found.substr(0, found.find('\n'));
}

/// Not every distribution has one that starts without a desktop.
inline bool noBrowser() {
    if (!browser().empty()) return false;
    WARN("no chromium is installed: the report was not opened");
    return true;
}

/// Opens a file from disk in a browser without a screen, for which no host name has an address.
inline Opened open(const BrowserFolder& folder, const std::string& file, const std::string& state) {
    const fs::path log = folder.path / "log";
    const std::string command =
        "timeout 120 " + test::quoted(browser()) +
        " --headless --no-sandbox --disable-gpu --disable-quic --no-first-run --disable-background-networking"
        " --disable-component-update --disable-sync --host-resolver-rules='MAP * ~NOTFOUND' --window-size=1280,800"
        " --virtual-time-budget=3000 --enable-logging=stderr --dump-dom --user-data-dir=" +
        test::quoted((folder.path / "profile").string()) + " " +
        test::quoted("file://" + (folder.path / file).string() + "#" + state) + " 2>" + test::quoted(log.string());
    const test::Ran ran = test::shell(command);
    REQUIRE(ran.ok);
    Opened opened{ran.output, ""};
    std::ifstream lines(log);
    for (std::string line; std::getline(lines, line);)
        if (line.find(":CONSOLE") != std::string::npos) opened.messages += line + "\n";
    return opened;
}

/// Opens a page that has some of the scripts of compare/view, and then what is given.
inline Opened openWith(const BrowserFolder& folder, std::initializer_list<const char*> scripts,
                       const std::string& rest) {
    std::ofstream page(folder.path / "scripts.html");
    page << "<meta charset='utf-8'>";
    for (const char* script : scripts)
        page << "<script src='file://" PLUMB_SOURCE_DIR "/compare/view/" << script << "'></script>";
    page << rest << std::flush;
    return open(folder, "scripts.html", "");
}

/// The disc's closed form rises and falls; Plumb is 1.2 mm beside it, and a Box2D 0.3 pm.
inline std::vector<SceneResult> results() {
    const auto beside = [](const std::string& name, double x) {
        return scripted(name, {[x](double t) { return std::vector<BodyState>{at(x, 3 * t - 5 * t * t)}; }});
    };
    Scene scene = oneDisc();
    scene.question = "Does </script> end the page?";
    scene.checks = {ExactCheck{0.001, "to see it fail"}};
    return {runScene(
        scene, {},
        {beside("plumb", 0.0012), beside("box2d-2.4", 3e-13), unsupporting("box2d-3"), beside("closed-form", 0)})};
}

}  // namespace plumb::compare
