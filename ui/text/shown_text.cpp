// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/shown_text.h"

namespace drillwave {

QString fromView(std::string_view text) {
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

QString shownSymbol(std::string_view symbol) {
    return fromView(symbol).replace(u'0', QStringLiteral("₀"));
}

}  // namespace drillwave
