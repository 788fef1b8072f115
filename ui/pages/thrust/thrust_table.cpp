// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/thrust/thrust_table.h"

#include <QHeaderView>
#include <QScrollBar>
#include <cmath>

#include "core/report/feed_words.h"
#include "ui/text/number_text.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

enum Row { required, returnInTime, margin, limit, rowsInAll };

// The columns are narrow.
QString shortName(ThrustCase which) {
    switch (which) {
        case ThrustCase::gapQuantile:
            return ThrustTable::tr("95 % of gaps");
        case ThrustCase::elasticWorst:
            return ThrustTable::tr("worst gap");
        default:
            return coreText(labelOf(which));
    }
}

}  // namespace

ThrustTable::ThrustTable(QWidget* parent) : QTableWidget(rowsInAll, int(thrustCaseCount), parent) {
    setObjectName(QStringLiteral("needs"));
    setAccessibleName(tr("Required feed"));
    QStringList cases;
    for (const ThrustCase which : thrustCases) cases << shortName(which);
    setHorizontalHeaderLabels(cases);
    for (const ThrustCase which : thrustCases)
        horizontalHeaderItem(static_cast<int>(which))->setToolTip(coreText(labelOf(which)));
    setVerticalHeaderLabels({tr("required"), tr("return in time"), tr("margin"), tr("covered up to")});
    const QString meanings[] = {
        tr("Mean force that balances a blow which starts at rest on the rock"),
        tr("At this feed an undamped rigid rod is back at the rock before the next blow"),
        tr("Effective feed force over the required one, less 1"),
        tr("Up to this blow frequency the effective feed force covers the required one")};
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

void ThrustTable::present(const FeedEstimate& feed, const ThrustUnits& units) {
    const QLocale locale;
    for (const ThrustCase which : thrustCases) {
        const ThrustNeed& need = feed.need(which);
        setColumnHidden(static_cast<int>(which), !need.known);
        const QString rebound = QStringLiteral("e = ") + numberText(need.cor.value, 4, locale);
        setText(required, which, quantityText(need.thrust, units.force, locale), rebound);
        setText(returnInTime, which, quantityText(need.thrustUndamped, units.force, locale), rebound);
        setText(margin, which,
                need.margin ? withSign(*need.margin, percentText(*need.margin, 3, locale)) : QString());
        setText(
            limit, which,
            need.frequencyLimit ? quantityText(*need.frequencyLimit, units.frequency, locale) : QString());
    }
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
