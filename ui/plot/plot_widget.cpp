// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/plot_widget.h"

#include <QClipboard>
#include <QContextMenuEvent>
#include <QGuiApplication>
#include <QMetaMethod>
#include <QMimeData>
#include <QPainter>
#include <QWindow>

#include "ui/plot/axis_view.h"
#include "ui/plot/legend_entries.h"
#include "ui/plot/overlay.h"
#include "ui/plot/plot_keys.h"
#include "ui/plot/plot_menu.h"
#include "ui/text/language.h"

namespace drillwave {

PlotWidget::PlotWidget(QWidget* parent)
    : QCustomPlot(parent),
      m_reader(*this, m_meanings),
      m_hover(*this),
      m_view(*this),
      m_mover(*this),
      m_mouse(*this),
      m_point(new KeyPoint(*this)),
      m_keys(new PlotKeys(*this)) {
    // Antialiased lines of two pixels are drawn an order of magnitude faster this way.
    setPlottingHint(QCP::phFastPolylines, true);
    // A plot that repaints itself at once paints all of the window that waits for it along, once for each
    // plot.
    setPlottingHint(QCP::phImmediateRefresh, false);
    setFocusPolicy(Qt::StrongFocus);
    setAttribute(Qt::WA_NoMousePropagation, false);  // the page scrolls by the wheel over it
    connect(this, &QCustomPlot::beforeReplot, this, &PlotWidget::prepareReplot);
    connect(this, &QCustomPlot::afterLayout, this, &PlotWidget::followSizes);
    connect(this, &QCustomPlot::afterReplot, this, &PlotWidget::restoreLabels);
    connect(selectionRect(), &QCPSelectionRect::accepted, this,
            [this](const QRect& box) { m_view.zoomTo(box); });
    connect(&m_reader, &CurveReader::closed, this, [this] { setFocus(); });
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
    restoreLabels();
    if (m_restyle) m_restyle(style);
    m_reader.setStyle(style);
    m_hover.setStyle(style);
    m_point->setStyle(style);
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

// Sizes are known after the layout, of which ticks are a part: the next one has them.
void PlotWidget::followSizes() {
    bool isOther = false;
    for (const QCPAxisRect* rect : axisRects())
        for (QCPAxis* axis : rect->axes())
            if (axis->visible() && axis->tickLabels()) isOther |= setTickCount(*axis);
    isOther |= fitLabels();
    if (isOther) replot(rpQueuedReplot);
}

QList<QCPAxis*> PlotWidget::labelledAxes() const {
    QList<QCPAxis*> axes;
    for (const QCPAxisRect* rect : axisRects()) axes += rect->axes();
    for (QCPLayoutElement* element : plotLayout()->elements(true))
        if (auto* scale = qobject_cast<QCPColorScale*>(element)) axes.append(scale->axis());
    return axes;
}

namespace {

QFont scaled(QFont font, double scale) {
    font.setPixelSize(qRound(scale * QFontInfo(font).pixelSize()));
    return font;
}

}  // namespace

// The axes have smaller letters, two lines or shortened labels only while they are drawn: others read the
// whole ones. Returns true if an axis needs other room for its label, which the next layout gives.
bool PlotWidget::fitLabels() {
    constexpr QLatin1Char lineEnd('\n');
    restoreLabels();  // a picture without replot() leaves them
    bool isOther = false;
    for (QCPAxis* axis : labelledAxes()) {
        const QString label = axis->label();
        const QFont font = axis->labelFont();
        QString fitting = axis->visible() ? labelThatFits(*axis) : label;
        for (const double scale : {0.9, 0.8, 1.0}) {  // smaller letters if they avoid an ellipsis
            if (fitting.size() == label.size()) break;
            axis->setLabelFont(scaled(font, scale));
            fitting = labelThatFits(*axis);
        }
        isOther |= reserveSecondLine(*axis, fitting.count(lineEnd) > label.count(lineEnd));
        if (fitting == label && axis->labelFont() == font) continue;
        m_fittedLabels.insert(axis, {label, fitting, font});
        axis->setLabel(fitting);
        axis->setLabelPadding(axis->labelPadding() - secondLine(*axis));
    }
    return isOther;
}

void PlotWidget::restoreLabels() {
    for (const auto& [axis, label] : m_fittedLabels.asKeyValueRange()) {
        if (axis->label() == label.fitting) axis->setLabel(label.whole);
        axis->setLabelFont(label.font);
        axis->setLabelPadding(axis->labelPadding() + secondLine(*axis));
    }
    m_fittedLabels.clear();
}

void PlotWidget::resizeEvent(QResizeEvent* event) {
    QCustomPlot::resizeEvent(event);
    m_reader.placeBar();
}

void PlotWidget::setMeaning(const QCPAbstractPlottable* curve, const CurveMeaning& meaning) {
    if (!m_meanings.contains(curve))
        connect(curve, &QObject::destroyed, this, [this, curve] { m_meanings.remove(curve); });
    m_meanings.insert(curve, meaning);
}

void PlotWidget::markPoint(const std::optional<CurvePoint>& point) {
    if (point)
        m_hover.show(*point->curve->keyAxis()->axisRect(), point->pixel, words(*point));
    else if (!m_hover.hide())
        return;
    redrawOverlay(*this);
}

QString PlotWidget::words(const CurvePoint& point) const {
    return pointText(point, m_meanings.value(point.curve), locale());
}

void PlotWidget::setCurveVisible(QCPAbstractPlottable* curve, bool visible) {
    curve->setVisible(visible);
    replot(rpQueuedReplot);
}

void PlotWidget::setAxisScale(QCPAxis* axis, QCPAxis::ScaleType scale) {
    m_view.setScale(axis, scale, m_reader.cursors().rects());
    if (scale == QCPAxis::stLinear) emit fitRequested();
    replot(rpQueuedReplot);
}

void PlotWidget::setCurrent(bool current) {
    m_current = current;
    m_reader.setCurrent(current);
}

void PlotWidget::fit() {
    m_view.remember();
    emit fitRequested();
    m_view.fitLogarithms();
    replot(rpQueuedReplot);
}

QByteArray PlotWidget::drawing(const QString& format, Millimetres size, double dpi, const QString& title) {
    const QLocale shown = locale();
    const bool hadLocale = testAttribute(Qt::WA_SetLocale);
    setLocale(QLocale::c());
    // The ticks are those on show, whatever the size on paper.
    disconnect(this, &QCustomPlot::afterLayout, this, &PlotWidget::followSizes);
    restoreLabels();
    for (QCPAxis* axis : labelledAxes()) reserveSecondLine(*axis, false);
    m_hover.hide();
    const bool wasHidden = m_point->isHidden();
    m_point->setHidden(true);
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
    m_point->setHidden(wasHidden);
    // The layout is that of the picture until then.
    replot();
    connect(this, &QCustomPlot::afterLayout, this, &PlotWidget::followSizes);
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
    const auto text = [&] {
        const EnglishTexts english;
        if (m_name) m_name();
        return m_dataText ? m_dataText(separator) : plotCsv(*this, m_meanings, separator);
    }();
    if (m_name) m_name();
    return text;
}

bool PlotWidget::hasData() const {
    return m_dataText || !visibleCurves(*this).isEmpty();
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

void PlotWidget::openMenu(std::optional<QPoint> at) {
    const QCPAxisRect* used = m_view.activeRect();
    const QPoint point = at ? *at : used ? used->center() : rect().center();
    (new PlotMenu(*this, point))->popup(mapToGlobal(point));
}

void PlotWidget::contextMenuEvent(QContextMenuEvent* event) {
    event->accept();
    // The right button opens it on release, when it has not drawn a box.
    if (event->reason() != QContextMenuEvent::Mouse) openMenu();
}

// Without Ctrl it scrolls the parent of the plot.
void PlotWidget::wheelEvent(QWheelEvent* event) {
    if (!(event->modifiers() & Qt::ControlModifier)) return event->ignore();
    emit mouseWheel(event);
    event->accept();
    m_mouse.wheel(*event);
}

void PlotWidget::mousePressEvent(QMouseEvent* event) {
    m_mouse.beforePress(*event);
    QCustomPlot::mousePressEvent(event);
    m_mouse.press(*event);
}

void PlotWidget::mouseMoveEvent(QMouseEvent* event) {
    QCustomPlot::mouseMoveEvent(event);
    m_mouse.move(*event);
}

void PlotWidget::mouseReleaseEvent(QMouseEvent* event) {
    QCustomPlot::mouseReleaseEvent(event);
    m_mouse.release(*event);
}

void PlotWidget::mouseDoubleClickEvent(QMouseEvent* event) {
    QCustomPlot::mouseDoubleClickEvent(event);
    m_mouse.doubleClick(*event);
}

void PlotWidget::enterEvent(QEnterEvent* event) {
    QCustomPlot::enterEvent(event);
    m_keys->followPointer(true);
}

void PlotWidget::leaveEvent(QEvent* event) {
    QCustomPlot::leaveEvent(event);
    m_keys->followPointer(false);
    markPoint(std::nullopt);
}

void PlotWidget::keyPressEvent(QKeyEvent* event) {
    if (!m_keys->press(*event)) QCustomPlot::keyPressEvent(event);
}

void PlotWidget::focusInEvent(QFocusEvent* event) {
    QCustomPlot::focusInEvent(event);
    m_point->setHidden(false);
    update();
}

void PlotWidget::focusOutEvent(QFocusEvent* event) {
    QCustomPlot::focusOutEvent(event);
    m_point->setHidden(true);
    update();
}

void PlotWidget::paintEvent(QPaintEvent* event) {
    QCustomPlot::paintEvent(event);
    if (!hasFocus()) return;
    QPainter painter(this);
    painter.setPen(QPen(palette().color(QPalette::Highlight), 2));
    painter.drawRect(viewport().adjusted(1, 1, -1, -1));
}

}  // namespace drillwave
