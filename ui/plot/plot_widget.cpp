// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/plot_widget.h"

#include <QClipboard>
#include <QEvent>
#include <QGuiApplication>
#include <QMetaMethod>
#include <QMimeData>
#include <QWindow>
#include <limits>

#include "ui/plot/axis_view.h"
#include "ui/plot/cursor_bar.h"
#include "ui/plot/legend_entries.h"
#include "ui/text/number_text.h"

namespace drillwave {

PlotWidget::PlotWidget(QWidget* parent)
    : QCustomPlot(parent), m_cursors(*this), m_hover(*this), m_history(*this), m_bar(new CursorBar(this)) {
    // Antialiased lines of two pixels are drawn an order of magnitude faster this way.
    setPlottingHint(QCP::phFastPolylines, true);
    setFocusPolicy(Qt::StrongFocus);
    m_bar->hide();
    connect(this, &QCustomPlot::beforeReplot, this, &PlotWidget::prepareReplot);
    connect(this, &QCustomPlot::afterReplot, this, &PlotWidget::readCursors);
    connect(selectionRect(), &QCPSelectionRect::accepted, this, &PlotWidget::zoomToBox);
    connect(m_bar, &CursorBar::curveChosen, this, &PlotWidget::setReadGraph);
    connect(m_bar, &CursorBar::closed, this, [this] {
        placeCursor(PlotCursor::a, {});
        placeCursor(PlotCursor::b, {});
        setFocus();
    });
}

// The curves die with the base class, after the meanings they would take along.
PlotWidget::~PlotWidget() {
    for (const QCPAbstractPlottable* curve : m_meanings.keys()) disconnect(curve, nullptr, this, nullptr);
}

void PlotWidget::followPalette(Restyle restyle) {
    m_restyle = std::move(restyle);
    applyStyle(PlotStyle::forScreen(palette(), font()));
}

void PlotWidget::restyle() {
    if (!m_restyle) return;
    applyStyle(PlotStyle::forScreen(palette(), font()));
    replot(rpQueuedReplot);
}

void PlotWidget::applyStyle(const PlotStyle& style) {
    if (m_restyle) m_restyle(style);
    m_cursors.setStyle(style);
    m_hover.setStyle(style);
    QColor band = style.lines[0];
    selectionRect()->setPen(QPen(band, 1, Qt::DashLine));
    band.setAlpha(40);
    selectionRect()->setBrush(band);
}

void PlotWidget::changeEvent(QEvent* event) {
    QCustomPlot::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) restyle();
}

// QCustomPlot does not notice by itself that its window has moved to a screen of another density.
void PlotWidget::showEvent(QShowEvent* event) {
    QCustomPlot::showEvent(event);
    if (QWindow* window = this->window()->windowHandle())
        connect(window, &QWindow::screenChanged, this, &PlotWidget::followScreen, Qt::UniqueConnection);
    followScreen();
}

void PlotWidget::followScreen() {
    if (bufferDevicePixelRatio() == devicePixelRatioF()) return;
    setBufferDevicePixelRatio(devicePixelRatioF());
    replot(rpQueuedReplot);
}

void PlotWidget::prepareReplot() {
    markHiddenCurves(*this);
    for (const QCPAxisRect* rect : axisRects())
        for (QCPAxis* axis : rect->axes())
            if (axis->visible() && axis->tickLabels()) setTickDigits(*axis);
}

// The bar takes its height from the plot, as much as its words need at this width.
void PlotWidget::placeBar() {
    const bool shown = cursorPosition(PlotCursor::a) || cursorPosition(PlotCursor::b);
    const int wanted =
        m_bar->hasHeightForWidth() ? m_bar->heightForWidth(width()) : m_bar->sizeHint().height();
    // It grows for longer words but does not shrink for shorter ones: a drag shall not shake the curves.
    const int present = m_bar->isVisibleTo(this) && m_bar->width() == width() ? m_bar->height() : 0;
    const int barHeight = shown ? std::min(std::max(wanted, present), height() / 3) : 0;
    m_bar->setVisible(shown);
    m_bar->setGeometry(0, height() - barHeight, width(), barHeight);
    const QRect plotArea(0, 0, width(), height() - barHeight);
    if (viewport() == plotArea) return;
    setViewport(plotArea);
    replot(rpQueuedReplot);
}

void PlotWidget::resizeEvent(QResizeEvent* event) {
    QCustomPlot::resizeEvent(event);
    placeBar();
}

void PlotWidget::replotOverlay() {
    layer(QStringLiteral("overlay"))->replot();
}

void PlotWidget::setMeaning(const QCPAbstractPlottable* curve, CurveMeaning meaning) {
    if (!m_meanings.contains(curve))
        connect(curve, &QObject::destroyed, this, [this, curve] { m_meanings.remove(curve); });
    m_meanings.insert(curve, std::move(meaning));
}

void PlotWidget::placeCursor(PlotCursor cursor, std::optional<double> x) {
    if (cursorPosition(cursor) == x) return;
    m_cursors.place(cursor, x);
    if (cursor != PlotCursor::time) readCursors();
    replotOverlay();
}

QCPGraph* PlotWidget::readGraph() const {
    if (m_readGraph && m_readGraph->realVisibility()) return m_readGraph;
    for (QCPAbstractPlottable* curve : visibleCurves(*this))
        if (auto* graph = qobject_cast<QCPGraph*>(curve)) return graph;
    return nullptr;
}

void PlotWidget::setReadGraph(QCPGraph* graph) {
    m_readGraph = graph;
    readCursors();
}

std::optional<CursorReading> PlotWidget::cursorReading() const {
    const std::optional<double> a = cursorPosition(PlotCursor::a);
    const std::optional<double> b = cursorPosition(PlotCursor::b);
    const QCPGraph* graph = readGraph();
    if (!a || !b || !graph) return std::nullopt;
    return readCurve(*graph->data(), m_meanings.value(graph), *a, *b);
}

void PlotWidget::readCursors() {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    const std::optional<double> a = cursorPosition(PlotCursor::a);
    const std::optional<double> b = cursorPosition(PlotCursor::b);
    if (a || b) {
        QList<QCPGraph*> graphs;
        for (QCPAbstractPlottable* curve : visibleCurves(*this))
            if (auto* graph = qobject_cast<QCPGraph*>(curve)) graphs.append(graph);
        const QCPGraph* graph = readGraph();
        m_bar->setCurves(graphs, graph);
        const CurveMeaning meaning = m_meanings.value(graph);
        CursorReading reading{a.value_or(none), b.value_or(none), none, none, none, none, none};
        if (graph) {
            const CursorReading read =
                readCurve(*graph->data(), meaning, a.value_or(b.value_or(0)), b.value_or(a.value_or(0)));
            reading = read;
            reading.a = a.value_or(none);
            reading.b = b.value_or(none);
        }
        m_bar->setText(readingText(reading, meaning, locale()));
    }
    placeBar();
    emit cursorsRead();
}

QString PlotWidget::cursorText() const {
    return m_bar->isVisibleTo(this) ? m_bar->text() : QString();
}

QString PlotWidget::pointText(const CurvePoint& point) const {
    const CurveMeaning meaning = m_meanings.value(point.curve);
    const QString gap{QChar(QChar::Nbsp)};
    const auto quantity = [&](double value, const QString& unit) {
        const QString number = numberText(value, 6, locale());
        return unit.isEmpty() ? number : number + gap + unit;
    };
    return point.curve->name() + QLatin1Char('\n') + QStringLiteral("x = ") +
           quantity(point.x, meaning.xUnit) + QStringLiteral("\ny = ") + quantity(point.y, meaning.yUnit);
}

void PlotWidget::setCurveVisible(QCPAbstractPlottable* curve, bool visible) {
    curve->setVisible(visible);
    replot(rpQueuedReplot);
}

void PlotWidget::setAxisScale(QCPAxis* axis, QCPAxis::ScaleType scale) {
    m_history.remember();
    QList<QCPAxis*> axes{axis};
    const QList<QCPAxisRect*> stacked = m_cursors.rects();
    if (axis->orientation() == Qt::Horizontal && stacked.contains(axis->axisRect())) {
        axes.clear();
        for (const QCPAxisRect* rect : stacked) axes.append(rect->axis(axis->axisType()));
    }
    for (QCPAxis* changed : axes) setScale(*changed, scale);
    if (scale == QCPAxis::stLinear) emit fitRequested();
    replot(rpQueuedReplot);
}

void PlotWidget::fit() {
    m_history.remember();
    emit fitRequested();
    for (const QCPAxisRect* rect : axisRects())
        for (const auto type : {QCPAxis::atBottom, QCPAxis::atLeft})
            if (QCPAxis* axis = rect->axis(type)) fitLogarithmic(*axis);
    replot(rpQueuedReplot);
}

void PlotWidget::zoomBack() {
    m_history.goBack();
    replot(rpQueuedReplot);
}

QByteArray PlotWidget::drawing(const QString& format, Millimetres size, double dpi, const QString& title) {
    const QLocale shown = locale();
    const bool hadLocale = testAttribute(Qt::WA_SetLocale);
    setLocale(QLocale::c());
    m_hover.show(std::nullopt, {});
    applyStyle(PlotStyle::forPaper());
    const QByteArray bytes = [&] {
        const WithoutHiddenEntries legends(*this);
        return renderPlot(*this, size, format, title, dpi);
    }();
    if (hadLocale)
        setLocale(shown);
    else
        unsetLocale();
    applyStyle(PlotStyle::forScreen(palette(), font()));
    // The layout is that of the picture until then.
    replot();
    return bytes;
}

Millimetres PlotWidget::sizeOnPaper() const {
    constexpr double millimetresPerPixel = 25.4 / 96;
    return {viewport().width() * millimetresPerPixel, viewport().height() * millimetresPerPixel};
}

void PlotWidget::copyPicture() {
    auto* content = new QMimeData;
    content->setImageData(QImage::fromData(drawing(QStringLiteral("png"), sizeOnPaper())));
    content->setData(QStringLiteral("image/svg+xml"), drawing(QStringLiteral("svg"), sizeOnPaper()));
    QGuiApplication::clipboard()->setMimeData(content);
}

QByteArray PlotWidget::dataText(char separator) const {
    return m_dataText ? m_dataText(separator) : plotCsv(*this, m_meanings, separator);
}

void PlotWidget::copyData() {
    auto* content = new QMimeData;
    content->setText(QString::fromUtf8(dataText('\t')));
    content->setData(QStringLiteral("text/csv"), csv());
    QGuiApplication::clipboard()->setMimeData(content);
}

bool PlotWidget::offersTime() const {
    return isSignalConnected(QMetaMethod::fromSignal(&PlotWidget::timeCursorDragged));
}

}  // namespace drillwave
