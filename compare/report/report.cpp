// SPDX-License-Identifier: MIT
#include <compare/report/report.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <system_error>

#include <compare/report/data.h>
#include <compare/report/page.h>

namespace plumb::compare {

void writeReport(const std::vector<SceneResult>& results, const std::filesystem::path& folder,
                 const std::vector<LabResult>& labs) {
    const std::string_view whole = page();
    const std::size_t mark = whole.find(pageDataMark);
    if (mark == std::string_view::npos) throw std::logic_error("the report's page has no place for its data");

    std::error_code error;
    std::filesystem::create_directories(folder, error);
    const std::filesystem::path path = folder / "index.html";
    std::ofstream file(path, std::ios::binary);
    file << whole.substr(0, mark) << scriptText(reportData(results, labs)) << whole.substr(mark + pageDataMark.size());
    file.flush();
    if (!file) throw std::runtime_error("report: cannot write " + path.string());
}

}  // namespace plumb::compare
