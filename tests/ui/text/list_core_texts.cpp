// SPDX-License-Identifier: GPL-3.0-or-later
// Prints the texts of the core that the window translates, and the help of the commands, as sources that
// lupdate reads.
#include <cstdio>

#include "app/help_text.h"
#include "tests/support/core_texts.h"

namespace {

void list(const char* context, std::string_view text) {
    std::string quoted;
    for (const char c : text)
        if (c == '\n')
            quoted += "\\n";
        else
            quoted += c == '"' || c == '\\' ? std::string{'\\', c} : std::string{c};
    std::printf("QT_TRANSLATE_NOOP(\"%s\", \"%s\");\n", context, quoted.c_str());
}

}  // namespace

int main() {
    for (const std::string& text : drillwave::test::coreTexts()) list("core", text);
    for (const std::string_view text : drillwave::helpTexts()) list("help", text);
}
