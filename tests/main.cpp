// SPDX-License-Identifier: MIT
// A main of our own: the two versions of Catch2 offer theirs in different ways.
#define CATCH_CONFIG_RUNNER
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>

#include "catch.h"

// Asked by LeakSanitizer: fontconfig, which the games' texts need, keeps memory by offsets, in which that sees no
// pointers.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() {
    return "leak:libfontconfig\n";
}

namespace {

/// A folder for temporary files that this run of the tests has for itself: several run at the same time.
class OwnFolder {
public:
    OwnFolder() {
        std::string name = (std::filesystem::temp_directory_path() / "plumb-tests-XXXXXX").string();
        if (mkdtemp(name.data()) == nullptr) throw std::runtime_error(name + ": no such folder can be made");
        path_ = name;
        setenv("TMPDIR", name.c_str(), 1);
    }
    ~OwnFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    OwnFolder(const OwnFolder&) = delete;
    OwnFolder& operator=(const OwnFolder&) = delete;

private:
    std::filesystem::path path_;
};

}  // namespace

int main(int argc, char** argv) {
    const OwnFolder temporary;
    return Catch::Session().run(argc, argv);
}
