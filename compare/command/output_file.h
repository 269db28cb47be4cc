// SPDX-License-Identifier: MIT
// Can a result be written to the wanted file?
#pragma once
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <utility>

namespace plumb::compare {

/// The file is opened before anything is run, so that a wrong path is reported at once; what it holds is only replaced
/// when the result is there. Throws std::runtime_error if the file cannot be written, and names the option that gave
/// its path.
class OutputFile {
public:
    OutputFile(std::string option, std::filesystem::path path)
        : option_(std::move(option)), path_(std::move(path)), file_(path_, std::ios::binary | std::ios::app) {
        mind();
    }
    void write(const std::string& text) {
        file_.close();
        file_.open(path_, std::ios::binary | std::ios::trunc);
        file_ << text;
        file_.close();
        mind();
    }

private:
    void mind() const {
        if (!file_) throw std::runtime_error(option_ + ": cannot write " + path_.string());
    }
    std::string option_;
    std::filesystem::path path_;
    std::ofstream file_;
};

}  // namespace plumb::compare
