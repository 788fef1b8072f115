// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/blow/blow_page.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "core/blow/blow_waves.h"
#include "core/model/chain_words.h"
#include "ui/job/output_text.h"
#include "ui/pages/blow/blow_meanings.h"
#include "ui/pages/blow/blow_plots.h"
#include "ui/pages/blow/measured_bar.h"
#include "ui/pages/blow/measured_curves.h"
#include "ui/pages/blow/measured_force.h"
#include "ui/pages/place_field.h"
#include "ui/plot/plot_widget.h"
#include "ui/text/number_text.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

/// Describes the forces on the rock and at the section, and the rebound.
QString answerOf(const SolvedBlow& blow, const BlowCurves& curves) {
    const QLocale locale;
    const auto shown = [&](double value, const ShownUnit& unit) {
        return quantityText(value / unit.factor, unit, locale);
    };
    QString text;
    if (!curves.force->isEmpty()) {
        const auto peak = std::ranges::max_element(*curves.force, {}, &QCPGraphData::value);
        text = BlowPage::tr("The largest impact force on the rock is %1, at %2.")
                   .arg(shown(peak->value, blow.units.force), shown(peak->key, blow.units.time));
    }
    if (!curves.sectionForce->isEmpty()) {
        const auto [least, largest] =
            std::ranges::minmax_element(*curves.sectionForce, {}, &QCPGraphData::value);
        text += QLatin1Char(' ') +
                BlowPage::tr("At %1, the force in this plot is between %2 (compression) and %3 (tension).")
                    .arg(placeText(blow, curves.section), shown(least->value, blow.units.force),
                         shown(largest->value, blow.units.force));
    }
    if (const char* rebound = chainWords(blow.scenario).rebound; *rebound)
        text += QLatin1Char(' ') + translated(rebound).arg(numberText(blow.summary.cor, 4, locale));
    return text;
}

constexpr int hintChars = 125;  // wide enough for a hint and the other words

QString misfitText(const Misfit& misfit, const SolvedBlow& blow) {
    const Scales scales = scalesOf(blow.request.scenario);
    const QLocale locale;
    const auto force = [&](double newtons) {
        return quantityText(newtons / scales.force, blow.units.force, locale);
    };
    QString text =
        BlowPage::tr("rms %1 · peaks differ by %2").arg(force(misfit.rms), force(misfit.peakDifference));
    if (misfit.computedPeak > 0)
        text += QStringLiteral(" (%1 %)").arg(
            locale.toString(100 * misfit.peakDifference / misfit.computedPeak, 'f', 1));
    if (misfit.lag)
        text +=
            BlowPage::tr(" · lag %1").arg(quantityText(*misfit.lag / scales.time, blow.units.time, locale));
    return text;
}

}  // namespace

BlowPage::BlowPage(Observation& observation, QWidget* parent)
    : PlotPage(parent),
      m_observation(observation),
      m_hint(new QLabel(this)),
      m_section(new PlaceField(
          observation,
          tr("Section at which the waves are shown: 0 is the struck end, 1 the bit.\nN₀ₚ is the first wave "
             "to the "
             "bit, N₁ₙ its reflection from the bit, N₂ₚ from the rear end, N₃ₙ again from the bit."),
          this)),
      m_place(new QLabel(this)),
      m_instant(new QLabel(this)),
      m_plot(makePlot()),
      m_plots(new BlowPlots(m_plot)),
      m_measuredCurves(new MeasuredCurves(m_plots)) {
    m_place->setObjectName(QStringLiteral("place"));
    m_instant->setObjectName(QStringLiteral("instant"));
    m_instant->setContentsMargins(8, 0, 8, 0);
    m_instant->setWordWrap(true);
    m_instant->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    m_instant->setToolTip(
        tr("Values at the time cursor: normal force at the section, impact force, impulse, momentum"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addLayout(makeAnswer());
    layout->addLayout(makeBar());
    layout->addWidget(m_instant);
    layout->addWidget(m_plot, 1);
    static constexpr int lines = 26;  // text lines that four plots need
    setLeastLines(lines + BlowPlots::plotCount);
    connect(m_plot, &PlotWidget::afterLayout, this, [this] { setLeastLines(lines + m_plots->legendRows()); });

    useFrame(*m_plots, tr("Waves, impact force, impulse and momentum over time"));
    m_plot->setNaming([this] { m_plots->name(); });
    m_plot->followPalette([this](const PlotStyle& style) {
        m_plots->setStyle(style);
        m_measuredCurves->setStyle(style);
    });
    connect(&observation, &Observation::sectionChanged, this, &BlowPage::showSection);
    connect(&observation, &Observation::timeChanged, this, &BlowPage::showInstant);
    connect(m_plot, &PlotWidget::timeCursorDragged, this, [this](double x) {
        if (m_blow) m_observation.setTime(x / m_blow->units.time.factor);
    });
    showPlace();
    showInstant();
}

QHBoxLayout* BlowPage::makeBar() {
    auto* label = new QLabel(tr("Section x/L"), this);
    label->setBuddy(m_section);
    // Asks for no width: it is there when there is room.
    m_hint->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    m_hint->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    QPushButton* fitButton = newFitButton(tr("Bring all curves into view (double-click in the plots)"));
    auto* bar = new QHBoxLayout;
    bar->setContentsMargins(8, 6, 8, 0);
    bar->addWidget(label);
    bar->addWidget(m_section);
    bar->addWidget(m_place);
    bar->addWidget(m_hint, 1);
    bar->addWidget(fitButton);
    return bar;
}

PreparePage BlowPage::prepare() const {
    const auto* shown = m_blow ? m_blow->page<BlowCurves>() : nullptr;
    std::vector<RunOverlay<BlowCurves>> made;
    if (shown && shown->section == m_observation.section()) made = shown->runs;
    return
        [section = m_observation.section(), runs = m_runs, made = std::move(made)](const SolvedBlow& blow) {
            BlowCurves curves = blowCurves(blow, blow.units, section);
            curves.runs = runOverlays(*runs, blow, made, [=](const SolvedBlow& run, const ShownUnits& units) {
                return blowCurves(run, units, section);
            });
            // of a blow that begins at rest
            if (!blow.marched) curves.closedForm = closedFormCurve(blow.problem, blow.units, curves.timeEnd);
            return PageData::of(std::move(curves));
        };
}

void BlowPage::setRuns(const RunListPtr& runs) {
    m_runs = runs;
    emit needsChanged();
}

void BlowPage::showSection() {
    showPlace();
    showInstant();
    emit needsChanged();
}

void BlowPage::showPlace() {
    m_place->setText(m_blow && hasUnits(m_blow->request.scenario)
                         ? placeText(*m_blow, m_observation.section())
                         : tr("0: struck end, 1: bit"));
}

void BlowPage::showInstant() {
    const std::optional<double> time = m_observation.time();
    const bool isKnown = time && m_blow && m_blow->fault.isEmpty();
    m_plot->reader().place(PlotCursor::time,
                           isKnown ? std::optional(*time * m_blow->units.time.factor) : std::nullopt);
    if (!isKnown)
        return m_instant->setText(tr("To mark a time, press T over the plots or click an event in Result."));
    if (!m_blow->impact.hasHistories()) return m_instant->setText(QString());
    const RodState instant = BlowWaves(*m_blow).state(m_observation.section(), *time);
    const ShownUnits& units = m_blow->units;
    const QLocale locale;
    m_instant->setText(tr("t = %1 · N = %2 · F = %3 · I = %4 · p = %5")
                           .arg(quantityText(*time, units.time, locale),
                                quantityText(instant.normalForce, units.force, locale),
                                quantityText(instant.impactForce, units.force, locale),
                                quantityText(instant.impulse, units.impulse, locale),
                                quantityText(instant.momentum, units.impulse, locale)));
}

void BlowPage::setResult(const SolvedBlowPtr& blow) {
    m_blow = blow;
    const auto* curves = blow->page<BlowCurves>();
    showMeasured();  // in the units on show before the axes are fitted to it
    if (curves && !(curves->timeEnd > 0)) {
        m_plots->showNothing(tr("Nothing to show: this blow has too many waves to keep."));
    } else if (curves) {
        carryCursors();
        m_plots->present(*curves);
        setMeanings();
    } else if (!blow->fault.isEmpty()) {
        m_plots->showNothing(tr("Nothing to show: %1").arg(blow->fault));
    }
    answerLabel()->setText(curves && curves->timeEnd > 0 ? answerOf(*blow, *curves) : QString());
    showPlace();
    showInstant();
    redraw();
}

// Moves the cursors A and B with the units, so that they stay where they are in the blow.
void BlowPage::carryCursors() {
    const ShownUnit& unit = m_blow->units.time;
    if (unit.unit != m_cursorUnit.unit) {
        for (const PlotCursor cursor : {PlotCursor::a, PlotCursor::b})
            if (const std::optional<double> x = m_plot->reader().position(cursor))
                m_plot->reader().place(cursor, *x / m_cursorUnit.factor * unit.factor);
    }
    m_cursorUnit = unit;
}

void BlowPage::setMeanings() {
    const BlowMeanings meanings = blowMeanings(m_blow);
    CurveMeaning ofRuns;
    ofRuns.xUnit = meanings.force.xUnit;
    ofRuns.yUnit = meanings.force.yUnit;
    for (QCPGraph* run : m_plots->forcesOfRuns()) m_plot->setMeaning(run, ofRuns);
    for (int i = 0; i < BlowCurves::waveCount; ++i)
        m_plot->setMeaning(m_plots->waveGraph(i), meanings.waves[static_cast<std::size_t>(i)]);
    for (std::size_t i = 0; i < meanings.laterWaves.size(); ++i)
        m_plot->setMeaning(m_plots->laterGraph(static_cast<int>(i)), meanings.laterWaves[i]);
    m_plot->setMeaning(m_plots->sectionForceGraph(), meanings.sectionForce);
    m_plot->setMeaning(m_plots->forceGraph(), meanings.force);
    m_plot->setMeaning(m_plots->closedFormGraph(), meanings.closedForm);
    m_plot->setMeaning(m_plots->faceForceGraph(), meanings.faceForce);
    m_plot->setMeaning(m_plots->impulseGraph(), meanings.impulse);
    m_plot->setMeaning(m_plots->momentumGraph(), meanings.momentum);
}

void BlowPage::follow(MeasuredList& measured, const UnitChoice& units) {
    m_measured = &measured;
    m_measuredBar = new MeasuredBar(measured, units, this);
    auto* column = static_cast<QVBoxLayout*>(layout());
    column->insertWidget(column->indexOf(m_instant), m_measuredBar);
    connect(m_measuredBar, &MeasuredBar::placeChosen, this, &BlowPage::goToPlace);
    connect(m_measuredBar, &MeasuredBar::alignmentWanted, this, &BlowPage::align);
    connect(m_measuredBar, &MeasuredBar::chosenChanged, this, &BlowPage::showMisfit);
    connect(&measured, &MeasuredList::changed, this, [this] {
        showMeasured();
        m_plots->fitUnlessZoomed();
        m_plot->replot(QCustomPlot::rpQueuedReplot);
    });
    showMeasured();
}

void BlowPage::showMeasured() {
    if (!m_measured || !m_blow) return;
    static const std::vector<MeasuredSignal> nothing;
    m_measuredCurves->present(isComparable(*m_blow) ? m_measured->signalList() : nothing,
                              m_blow->request.scenario, m_blow->units);
    m_measuredBar->setStyle(PlotStyle::forScreen(palette(), font()));
    m_measuredBar->setComparable(isComparable(*m_blow) || !m_blow->fault.isEmpty());
    for (const QCPGraph* graph : m_measuredCurves->graphs())
        m_plot->setMeaning(graph, forceMeaning(m_blow->units));
    showMisfit();
}

void BlowPage::goToPlace(double x) {
    if (m_blow && hasUnits(m_blow->request.scenario))
        m_observation.setSection(shareAt(m_blow->request.scenario, x));
}

// Over the time that the plots show.
std::optional<ComputedForce> BlowPage::computedFor(const MeasuredSignal& signal) const {
    if (!m_blow || !isComparable(*m_blow) || !m_blow->impact.hasHistories()) return {};
    const auto* curves = m_blow->page<BlowCurves>();
    if (!curves || !(curves->timeEnd > 0)) return {};
    return computedForce(*m_blow, signal, *curves);
}

void BlowPage::align(std::size_t index) {
    if (index >= m_measured->signalList().size()) return;
    const MeasuredSignal& signal = m_measured->signalList()[index];
    const std::optional<ComputedForce> computed = computedFor(signal);
    if (!computed) return;
    if (const std::optional<double> shift = bestShift(signal.points, computed->at, computed->end))
        m_measured->setTimeShift(index, *shift);
}

void BlowPage::showMisfit() {
    const std::size_t index = m_measuredBar->chosen();
    if (index >= m_measured->signalList().size()) return;
    const MeasuredSignal& signal = m_measured->signalList()[index];
    const std::optional<ComputedForce> computed = computedFor(signal);
    const std::optional<Misfit> misfit = computed ? misfitOf(signal, *computed) : std::nullopt;
    m_measuredBar->setMisfit(misfit ? misfitText(*misfit, *m_blow) : QString());
}

void BlowPage::setGhost(const SolvedBlowPtr& before) {
    m_plots->setGhost(before ? before->page<BlowCurves>() : nullptr);
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

// Reserves as many lines as the longest readings need at this width, so that the plots below do not move.
void BlowPage::reserveInstant() {
    const QString longest =
        QStringLiteral("t = %1 · N = %1 · F = %1 · I = %1 · p = %1").arg(QStringLiteral("−888.8 kN s"));
    const QMargins margins = m_instant->contentsMargins();
    const QRect room(0, 0, std::max(1, width() - margins.left() - margins.right()), height());
    const int text = m_instant->fontMetrics().boundingRect(room, Qt::TextWordWrap, longest).height();
    m_instant->setFixedHeight(text + margins.top() + margins.bottom());
}

void BlowPage::resizeEvent(QResizeEvent* event) {
    PlotPage::resizeEvent(event);
    reserveInstant();
    m_hint->setText(width() > hintChars * fontMetrics().averageCharWidth()
                        ? tr("Ctrl+wheel zooms · drag moves · double-click fits")
                        : QString());
}

}  // namespace drillwave
