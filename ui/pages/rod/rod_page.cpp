// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/rod/rod_page.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "core/blow/blow_waves.h"
#include "core/blow/string_blow.h"
#include "core/report/strength_words.h"
#include "ui/job/output_text.h"
#include "ui/pages/place_field.h"
#include "ui/pages/rod/rod_plot.h"
#include "ui/plot/plot_widget.h"
#include "ui/runs/runs.h"
#include "ui/text/language.h"
#include "ui/text/number_text.h"
#include "ui/text/shown_text.h"

namespace drillwave {

RodPage::RodPage(Observation& observation, QWidget* parent)
    : PlotPage(parent),
      m_observation(observation),
      m_readout(new QLabel(this)),
      m_plot(makePlot()),
      m_rod(new RodPlot(m_plot)) {
    auto* section =
        new PlaceField(observation,
                       tr("Section shown by the dotted line: 0 is the struck end, 1 the bit.\nA click in the "
                          "plot moves it, and moves the time cursor to the largest stress there."),
                       this);
    auto* label = new QLabel(tr("Section x/L"), this);
    label->setBuddy(section);
    m_readout->setObjectName(QStringLiteral("readout"));
    m_readout->setWordWrap(true);
    m_readout->setContentsMargins(8, 0, 8, 0);
    m_readout->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    m_readout->setToolTip(tr("The largest stresses at the section, and when they occur"));
    QPushButton* fitButton = newFitButton(tr("Bring the whole rod into view (double-click in the plot)"));

    auto* bar = new QHBoxLayout;
    bar->setContentsMargins(8, 6, 8, 0);
    bar->addWidget(label);
    bar->addWidget(section);
    bar->addStretch(1);
    bar->addWidget(fitButton);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addLayout(makeAnswer());
    layout->addLayout(bar);
    layout->addWidget(m_readout);
    layout->addWidget(m_plot, 1);
    constexpr int lines = 24;  // with legends, axes and table
    setLeastLines(lines);

    useFrame(*m_rod, tr("Largest stresses along the rod"));
    connect(&observation, &Observation::sectionChanged, this, &RodPage::showHere);
    connect(&observation, &Observation::timeChanged, this, &RodPage::showHere);
    connect(m_plot, &PlotWidget::clicked, this,
            [this](QCPAxisRect* /*rect*/, QPointF coordinates) { goTo(coordinates); });
    showReadout();
}

PreparePage RodPage::prepare() const {
    std::vector<RunOverlay<RodCurves>> made;
    if (const RodCurves* shown = curves()) made = shown->runs;
    return [runs = m_runs, made = std::move(made)](const SolvedBlow& blow) {
        const std::stop_token& stop = blow.request.stop;
        RodCurves curves = rodCurves(blow, blow.units, stop);
        curves.runs = runOverlays(
            runsLike(blow.scenario, *runs), blow, made,
            [&](const SolvedBlow& run, const ShownUnits& units) { return rodCurves(run, units, stop); });
        return PageData::of(std::move(curves));
    };
}

void RodPage::setRuns(const RunListPtr& runs) {
    m_runs = runs;
    emit needsChanged();
}

const RodCurves* RodPage::curves() const {
    return m_blow ? m_blow->page<RodCurves>() : nullptr;
}

void RodPage::setResult(const SolvedBlowPtr& blow) {
    if (const auto* curves = blow->page<RodCurves>(); curves && curves->string && !curves->string->waves) {
        m_rod->showNothing(tr("Nothing to show: there are too many waves to keep."));
        m_plot->setDataText({});
    } else if (curves) {
        m_rod->present(*curves);
        const CurveMeaning meaning{.xUnit = blow->units.length.unit, .yUnit = blow->units.stress.unit};
        for (const Load line : loads) m_plot->setMeaning(m_rod->graph(line), meaning);
        for (QCPCurve* run : m_rod->runs()) m_plot->setMeaning(run, meaning);
        m_plot->setDataText([blow](char separator) { return rodCsv(*blow->page<RodCurves>(), separator); });
    } else if (!blow->fault.isEmpty()) {
        m_rod->showNothing(tr("Nothing to show: %1").arg(blow->fault));
        m_plot->setDataText({});
    } else {
        return;  // solved for another page; the answer for this one follows
    }
    m_blow = blow;
    answerLabel()->setText(answer());
    showHere();
    redraw();
}

void RodPage::setGhost(const SolvedBlowPtr& before) {
    m_rod->setGhost(before ? before->page<RodCurves>() : nullptr);
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

void RodPage::showHere() {
    showReadout();
    const RodCurves* shown = curves();
    if (!shown) return;
    const double section = m_observation.section();
    std::optional<double> stress;
    if (const std::optional<double> time = m_observation.time()) stress = stressAt(section, *time);
    m_rod->setHere(section * shown->units.length.factor, stress);
}

std::optional<double> RodPage::stressAt(double section, double time) const {
    if (!m_blow->impact.hasHistories()) return {};
    const RodCurves& shown = *curves();
    const BlowWaves waves(*m_blow);
    const double force =
        waves.value(WaveQuantity::force, std::max(waves.rear(), section), std::min(time, waves.end()));
    if (!shown.string) return force * shown.units.stress.factor;
    const RodStretch& in = shown.string->stretches[shown.string->sectionAt(section)];
    return stressOf(in, force, in.shareAt(section)) * shown.units.stress.factor;
}

// The line is there even while it is empty, so that the layout does not jump.
void RodPage::showReadout() {
    const RodCurves* shown = curves();
    if (!shown) return m_readout->setText(QStringLiteral(" "));
    if (shown->string && !shown->string->waves) return m_readout->setText(QStringLiteral(" "));
    const QLocale locale;
    const auto words = [&](Load line) {
        const RodForce force = shown->forceAt(line, m_observation.section());
        const QString stress =
            numberText(shown->stress(line, force), 4, locale) + QChar(QChar::Nbsp) + shown->units.stress.unit;
        if (!(force.size > 0)) return stress;
        return tr("%1 at %2").arg(stress, quantityText(force.time, shown->units.time, locale));
    };
    const QString place = placeText(*m_blow, m_observation.section());
    if (shown->string) {
        const RodStretch& in = shown->string->stretches[shown->string->sectionAt(m_observation.section())];
        return m_readout->setText(tr("At %1, during the blow: %2 and %3\nin %4")
                                      .arg(place, words(Load::compression), words(Load::tension), in.words) +
                                  strengthText(shown->string->sectionAt(m_observation.section())));
    }
    m_readout->setText(tr("At %1, during the blow: %2 and %3\nafterwards, in the residual waves: %4 and %5")
                           .arg(place, words(Load::compression), words(Load::tension),
                                words(Load::compressionAfter), words(Load::tensionAfter)));
}

std::vector<SectionStress> RodPage::stresses() const {
    const Scenario& scenario = m_blow->scenario;
    if (!hasUnits(scenario)) return {};
    const std::optional<RodForces>& ofRod = m_blow->summary.rodForces;
    return ofRod ? sectionStresses(scenario, *ofRod) : sectionStresses(scenario, m_blow->impact);
}

// The share of strength of the section.
QString RodPage::strengthText(std::size_t section) const {
    const std::vector<std::optional<StrengthUse>> uses = strengthUses(m_blow->scenario, stresses());
    if (section >= uses.size() || !uses[section]) return {};
    return tr("; the largest stress of this section uses %1 % of its strength")
        .arg(numberText(100 * uses[section]->share(), 3, QLocale()));
}

// Which section breaks first, or while no strength is known, where the stresses are largest.
QString RodPage::answer() const {
    if (!m_blow->fault.isEmpty()) return {};
    const std::vector<SectionStress> known = stresses();
    const LocalStyle style(QLocale(), m_blow->units.system, m_blow->units.chosen);
    const auto uses = strengthUses(m_blow->scenario, known);
    const bool hasStrength = std::ranges::any_of(uses, [](const auto& use) { return use.has_value(); });
    const QString strength = translated(strengthSentence(m_blow->scenario, known, style));
    if (hasStrength) return strength;
    const QString largest = largestStressText(*m_blow);
    return curves()->string ? (largest + QLatin1Char(' ') + strength).trimmed() : largest;
}

void RodPage::goTo(QPointF coordinates) {
    const std::optional<RodForce> force = m_rod->forceAt(coordinates);
    if (!force) return;
    m_observation.setSection(force->section);
    if (force->size > 0) m_observation.setTime(force->time);
}

}  // namespace drillwave
