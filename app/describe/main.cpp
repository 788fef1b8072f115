// SPDX-License-Identifier: GPL-3.0-or-later
// Writes manual pages and completions, for the build: drillwave-describe FOLDER [DATE]
#include <cstdio>
#include <string>

#include "app/describe/completions.h"
#include "app/describe/man_page.h"

namespace {

bool write(const std::string& path, const std::string& text) {
    std::FILE* file = std::fopen(path.c_str(), "w");
    const bool isWritten = file && std::fputs(text.c_str(), file) >= 0;
    if ((file && std::fclose(file) != 0) || !isWritten) {
        std::perror(path.c_str());
        return false;
    }
    return true;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2 || argc > 3) {
        std::fputs("usage: drillwave-describe FOLDER [DATE]\n", stderr);
        return 2;
    }
    const std::string folder = std::string(argv[1]) + "/";
    const std::string date = argc > 2 ? argv[2] : "";
    const bool areWritten = write(folder + "drillwave.1", drillwave::manPage(date)) &&
                            write(folder + "drillwave-window.1", drillwave::windowManPage(date)) &&
                            write(folder + "drillwave.bash", drillwave::bashCompletion()) &&
                            write(folder + "_drillwave", drillwave::zshCompletion()) &&
                            write(folder + "drillwave.fish", drillwave::fishCompletion());
    return areWritten ? 0 : 1;
}
