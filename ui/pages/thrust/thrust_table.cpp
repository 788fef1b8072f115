// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/thrust/thrust_table.h"

#include <QHeaderView>
#include <QScrollBar>
#include <cmath>

#include "core/report/feed_words.h"
#include "ui/text/core_text.h"
#include "ui/text/number_text.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

enum Row { bracket, margin, limit, gap, feed, rowsInAll };

// The columns are narrow.
QString shortName(ThrustCase which) {
    switch (which) {
        case ThrustCase::gapQuantile:
            return ThrustTable::tr("95 % of gaps");
        case ThrustCase::elasticWorst:
            return ThrustTable::tr("worst gap");
        default:
            return thrustCaseName(which);
    }
}

QString gapText(const GapAtBlow& found, const ShownUnit& unit) {
    if (found.motion.kind == UndampedMotion::Kind::resting) return ThrustTable::tr("none");
    if (found.motion.kind == UndampedMotion::Kind::pushedBack) return noNumber;
    if (!found.motion.stable) return ThrustTable::tr("not steady");
    return numberText(found.gap * unit.factor, 3, QLocale()) + QChar(QChar::Nbsp) + unit.unit;
}

}  // namespace

ThrustTable::ThrustTable(QWidget* parent) : QTableWidget(rowsInAll, int(thrustCaseCount), parent) {
    setObjectName(QStringLiteral("needs"));
    setAccessibleName(tr("Needs of the thrust"));
    QStringList cases;
    for (const ThrustCase which : thrustCases) cases << shortName(which);
    setHorizontalHeaderLabels(cases);
    for (const ThrustCase which : thrustCases)
        horizontalHeaderItem(static_cast<int>(which))->setToolTip(thrustCaseName(which));
    setVerticalHeaderLabels(
        {tr("need"), tr("margin"), tr("enough up to"), tr("gap at the blow"), tr("feed")});
    const QString meanings[] = {
        tr("From the thrust for full penetration to that which brings a bit that was at rest back before the "
           "next blow even if nothing damps"),
        tr("Effective force over what full penetration needs, less 1"),
        tr("Blow frequency at which the effective force is just what full penetration needs"),
        tr("How far the bit is off the rock when the hammer strikes, if nothing damps the rebound; with a "
           "damper the page \"Drilling\" follows it"),
        tr("What the effective force does between blows with this e")};
    for (int row = 0; row < rowsInAll; ++row) verticalHeaderItem(row)->setToolTip(meanings[row]);
    for (int row = 0; row < rowsInAll; ++row)
        for (int column = 0; column < columnCount(); ++column) {
            auto* cell = new QTableWidgetItem;
            cell->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
            setItem(row, column, cell);
        }
    setEditTriggers(NoEditTriggers);
    setTabKeyNavigation(false);
    horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);  // scrolled, never cut
    horizontalHeader()->setStretchLastSection(true);
    verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setWordWrap(false);
}

void ThrustTable::setText(int row, ThrustCase which, const QString& text, const QString& more) {
    QTableWidgetItem* cell = item(row, static_cast<int>(which));
    cell->setText(text);
    cell->setToolTip(more.isEmpty() ? text : text + QStringLiteral(" · ") + more);
}

void ThrustTable::present(const ThrustNeeds& needs, const ThrustUnits& units) {
    const QLocale locale;
    for (const ThrustCase which : thrustCases) {
        const ThrustNeed& need = needs[static_cast<std::size_t>(which)];
        setColumnHidden(static_cast<int>(which), !need.known);
        setText(bracket, which,
                QStringLiteral("%1 … %2").arg(numberText(need.thrust * units.force.factor, 4, locale),
                                              quantityText(need.thrustUndamped, units.force, locale)),
                QStringLiteral("e = ") + numberText(need.cor.value, 4, locale));
        setText(margin, which,
                need.margin ? withSign(*need.margin, percentText(*need.margin, 3, locale)) : QString());
        setText(
            limit, which,
            need.frequencyLimit ? quantityText(*need.frequencyLimit, units.frequency, locale) : QString());
        presentGap(which, need.gapAtBlow, units.length);
        setText(feed, which, coreText(feedWord(need.feed)));
    }
}

void ThrustTable::presentGap(ThrustCase which, const std::optional<GapAtBlow>& found, const ShownUnit& unit) {
    if (!found) return setText(gap, which, {});
    const bool hangs = found->motion.stable && found->gap > 0;
    setText(gap, which, gapText(*found, unit),
            hangs ? numberText(found->inD0, 3, QLocale()) + QStringLiteral(" d₀") : QString());
}

void ThrustTable::clearNumbers() {
    for (int row = 0; row < rowsInAll; ++row)
        for (const ThrustCase which : thrustCases) setText(row, which, {});
}

// All rows in view, whatever the font.
QSize ThrustTable::sizeHint() const {
    return {500, heightOf(verticalHeader()->length())};
}

QSize ThrustTable::minimumSizeHint() const {
    // The page scrolls before its table does, which scrolls to the side alone.
    return {200, sizeHint().height() + horizontalScrollBar()->sizeHint().height()};
}

int ThrustTable::heightOf(int contents) const {
    return horizontalHeader()->sizeHint().height() + contents + 2 * frameWidth();
}

}  // namespace drillwave
