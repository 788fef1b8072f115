// SPDX-License-Identifier: GPL-3.0-or-later
// Sentences shown on the page of a study.
#pragma once

#include <QLabel>

namespace drillwave {

/// Returns the main answer and the sentences below it, separated by a blank.
inline QString pageWords(const QWidget& page) {
    const QString answer = page.findChild<QLabel*>(QStringLiteral("answer"))->text();
    const QString more = page.findChild<QLabel*>(QStringLiteral("words"))->text();
    return more.isEmpty() ? answer : answer + QLatin1Char(' ') + more;
}

}  // namespace drillwave
