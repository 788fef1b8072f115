// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/shown_text.h"

#include <QCoreApplication>

namespace drillwave {

QString fromView(std::string_view text) {
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

QString translated(const Message& message) {
    if (message.isEmpty()) return {};
    // Not by arg(): what stands for %1 may hold a "%2" itself.
    const std::string pattern =
        QCoreApplication::translate("drillwave::Message", message.pattern).toStdString();
    return QString::fromStdString(Message{pattern.c_str(), message.arguments}.text());
}

QString shownSymbol(std::string_view symbol) {
    return fromView(symbol).replace(u'0', QStringLiteral("₀"));
}

}  // namespace drillwave
