// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/language_option.h"

#include "app/command_error.h"
#include "core/text/decimal_text.h"

namespace drillwave {

const Language& languageOf(const std::string& code) {
    if (const Language* found = findLanguage(code)) return *found;
    std::string known;
    for (const Language& language : languages)
        known += (known.empty() ? "" : ", ") + std::string(language.code);
    throw CommandError(ExitCode::usage, code.empty()
                                            ? "--language needs one of " + known
                                            : "--language: `" + shortened(code) + "` is not one of " + known);
}

}  // namespace drillwave
