// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/study_frame.h"

namespace drillwave {

StudyFrame::StudyFrame(QCustomPlot* plot)
    : QObject(plot), m_plot(plot), m_view(new FittedView(this)), m_message(new PlotMessage(plot)) {}

void StudyFrame::showNothing(const QString& message) {
    if (m_here) m_here->setPlace({}, {});
    if (m_runMarks) m_runMarks->present({});
    if (m_runCurves) m_runCurves->present({});
    if (m_caption) m_caption->setText({});
    clear();
    m_message->show(message);
    m_summary = message;
}

void StudyFrame::setRuns(const QVector<RunMark>& marks, const QVector<RunCurve>& curves) {
    const bool isOther = m_runMarks->present(marks);
    if (m_runCurves) {
        m_runCurves->present(curves);
        fitUnlessZoomed();
    }
    if (isOther) m_plot->replot(QCustomPlot::rpQueuedReplot);
}

void StudyFrame::setStyle(const PlotStyle& style) {
    m_style = style;
    m_message->setStyle(style);
    m_plot->setBackground(style.background);
    for (QCPAxisRect* rect : m_plot->axisRects()) style.applyTo(*rect);
    if (m_legend) style.applyTo(*m_legend);
    if (m_caption) style.applyTo(*m_caption);
    m_texts.removeIf([](const QPointer<QCPItemText>& text) { return text.isNull(); });
    for (const QPointer<QCPItemText>& text : std::as_const(m_texts)) {
        text->setFont(style.font);
        text->setColor(style.text);
    }
    if (m_here) m_here->setStyle(style);
    if (m_runCurves) m_runCurves->setStyle(style);
    if (m_runMarks) m_runMarks->setStyle(style);
    restyle();
}

void StudyFrame::fit() {
    m_view->fit([this] { setRanges(); });
}

void StudyFrame::fitUnlessZoomed() {
    if (m_view->isFitted()) fit();
}

void StudyFrame::layOutAnew() {
    m_plot->setAutoAddPlottableToLegend(false);
    m_plot->plotLayout()->clear();
    m_plot->plotLayout()->setRowSpacing(0);
}

void StudyFrame::view(QCPAxisRect* rect) {
    m_rect = rect;
    m_view->watch(x());
    m_view->watch(y());
}

// As high as it has to be.
void StudyFrame::insertAbove(QCPLayoutElement* element) {
    m_plot->plotLayout()->insertRow(0);
    m_plot->plotLayout()->addElement(0, 0, element);
    m_plot->plotLayout()->setRowStretchFactor(0, 1e-3);
}

void StudyFrame::useLegend(const QMargins& margins) {
    m_legend = m_plot->legend ? m_plot->legend : new QCPLegend;
    m_legend->setVisible(true);
    m_legend->setMargins(margins);
    m_legend->setFillOrder(QCPLayoutGrid::foColumnsFirst);
}

QCPLayoutGrid* StudyFrame::addHeader(int spaceBelow) {
    auto* header = new QCPLayoutGrid;
    header->setMaximumSize(QWIDGETSIZE_MAX - 1, QWIDGETSIZE_MAX);  // a legend without entries has no width
    header->setRowSpacing(0);
    insertAbove(header);
    useLegend(QMargins(7, 6, 0, 0));
    m_caption = new QCPTextElement(m_plot);
    m_caption->setTextFlags(Qt::AlignLeft | Qt::AlignVCenter);
    m_caption->setMargins(QMargins(7, 0, 0, spaceBelow));
    header->addElement(0, 0, m_legend);
    header->addElement(1, 0, m_caption);
    if (!m_legend->layer()) m_legend->setLayer(QStringLiteral("legend"));
    return header;
}

void StudyFrame::addHere(HereMark* mark) {
    m_here = mark ? mark : new HereMark(m_plot, x(), y());
}

void StudyFrame::addRunMarks() {
    m_runMarks = new RunMarks(m_plot, x(), y());
}

void StudyFrame::addRunCurves(double width) {
    m_runCurves = new RunGraphs(x(), y(), m_legend, width);
}

QCPItemText* StudyFrame::addText(QCPAxisRect* rect, const QMargins& padding, Qt::Alignment alignment) {
    auto* text = addItem<QCPItemText>(rect);
    text->setPadding(padding);
    text->setPositionAlignment(alignment);
    m_texts.append(text);
    return text;
}

void StudyFrame::finish(bool hasOtherAxes) {
    m_message->hide();
    if (m_view->isFitted() || hasOtherAxes) fit();
}

}  // namespace drillwave
