// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/yaml/remark_lines.h"

#include <algorithm>

#include "core/text/text_input.h"

namespace drillwave {
namespace {

bool isRemark(std::string_view line) {
    return line.starts_with(writtenRemark) || line.starts_with(solvedRemark) ||
           line.starts_with(columnsRemark);
}

}  // namespace

std::size_t remarksLength(std::string_view yaml) {
    std::size_t length = byteOrderMarkLength(yaml);
    if (!yaml.substr(length).starts_with(writtenRemark)) return 0;
    for (std::string_view rest = yaml.substr(length); isRemark(rest); rest = yaml.substr(length))
        length += std::min(rest.find('\n'), rest.size() - 1) + 1;
    return length;
}

}  // namespace drillwave
