// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/help/manual_place.h"

#include <QRegularExpression>

namespace drillwave {
namespace {

const QString scheme = QStringLiteral("manual");

}  // namespace

QUrl urlOf(const ManualPlace& place) {
    QUrl url;
    url.setScheme(scheme);
    url.setPath(place.chapter);
    if (!place.heading.isEmpty()) url.setFragment(place.heading);
    return url;
}

ManualPlace placeOf(const QUrl& url) {
    if (url.scheme() != scheme) return {};
    return {url.path(), url.fragment(QUrl::FullyDecoded)};
}

bool isHeading(const QString& shown, const QString& meant) {
    if (shown == meant || shown.startsWith(meant + u' ') || shown.startsWith(meant + u':')) return true;
    static const QRegularExpression number(QStringLiteral("^§[0-9.]+ ")),
        between(QStringLiteral(", | %1 ").arg(QStringView(andWords)));
    return QString(shown).remove(number).split(between).contains(meant);
}

}  // namespace drillwave
