// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/wave_picture/wave_picture_plot.h"

#include <QTimer>
#include <algorithm>
#include <cmath>

#include "ui/pages/wave_picture/wave_picture_csv.h"
#include "ui/text/number_text.h"

namespace drillwave {
namespace {

QString fieldWords(WaveQuantity field) {
    return field == WaveQuantity::force
               ? WavePicturePlot::tr("force N (tension positive)")
               : WavePicturePlot::tr("particle velocity v (towards the rock positive)");
}

}  // namespace

WavePicturePlot::WavePicturePlot(QCustomPlot* plot) : StudyFrame(plot), m_bar(new QCPColorScale(plot)) {
    plot->setAutoAddPlottableToLegend(false);
    QCPAxisRect* rect = plot->axisRect();
    view(rect);
    rect->setupFullAxesBox(true);
    rect->setMinimumMargins(QMargins(64, 10, ContactBarsItem::width, 4));
    for (QCPAxis* axis : rect->axes()) axis->grid()->setVisible(false);
    m_bar->setType(QCPAxis::atRight);
    m_bar->setBarWidth(14);
    m_bar->setRangeDrag(false);
    m_bar->setRangeZoom(false);
    auto* margins = new QCPMarginGroup(plot);
    rect->setMarginGroup(QCP::msTop | QCP::msBottom, margins);
    m_bar->setMarginGroup(QCP::msTop | QCP::msBottom, margins);
    plot->plotLayout()->addElement(0, 1, m_bar);
    addItems();
    setStyle(PlotStyle::forPaper());
    followAxes();
}

void WavePicturePlot::addItems() {
    m_waves = new WaveFieldItem(m_plot);
    m_waves->setLayer(QStringLiteral("background"));
    m_fronts = new WaveFrontsItem(m_plot);
    m_joints = new JointMarksItem(m_plot);  // names over the fronts
    m_contacts = new ContactBarsItem(m_plot);
    m_marks = new ScaleMarksItem(m_plot, m_bar);
}

void WavePicturePlot::followAxes() {
    m_view->setEmpty(true);
    connect(m_view, &FittedView::chosen, this, &WavePicturePlot::takeRanges);
    // Drawing for a file lays out for another size and back again: need() is checked after that.
    connect(m_plot, &QCustomPlot::afterLayout, this, [this] {
        if (!std::exchange(m_checking, true)) QTimer::singleShot(0, this, &WavePicturePlot::checkNeed);
    });
}

void WavePicturePlot::checkNeed() {
    m_checking = false;
    if (!m_blow) return;
    const WavePictureNeed now = need();
    if (now == picture()->need || now == m_announced) return;
    m_announced = now;
    emit needChanged();
}

WavePictureNeed WavePicturePlot::need() const {
    const QSize size = m_rect->size();
    const double ratio = m_plot->bufferDevicePixelRatio();
    const auto pixels = [ratio](int length) {
        return std::max(1, static_cast<int>(std::lround(length * ratio)));
    };
    WavePictureNeed need{m_field, {}, pixels(size.width()), pixels(size.height())};
    if (!m_view->isFitted()) need.window = m_window;
    return need;
}

void WavePicturePlot::present(const SolvedBlowPtr& blow) {
    // Rods and strings have another axis: what was in view of the one is nothing of the other.
    const bool isOther = m_blow && !m_blow->impact.waves != !blow->impact.waves;
    m_blow = blow;
    m_view->setEmpty(false);
    if (blow->page<WavePicture>()->need == m_announced) m_announced.reset();
    for (WavePictureItem* item : items()) item->setBlow(blow);
    m_bar->setVisible(true);
    finish(isOther);
    if (!m_view->isFitted()) showWindow();
    name();
    summarize();
}

void WavePicturePlot::clear() {
    m_blow.reset();
    m_view->setEmpty(true);
    for (WavePictureItem* item : items()) item->setBlow(nullptr);
    m_bar->setVisible(false);
}

// Views are kept dimensionless: units may change below them.
void WavePicturePlot::showWindow() {
    const PictureUnits& units = picture()->units;
    m_view->adjust([&] {
        x()->setRange(m_window.xiBegin * units.position.factor, m_window.xiEnd * units.position.factor);
        y()->setRange(m_window.time.begin * units.time.factor, m_window.time.end * units.time.factor);
    });
    emit viewChanged();
}

void WavePicturePlot::takeRanges() {
    const PictureUnits& units = picture()->units;
    const double rear = picture()->rear;
    const QCPRange place = x()->range().bounded(rear * units.position.factor, units.position.factor);
    const QCPRange time = y()->range();
    m_window = {std::max(rear, place.lower / units.position.factor),
                std::min(1.0, place.upper / units.position.factor),
                {time.lower / units.time.factor, time.upper / units.time.factor}};
    showWindow();
}

void WavePicturePlot::setField(WaveQuantity field) {
    if (m_field == field) return;
    m_field = field;
    checkNeed();
}

void WavePicturePlot::setFrontsShown(bool shown) {
    m_fronts->setVisible(shown);
}

void WavePicturePlot::name() {
    if (!m_blow) return;
    const WavePicture& picture = *this->picture();
    const ShownUnit& unit = picture.units.of(picture.raster.quantity);
    x()->setLabel(picture.units.position.axisLabel(picture.string
                                                       ? tr("position x from the struck end, hammer at x < 0")
                                                       : tr("position x from the struck end")));
    y()->setLabel(picture.units.time.axisLabel(tr("time t")));
    m_bar->setDataRange({-picture.limit * unit.factor, picture.limit * unit.factor});
    m_bar->setLabel(unit.axisLabel(fieldWords(picture.raster.quantity)));
}

QByteArray WavePicturePlot::csv(char separator) const {
    if (!m_blow) return {};
    return wavePictureCsv(*m_blow, picture()->raster.quantity, m_window,
                          {x()->label(), y()->label(), m_bar->label()}, separator);
}

void WavePicturePlot::restyle() {
    QCPAxisRect* bar = m_bar->axis()->axisRect();
    m_style.applyTo(*bar);
    for (QCPAxis* axis : m_rect->axes() + bar->axes()) {
        // Outside: inside they would be lost in the colours.
        axis->setTickLength(0, axis->tickLabels() ? 4 : 0);
        axis->setSubTickLength(0, axis->tickLabels() ? 2 : 0);
    }
    m_bar->setGradient(ColourScale::forBackground(m_style.background).gradient());
    for (WavePictureItem* item : items()) item->setStyle(m_style);
}

void WavePicturePlot::setRanges() {
    if (!m_blow) return;
    m_window = picture()->whole();
    showWindow();
}

QString WavePicturePlot::readout(const QPointF& pixel) const {
    if (!m_blow || !m_rect->rect().contains(pixel.toPoint())) return {};
    const WavePicture& picture = *this->picture();
    const PictureUnits& units = picture.units;
    const double xi = x()->pixelToCoord(pixel.x()) / units.position.factor;
    const double t = y()->pixelToCoord(pixel.y()) / units.time.factor;
    if (picture.string) return stringReadout(xi, t);
    const WaveQuantity field = picture.raster.quantity;
    const QLocale locale = m_plot->locale();
    return tr("x = %1 · t = %2 · %3 = %4")
        .arg(quantityText(xi, units.position, locale), timeText(t, m_window.time, units.time, locale),
             field == WaveQuantity::force ? QStringLiteral("N") : QStringLiteral("v"),
             quantityText(waveValue(m_blow->impact, field, xi, t), units.of(field), locale));
}

QString WavePicturePlot::stringReadout(double x, double t) const {
    const PictureUnits& units = picture()->units;
    const StringPicture& string = *picture()->string;
    const QLocale locale = m_plot->locale();
    const auto text = [&](double value, const ShownUnit& unit) { return quantityText(value, unit, locale); };
    const RodStretch& section = string.rod.stretches[string.rod.sectionAt(x)];
    const QString place = tr("%1 into %2 · t = %3")
                              .arg(text(x - section.rear, units.position), section.words,
                                   timeText(t, m_window.time, units.time, locale));
    const BlowWaves waves(*m_blow);
    const double force = waves.value(WaveQuantity::force, x, t);
    if (!std::isfinite(force)) return place + tr(" · after the computed time");
    return place + tr(" · N = %1 · σ = %2 · v = %3")
                       .arg(text(force, units.force),
                            text(stressOf(section, force, section.shareAt(x)), units.stress),
                            text(waves.value(WaveQuantity::velocity, x, t), units.velocity));
}

QString WavePicturePlot::rangeText() const {
    if (!m_blow) return {};
    const WavePicture& picture = *this->picture();
    const ShownUnit& unit = picture.units.of(picture.raster.quantity);
    const QLocale locale = m_plot->locale();
    const QString name =
        picture.raster.quantity == WaveQuantity::force ? QStringLiteral("N") : QStringLiteral("v");
    const QString range = tr("%1 in this view: from %2 to %3")
                              .arg(name, quantityText(double(picture.least), unit, locale),
                                   quantityText(double(picture.largest), unit, locale));
    if (!isClippedBelow(picture) && !isClippedAbove(picture)) return range;
    return range + tr(" · colours end at ±%1").arg(quantityText(picture.limit, unit, locale));
}

QString WavePicturePlot::frontsText() const {
    if (!m_blow || !frontsShown()) return {};
    return picture()->string ? tr("fronts: — start, - - end of a wave")
                             : tr("fronts: — start, - - end of a wave; p towards the bit, n back");
}

void WavePicturePlot::summarize() {
    const WavePicture& picture = *this->picture();
    const QLocale locale = m_plot->locale();
    const ShownUnit& time = picture.units.time;
    QStringList contacts;
    for (const ContactInterval& contact : picture.contacts) {
        if (contacts.size() == 4) break;
        contacts.append(tr("from %1 to %2")
                            .arg(timeText(contact.begin, m_window.time, time, locale),
                                 timeText(contact.end, m_window.time, time, locale)));
    }
    const auto count = static_cast<int>(picture.contacts.size());
    m_summary =
        tr("Picture of %1 over position and time from %2 to %3, up to %4. %5: %6%7.")
            .arg(fieldWords(picture.raster.quantity),
                 timeText(m_window.time.begin, m_window.time, time, locale),
                 timeText(m_window.time.end, m_window.time, time, locale),
                 quantityText(picture.limit, picture.units.of(picture.raster.quantity), locale),
                 count == 1 ? tr("1 contact of bit and rock") : tr("%1 contacts of bit and rock").arg(count),
                 contacts.join(QStringLiteral(", ")), count > contacts.size() ? tr(" and so on") : QString());
}

}  // namespace drillwave
