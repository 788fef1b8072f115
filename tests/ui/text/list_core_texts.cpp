// SPDX-License-Identifier: GPL-3.0-or-later
// Prints the texts of the core that the window translates as sources that lupdate reads.
#include <cstdio>

#include "tests/support/core_texts.h"

int main() {
    for (const std::string& text : drillwave::test::coreTexts()) {
        std::string quoted;
        for (const char c : text) quoted += c == '"' || c == '\\' ? std::string{'\\', c} : std::string{c};
        std::printf("QT_TRANSLATE_NOOP(\"core\", \"%s\");\n", quoted.c_str());
    }
}
