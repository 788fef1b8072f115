// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/design/design_card.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "core/report/design_words.h"
#include "ui/pages/design/aim_rows.h"
#include "ui/pages/study/output_box.h"
#include "ui/pages/study/parameter_names.h"
#include "ui/text/number_text.h"

namespace drillwave {
namespace {

/// The statistic of an aim, with its nominal value where that is asked for.
SampledValue sampledOf(const DesignReport& report, const DesignAim& aim, std::size_t design) {
    const StatisticPlace place = report.study.placeOf(*aim.output, aim.statistic);
    if (aim.statistic.kind == Statistic::Kind::nominal)
        return {.value = report.findings.designs[design].nominal[place.output]};
    return report.findings.designs[design].statistics[place.output][place.statistic];
}

QString valueText(const DesignReport& report, const DesignAim& aim, std::size_t design,
                  const DesignUnits& units) {
    const SampledValue value = sampledOf(report, aim, design);
    const AimedOutput shown = units.of(*aim.output, std::abs(value.value));
    QString text = numberText(value.value * shown.factor, 4, units.locale());
    if (aim.statistic.hasError())
        text += QStringLiteral(" ± ") + numberText(value.error() * shown.factor, 1, units.locale());
    if (!shown.unit.unit.isEmpty()) text += QChar(QChar::Nbsp) + shown.unit.unit;
    return text;
}

QString bestSentences(const DesignAnswer& answer, const DesignUnits& units) {
    const DesignReport& report = answer.report;
    const BestDesigns& best = report.findings.best;
    const DesignStudy& study = report.study;
    const DesignAim& first = study.aims.front();
    QString text = study.choices.empty()
                       ? DesignCard::tr("<b>This scenario</b>")
                       : DesignCard::tr("<b>Robust best: %1</b>").arg(units.designName(*best.robust));
    for (const DesignAim& aim : study.aims)
        text += QStringLiteral("<br>%1 %2").arg(aimName(aim), valueText(report, aim, *best.robust, units));
    if (!best.ties.empty()) {
        QStringList names;
        constexpr std::size_t enough = 4;
        for (std::size_t i = 0; i < std::min(enough, best.ties.size()); ++i)
            names << units.designName(best.ties[i]);
        if (best.ties.size() > enough) names << QStringLiteral("…");
        text += QStringLiteral("<p>") +
                DesignCard::tr("The samples do not tell it apart from %1: any of them will do.")
                    .arg(names.join(QStringLiteral("; ")));
    }
    if (!best.nominal || *best.nominal == *best.robust) return text;
    const double robust = sampledOf(report, first, *best.robust).value;
    const double other = sampledOf(report, first, *best.nominal).value;
    const double change = 100 * std::abs(other / robust - 1);
    const QString percent = numberText(change, 2, units.locale());
    const QString where = statisticWords(first.statistic, first.sense);
    text +=
        QStringLiteral("<p>") + (first.sense == Sense::largest
                                     ? DesignCard::tr("The nominal best, %1, would lose %2 % of it %3.")
                                     : DesignCard::tr("The nominal best, %1, would have %2 % more of it %3."))
                                    .arg(units.designName(*best.nominal), percent, where);
    return text;
}

QString measureSentence(const DesignReport& report, const DesignUnits& units) {
    const DesignStudy& study = report.study;
    QStringList sentences;
    for (std::size_t o = 0; o < report.findings.sensitivity.outputs.size(); ++o) {
        const OutputSensitivity& output = report.findings.sensitivity.outputs[o];
        if (output.isConstant || output.indices.empty() || study.dimensions() < 2) continue;
        const auto most = std::ranges::max_element(output.indices, {},
                                                   [](const SobolIndex& index) { return index.total.value; });
        const auto i = static_cast<std::size_t>(most - output.indices.begin());
        const QString name = i < study.uncertain.size() ? parameterName(*study.uncertain[i].parameter)
                                                        : DesignCard::tr("the draws");
        sentences << DesignCard::tr("For %1 measure <b>%2</b> first: %3 of its scatter.")
                         .arg(outputName(*report.findings.aimed[o]), name,
                              numberText(most->total.value, 2, units.locale()));
    }
    return sentences.join(QStringLiteral("<br>"));
}

QString worstSentence(const DesignReport& report, std::size_t a, const DesignUnits& units) {
    const DesignAim& aim = report.study.aims[a];
    const WorstCase& worst = *report.findings.worst[a];
    const AimedOutput shown = units.of(*aim.output, std::abs(worst.value));
    QStringList places;
    for (std::size_t i = 0; i < std::min(worst.at.size(), report.study.uncertain.size()); ++i) {
        const Parameter& parameter = *report.study.uncertain[i].parameter;
        places << parameterName(parameter) + QLatin1Char(' ') + units.text(parameter, worst.at[i]);
    }
    return (aim.sense == Sense::largest ? DesignCard::tr("Least %1 found: <b>%2</b>, at %3.")
                                        : DesignCard::tr("Largest %1 found: <b>%2</b>, at %3."))
        .arg(outputName(*aim.output), units.text(shown, worst.value), places.join(QStringLiteral(", ")));
}

/// What the words of the command line say of its options, the window says of its own.
QString remarkText(const DesignRemark& remark) {
    if (remark.code == "flat_optimum") return {};  // said already
    if (remark.code == "energy_varies")
        return DesignCard::tr(
            "The choices change the energy of the blow: machines of different power are "
            "compared. “keep the energy” keeps it.");
    if (remark.code == "gamma_dominates")
        return DesignCard::tr(
            "The scatter of the efficiency is nearly all that of γ; work of loading shows "
            "what wave and machine can do.");
    return QString::fromStdString(remark.text).toHtmlEscaped();
}

}  // namespace

DesignCard::DesignCard(QWidget* parent) : QWidget(parent), m_layout(new QVBoxLayout(this)) {
    m_layout->setContentsMargins(8, 4, 4, 4);
    m_best = addLabel("best");
    m_loadBest = new QPushButton(tr("Load the robust best"), this);
    m_loadBest->setObjectName(QStringLiteral("loadBest"));
    m_layout->addWidget(m_loadBest);
    m_loadNominal = new QPushButton(tr("Load the nominal best"), this);
    m_loadNominal->setObjectName(QStringLiteral("loadNominal"));
    m_layout->addWidget(m_loadNominal);
    m_measure = addLabel("measure");
    for (std::size_t a = 0; a < mostAims; ++a) {
        QLabel* label = addLabel("worst");
        auto* load = new QPushButton(tr("Load this worst case"), this);
        load->setObjectName(QStringLiteral("loadWorst%1").arg(a + 1));
        m_layout->addWidget(load);
        m_worst.push_back({label, load});
        connect(load, &QPushButton::clicked, this, [this, a] { emit worstWanted(a); });
    }
    m_remarks = addLabel("remarks");
    m_state = addLabel("state");
    m_layout->addStretch(1);
    connect(m_loadBest, &QPushButton::clicked, this, [this] { emit designWanted(m_robust); });
    connect(m_loadNominal, &QPushButton::clicked, this, [this] { emit designWanted(m_nominal); });
    clear();
}

QLabel* DesignCard::addLabel(const char* name) {
    auto* label = new QLabel(this);
    label->setObjectName(QLatin1String(name));
    label->setWordWrap(true);
    label->setTextFormat(Qt::RichText);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    m_layout->addWidget(label);
    return label;
}

void DesignCard::present(const DesignAnswer& answer, const DesignUnits& units) {
    const DesignReport& report = answer.report;
    const BestDesigns& best = report.findings.best;
    m_best->setText(bestSentences(answer, units));
    m_robust = *best.robust;
    m_nominal = best.nominal.value_or(m_robust);
    m_loadBest->setVisible(!report.study.choices.empty());
    m_loadNominal->setVisible(m_nominal != m_robust);
    m_measure->setText(measureSentence(report, units));
    for (std::size_t a = 0; a < m_worst.size(); ++a) {
        const bool isThere = a < report.findings.worst.size() && report.findings.worst[a];
        m_worst[a].label->setText(isThere ? worstSentence(report, a, units) : QString());
        m_worst[a].label->setVisible(isThere);
        m_worst[a].load->setVisible(isThere && !report.study.draws);
    }
    QStringList remarks;
    for (const DesignRemark& remark : remarksOn(report))
        if (const QString text = remarkText(remark); !text.isEmpty()) remarks << text;
    m_remarks->setText(remarks.join(QStringLiteral("<p>")));
    const QString samples = QString::number(report.study.samples);
    m_state->setText(answer.isRefined()
                         ? tr("%1 samples of each design; errors are of 95 %.").arg(samples)
                         : tr("%1 samples so far, %2 to come.").arg(samples, QString::number(answer.wanted)));
}

void DesignCard::clear() {
    for (QLabel* label : {m_best, m_measure, m_state, m_remarks}) label->clear();
    m_loadBest->hide();
    m_loadNominal->hide();
    for (const Worst& worst : m_worst) {
        worst.label->hide();
        worst.load->hide();
    }
}

QString DesignCard::text() const {
    QStringList texts{m_best->text(), m_measure->text()};
    for (const Worst& worst : m_worst)
        if (!worst.label->isHidden()) texts << worst.label->text();
    texts << m_remarks->text() << m_state->text();
    return texts.join(QLatin1Char('\n'));
}

}  // namespace drillwave
