// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/result/feed_text.h"

#include <QCoreApplication>
#include <cmath>

#include "core/report/feed_words.h"
#include "ui/text/number_text.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

QString newtons(double force) {
    return quantityText(force, ShownUnit{1e-3, QStringLiteral("kN"), false}, QLocale());
}

}  // namespace

QString thrustNeededText(const SolvedBlow& blow) {
    if (!blow.feed) return {};
    return QStringLiteral("%1 … %2").arg(numberText(blow.feed->fullRate / 1000, 4, QLocale()),
                                         newtons(blow.feed->returned));
}

QString thrustInstalledText(const SolvedBlow& blow) {
    const std::optional<double>& installed = blow.scenario.drill.thrust;
    return installed ? newtons(*installed) : QString();
}

QString thrustMarginText(const SolvedBlow& blow) {
    if (!blow.feed || !blow.feed->force) return {};
    const double margin = *blow.feed->effective() - blow.feed->fullRate;
    const QString share = numberText(std::round(100 * margin / blow.feed->fullRate), 4, QLocale());
    return newtons(margin) + QStringLiteral(" (%1%2 %)").arg(margin > 0 ? "+" : "", share);
}

QString feedText(const SolvedBlow& blow) {
    return blow.feed ? fromView(feedWord(blow.feed->feed)) : QString();
}

QString feedMeaning(const SolvedBlow& blow) {
    return blow.feed ? QString::fromStdString(feedSentence(*blow.feed)) : QString();
}

}  // namespace drillwave
