// SPDX-License-Identifier: GPL-3.0-or-later
// The sentences on a page of a study.
#pragma once

#include <QLabel>

namespace drillwave {

/// Returns the answer and the sentences below it, separated by a blank.
inline QString pageWords(const QWidget& page) {
    const QString answer = page.findChild<QLabel*>(QStringLiteral("answer"))->text();
    const QString more = page.findChild<QLabel*>(QStringLiteral("words"))->text();
    return more.isEmpty() ? answer : answer + QLatin1Char(' ') + more;
}

}  // namespace drillwave
