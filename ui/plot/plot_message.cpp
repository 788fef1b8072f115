// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/plot_message.h"

#include <algorithm>

namespace drillwave {
namespace {

constexpr double shareOfWidth = 0.8;
constexpr int padding = 10;

}  // namespace

PlotMessage::PlotMessage(QCustomPlot* plot) : QObject(plot), m_plot(plot), m_item(new QCPItemText(plot)) {
    m_item->setLayer(QStringLiteral("overlay"));
    m_item->setClipToAxisRect(false);
    m_item->setSelectable(false);
    m_item->setPadding(QMargins(padding, padding, padding, padding));
    m_item->position->setType(QCPItemPosition::ptViewportRatio);
    m_item->position->setCoords(0.5, 0.4);
    m_item->setVisible(false);
    connect(plot, &QCustomPlot::beforeReplot, this, &PlotMessage::breakLines);
}

void PlotMessage::show(const QString& text) {
    m_text = text;
    m_item->setVisible(true);
    breakLines();
}

void PlotMessage::setStyle(const PlotStyle& style) {
    m_item->setFont(style.font);
    m_item->setColor(style.text);
    m_item->setBrush(style.background);
    m_item->setPen(QPen(style.text, 1));
}

void PlotMessage::breakLines() {
    if (!m_item->visible()) return;
    const QFontMetrics metrics(m_item->font());
    const int room = std::max(1, int(shareOfWidth * m_plot->viewport().width()) - 2 * padding);
    QString broken, line;
    for (const QString& word : m_text.split(QLatin1Char(' '))) {
        const QString longer = line.isEmpty() ? word : line + QLatin1Char(' ') + word;
        if (!line.isEmpty() && metrics.horizontalAdvance(longer) > room) {
            broken += line + QLatin1Char('\n');
            line = word;
        } else {
            line = longer;
        }
    }
    m_item->setText(broken + line);
}

}  // namespace drillwave
