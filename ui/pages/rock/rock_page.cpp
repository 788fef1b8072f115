// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/rock/rock_page.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/job/output_text.h"
#include "ui/pages/rock/rock_plot.h"
#include "ui/plot/overlay.h"
#include "ui/plot/plot_widget.h"
#include "ui/text/number_text.h"

namespace drillwave {

RockPage::RockPage(Observation& observation, QWidget* parent)
    : PlotPage(parent),
      m_observation(observation),
      m_instant(new QLabel(this)),
      m_plot(makePlot()),
      m_rock(new RockPlot(m_plot)) {
    m_instant->setObjectName(QStringLiteral("instant"));
    m_instant->setWordWrap(true);
    m_instant->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    m_instant->setToolTip(tr("State of the rock at the time cursor, shown by the larger point"));
    QPushButton* fitButton = newFitButton(tr("Shows the whole path (double-click in the plot)"));

    auto* bar = new QHBoxLayout;
    bar->setContentsMargins(8, 6, 8, 0);
    bar->addWidget(m_instant, 1);
    bar->addWidget(fitButton);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addLayout(makeAnswer());
    layout->addLayout(bar);
    layout->addWidget(m_plot, 1);
    constexpr int lines = 17;  // with legend, axes and table
    setLeastLines(lines);

    useFrame(*m_rock, tr("Impact force against penetration"));
    m_plot->setNaming([this] { m_rock->name(); });
    connect(&observation, &Observation::timeChanged, this, [this] {
        showTime();
        redrawOverlay(*m_plot);
    });
    showTime();
}

PreparePage RockPage::prepare() const {
    const auto* shown = m_blow ? m_blow->page<RockCurve>() : nullptr;
    std::vector<RunOverlay<RockCurve>> made;
    if (shown) made = shown->runs;
    return [runs = m_runs, made = std::move(made)](const SolvedBlow& blow) {
        RockCurve curve = rockCurve(blow, blow.units);
        curve.runs = runOverlays(*runs, blow, made, [](const SolvedBlow& run, const ShownUnits& units) {
            return rockCurve(run, units);
        });
        return PageData::of(std::move(curve));
    };
}

void RockPage::setRuns(const RunListPtr& runs) {
    m_runs = runs;
    emit needsChanged();
}

void RockPage::setResult(const SolvedBlowPtr& blow) {
    const auto* curve = blow->page<RockCurve>();
    if (curve && curve->path->isEmpty()) {
        m_rock->showNothing(tr("Nothing to show: this blow has too many waves to keep."));
    } else if (curve) {
        m_rock->present(*curve);
        const CurveMeaning meaning{.xUnit = blow->units.penetration.unit, .yUnit = blow->units.force.unit};
        m_plot->setMeaning(m_rock->path(), meaning);
        for (QCPCurve* run : m_rock->runs()) m_plot->setMeaning(run, meaning);
    } else if (!blow->fault.isEmpty()) {
        m_rock->showNothing(tr("Nothing to show: %1").arg(blow->fault));
    } else {
        return;  // solved for another page; the answer for this one follows
    }
    m_blow = blow;
    answerLabel()->setText(blow->fault.isEmpty()
                               ? tr("The bit penetrates %1 into the rock, and %2 remain after the rebound. "
                                    "%3 % of the blow energy stays in the rock.")
                                     .arg(outputText(*findOutput("max_penetration"), *blow),
                                          outputText(*findOutput("residual_penetration"), *blow),
                                          numberText(100 * blow->summary.energy.rockWork, 3, QLocale()))
                               : QString());
    showTime();
    redraw();
}

void RockPage::showTime() {
    const auto* curve = m_blow ? m_blow->page<RockCurve>() : nullptr;
    if (!curve || !m_observation.time()) {
        m_rock->setPoint({});
        m_instant->setText(
            tr("To mark a time, click an event in Result or place the time cursor on the page Blow."));
        return;
    }
    const QPointF point = rockPoint(*curve, *m_observation.time() * curve->units.time.factor);
    m_rock->setPoint(point);
    const QLocale locale;
    const auto shown = [&locale](double value, const ShownUnit& unit) {
        return quantityText(value / unit.factor, unit, locale);
    };
    m_instant->setText(tr("t = %1 · U = %2 · F = %3")
                           .arg(quantityText(*m_observation.time(), curve->units.time, locale),
                                shown(point.x(), curve->units.penetration),
                                shown(point.y(), curve->units.force)));
}

void RockPage::setGhost(const SolvedBlowPtr& before) {
    m_rock->setGhost(before ? before->page<RockCurve>() : nullptr);
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

}  // namespace drillwave
