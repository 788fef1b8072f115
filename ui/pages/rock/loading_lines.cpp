// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/rock/loading_lines.h"

#include <cmath>

#include "ui/plot/axis_rect.h"
#include "ui/text/number_text.h"

namespace drillwave {
namespace {

constexpr qsizetype mostNamedLines = 6;  // those of a power law are points of a curve

}  // namespace

double rotationAlong(const QPointF& from, const QPointF& to) {
    return std::atan2(to.y() - from.y(), to.x() - from.x()) * 180 / M_PI;
}

LoadingLines::LoadingLines(QCPAxisRect* rect) : QObject(rect->parentPlot()), m_rect(rect) {}

void LoadingLines::present(const QVector<RockLine>& lines, const QLocale& locale) {
    QCustomPlot& plot = *m_rect->parentPlot();
    for (QCPItemText* name : m_names) plot.removeItem(name);
    for (QCPItemTracer* corner : m_corners) plot.removeItem(corner);
    m_names.clear();
    m_corners.clear();
    m_lines = lines.mid(1);
    for (const RockLine& line : m_lines) {
        auto* corner = addItem<QCPItemTracer>(m_rect);
        corner->setStyle(QCPItemTracer::tsSquare);
        corner->setSize(5);
        corner->position->setCoords(line.from);
        m_corners.append(corner);
        if (m_lines.size() > mostNamedLines) continue;
        auto* name = addItem<QCPItemText>(m_rect);
        name->setPadding(QMargins(5, 2, 5, 2));
        name->setPositionAlignment(Qt::AlignHCenter | Qt::AlignBottom);
        name->setText(numberText(line.slope, 3, locale) + QChar(QChar::Nbsp) + QLatin1Char('k'));
        m_names.append(name);
    }
    setStyle(m_style);
}

void LoadingLines::place() {
    const auto pixel = [&](QPointF at) {
        return QPointF(m_rect->axis(QCPAxis::atBottom)->coordToPixel(at.x()),
                       m_rect->axis(QCPAxis::atLeft)->coordToPixel(at.y()));
    };
    for (qsizetype i = 0; i < m_names.size(); ++i) {
        const RockLine& line = m_lines[i];
        m_names[i]->position->setCoords((line.from + line.to) / 2);
        m_names[i]->setRotation(rotationAlong(pixel(line.from), pixel(line.to)));
    }
}

void LoadingLines::setStyle(const PlotStyle& style) {
    m_style = style;
    for (QCPItemText* name : m_names) {
        name->setFont(style.font);
        name->setColor(style.text);
    }
    for (QCPItemTracer* corner : m_corners) {
        corner->setPen(QPen(style.text, 1.2));
        corner->setBrush(style.background);
    }
}

QStringList LoadingLines::texts() const {
    QStringList texts;
    for (const QCPItemText* name : m_names) texts << name->text();
    return texts;
}

}  // namespace drillwave
