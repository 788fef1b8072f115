// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/design/design_card.h"

#include <QUrl>
#include <algorithm>
#include <cmath>

#include "core/report/design_words.h"
#include "ui/pages/design/aim_rows.h"
#include "ui/pages/study/output_box.h"
#include "ui/pages/study/parameter_names.h"
#include "ui/text/language.h"
#include "ui/text/number_text.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

/// Returns the difference of `value` from `of`, in percent of the second.
QString percentBetween(double value, double of, const DesignUnits& units) {
    return numberText(100 * std::abs(value / of - 1), 2, units.locale());
}

/// The design that the card is about: the one to take, or where the limits exclude all, the robust best.
std::size_t shownDesign(const DesignReport& report) {
    return report.findings.recommended.value_or(*report.findings.best.robust);
}

/// Whether the answer is to stay with what there is.
bool isToStay(const DesignReport& report) {
    const std::optional<DesignHeadline> headline = headlineOf(report);
    return headline == DesignHeadline::keep || headline == DesignHeadline::noDifference;
}

/// Heading of the card: the design that it is about.
QString designTitle(const DesignReport& report, const DesignUnits& units) {
    const std::size_t shown = shownDesign(report);
    if (report.study.choices.empty()) return DesignCard::tr("<b>This scenario</b>");
    const QString name = units.designName(shown).toHtmlEscaped();
    if (isToStay(report))
        return presentDesign(report.study) == shown
                   ? DesignCard::tr("<b>Present design: %1</b>").arg(name)
                   : DesignCard::tr("<b>Any design, such as %1</b>").arg(name);
    return shown == *report.findings.best.robust
               ? DesignCard::tr("<b>Best for uncertain rock: %1</b>").arg(name)
               : DesignCard::tr("<b>Best in all aims: %1</b>").arg(name);
}

/// The other designs that the tables and files mark: a line for each mark.
QString markLines(const DesignReport& report, const DesignUnits& units) {
    if (report.findings.designs.size() < 2 || headlineOf(report) == DesignHeadline::noDifference) return {};
    const std::size_t shown = shownDesign(report);
    std::vector<std::pair<std::string_view, QString>> marks;
    if (!isToStay(report) && shown != *report.findings.best.robust)
        marks.emplace_back("best_uncertain", DesignCard::tr("Best for uncertain rock: %1"));
    marks.emplace_back("best_nominal", DesignCard::tr("Best for the values entered: %1"));
    if (!isToStay(report)) marks.emplace_back("present", DesignCard::tr("Present design: %1"));
    marks.emplace_back("equal", DesignCard::tr("Equally good: %1"));
    constexpr qsizetype enough = 4;
    const std::optional<std::size_t> present = presentDesign(report.study);
    QString lines;
    for (const auto& [mark, words] : marks) {
        QStringList names;
        for (std::size_t d = 0; d < report.findings.designs.size() && names.size() <= enough; ++d) {
            const auto ofDesign = marksOf(report, d, present);
            if (std::ranges::find(ofDesign, mark) == ofDesign.end()) continue;
            names << (names.size() < enough ? units.designName(d) : QStringLiteral("…"));
        }
        if (!names.isEmpty())
            lines += (lines.isEmpty() ? QStringLiteral("<br>") : QStringLiteral(" · ")) +
                     words.arg(names.join(QStringLiteral("; ")).toHtmlEscaped());
    }
    return lines;
}

QString bestSentences(const DesignAnswer& answer, const DesignUnits& units) {
    const DesignReport& report = answer.report;
    const BestDesigns& best = report.findings.best;
    const DesignStudy& study = report.study;
    const DesignAim& first = study.aims.front();
    const std::size_t shown = shownDesign(report);
    QString text = designTitle(report, units);
    for (const DesignAim& aim : study.aims)
        text += QStringLiteral(" · %1 %2").arg(aimName(aim), units.aimedText(report, aim, shown));
    text += markLines(report, units);
    if (headlineOf(report) == DesignHeadline::noDifference) return text;
    if (!best.ties.empty() && !isToStay(report) && shown == *best.robust) {
        QStringList names;
        constexpr std::size_t enough = 4;
        for (std::size_t i = 0; i < std::min(enough, best.ties.size()); ++i)
            names << units.designName(best.ties[i]);
        if (best.ties.size() > enough) names << QStringLiteral("…");
        text += QStringLiteral("<br>") +
                DesignCard::tr("The samples do not distinguish this design from %1: any of them will do.")
                    .arg(names.join(QStringLiteral("; ")));
        if (best.nextBest)
            text += QLatin1Char(' ') + DesignCard::tr("Among them, %1 has the %2: %3.")
                                           .arg(units.designName(*best.nextBest), aimWords(study.aims[1]),
                                                units.aimedText(report, study.aims[1], *best.nextBest));
    }
    const bool namesRobust = !isToStay(report) || shown == *best.robust;
    if (!best.nominal || *best.nominal == *best.robust || !namesRobust) return text;
    const double robust = aimedValue(report, first, *best.robust).value;
    const double other = aimedValue(report, first, *best.nominal).value;
    const QString where = translated(statisticMessage(first.statistic, first.sense));
    text +=
        QStringLiteral("<p>") +
        (first.sense == Sense::largest
             ? DesignCard::tr(
                   "The best design for the values entered, %1, has an objective that is %2 % smaller %3.")
             : DesignCard::tr(
                   "The best design for the values entered, %1, has an objective that is %2 % larger %3."))
            .arg(units.designName(*best.nominal), percentBetween(other, robust, units), where);
    const std::size_t output = report.study.placeOf(*first.output, {}).output;
    const auto asInFile = [&](std::size_t design) { return report.findings.designs[design].nominal[output]; };
    if (!std::isfinite(asInFile(*best.robust))) return text;  // that one blow could not be solved
    const QString costs = percentBetween(asInFile(*best.robust), asInFile(*best.nominal), units);
    return text + QLatin1Char(' ') +
           (first.sense == Sense::largest ? DesignCard::tr("With the values entered, the objective of the "
                                                           "best design for uncertain rock is %1 % smaller.")
                                                .arg(costs)
                                          : DesignCard::tr("With the values entered, the objective of the "
                                                           "best design for uncertain rock is %1 % larger.")
                                                .arg(costs));
}

QString measureSentence(const DesignReport& report, const DesignUnits& units) {
    const DesignStudy& study = report.study;
    QStringList sentences;
    for (std::size_t o = 0; o < report.findings.sensitivity.outputs.size(); ++o) {
        const OutputSensitivity& output = report.findings.sensitivity.outputs[o];
        const std::optional<std::size_t> first = firstToMeasure(report, o);
        if (!first) continue;
        const QString name = *first < study.uncertain.size()
                                 ? parameterName(*study.uncertain[*first].parameter)
                                 : DesignCard::tr("the draws");
        const double percent = std::round(100 * std::min(output.indices[*first].total.value, 1.0));
        sentences << DesignCard::tr(
                         "To know the %1 better, measure <b>%2</b> first: it causes %3 % of the scatter.")
                         .arg(outputName(*report.findings.aimed[o]), name,
                              numberText(percent, 3, units.locale()));
    }
    return sentences.join(QStringLiteral("<br>"));
}

QString worstSentence(const DesignReport& report, std::size_t a, const DesignUnits& units) {
    const DesignAim& aim = report.study.aims[a];
    const WorstCase& worst = *report.findings.worst[a];
    QStringList places;
    for (const auto& [parameter, si] : worstInputs(report.study, worst))
        places << parameterName(*parameter) + QLatin1Char(' ') + units.text(*parameter, si);
    const QString words[]{outputName(*aim.output), units.text(*aim.output, worst.value),
                          places.join(QStringLiteral(", "))};
    const std::size_t robust = *report.findings.best.robust;
    if (!report.study.choices.empty() && shownDesign(report) != robust)
        return (aim.sense == Sense::largest ? DesignCard::tr("Smallest %1 found with %4: <b>%2</b>, at %3.")
                                            : DesignCard::tr("Largest %1 found with %4: <b>%2</b>, at %3."))
            .arg(words[0], words[1], words[2], units.designName(robust));
    return (aim.sense == Sense::largest
                ? DesignCard::tr("Smallest %1 found for the best design: <b>%2</b>, at %3.")
                : DesignCard::tr("Largest %1 found for the best design: <b>%2</b>, at %3."))
        .arg(words[0], words[1], words[2]);
}

/// Replaces remarks about options of the command line by remarks about controls of the window.
QString remarkText(const DesignRemark& remark) {
    if (remark.code == "flat_optimum") return {};  // said already
    if (remark.code == "energy_varies")
        return DesignCard::tr(
            "The choices change the blow energy: machines of different power are compared. “keep the energy” "
            "holds it constant.");
    if (remark.code == "gamma_dominates")
        return DesignCard::tr(
            "Nearly all scatter of the efficiency comes from γ. To compare hammers, choose loading work as "
            "the objective.");
    return translated(withTitles(remark.text)).toHtmlEscaped();
}

QString loadLink(const QUrl& to, const QString& words) {
    return QStringLiteral("<a href=\"%1\">%2</a>").arg(to.toString(), words);
}

}  // namespace

DesignCard::DesignCard(QWidget* parent) : QTextBrowser(parent) {
    setOpenLinks(false);
    setFrameShape(QFrame::NoFrame);
    setAccessibleName(tr("Answer of the study"));
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setWordWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
    viewport()->setAutoFillBackground(false);
    connect(this, &QTextBrowser::anchorClicked, this, &DesignCard::follow);
}

void DesignCard::present(const DesignAnswer& answer, const DesignUnits& units) {
    const DesignReport& report = answer.report;
    const BestDesigns& best = report.findings.best;
    QStringList paragraphs;
    paragraphs << bestSentences(answer, units);
    const std::size_t shown = shownDesign(report);
    if (!report.study.choices.empty() && headlineOf(report) != DesignHeadline::noDifference) {
        if (!isToStay(report))
            paragraphs << loadLink(linkToDesign(shown), shown == *best.robust
                                                            ? tr("Load the best design for uncertain rock")
                                                            : tr("Load %1").arg(units.designName(shown)));
        if (best.nominal && *best.nominal != shown)
            paragraphs << loadLink(linkToDesign(*best.nominal),
                                   tr("Load the best design for the values entered"));
    }
    if (const QString measure = measureSentence(report, units); !measure.isEmpty()) paragraphs << measure;
    for (std::size_t a = 0; a < report.findings.worst.size(); ++a)
        if (report.findings.worst[a])
            paragraphs << worstSentence(report, a, units) + QLatin1Char(' ') +
                              loadLink(linkToWorst(a), tr("Load"));
    for (const DesignRemark& remark : remarksOn(report, units))
        if (const QString text = remarkText(remark); !text.isEmpty()) paragraphs << text;
    const QString samples = QString::number(report.study.samples);
    paragraphs << (answer.isRefined()
                       ? tr("%1 samples of each design; ± is the 95 % error.").arg(samples)
                       : tr("%1 samples so far, %2 to come.").arg(samples, QString::number(answer.wanted)));
    QString html = paragraphs.join(QStringLiteral("<br/>"));
    setHtml(html.replace(QLatin1String(" %"), QStringLiteral("\u00a0%")));  // "5 %" stays in one line
    fitHeight();
}

QString DesignCard::headline(const DesignReport& report, const DesignUnits& units) {
    const Message answer = designAnswerMessage(report, units);
    return translated(answer.isEmpty() ? designWarning(report, units) : answer);
}

QStringList DesignCard::besideHeadline(const DesignReport& report, const DesignUnits& units) {
    QStringList sentences;
    if (!designAnswerMessage(report, units).isEmpty()) sentences << translated(designWarning(report, units));
    const std::size_t robust = *report.findings.best.robust;
    if (headlineOf(report) == DesignHeadline::keep && robust != shownDesign(report))
        sentences << tr("%1 is equally good, within the error.").arg(units.designName(robust));
    sentences.removeAll(QString());
    return sentences;
}

std::optional<std::uint64_t> DesignCard::designToLoad(const DesignReport& report) {
    if (report.study.choices.empty() || isToStay(report)) return {};
    return shownDesign(report);
}

void DesignCard::resizeEvent(QResizeEvent* event) {
    QTextBrowser::resizeEvent(event);
    fitHeight();
}

/// As high as the text, so that it needs no scroll bar.
void DesignCard::fitHeight() {
    const int height = static_cast<int>(std::ceil(document()->size().height())) + 2 * frameWidth();
    if (height != maximumHeight()) setFixedHeight(height);
}

QUrl DesignCard::linkToDesign(std::uint64_t design) {
    return QUrl(QStringLiteral("design:%1").arg(design));
}

QUrl DesignCard::linkToWorst(std::size_t aim) {
    return QUrl(QStringLiteral("worst:%1").arg(aim));
}

void DesignCard::follow(const QUrl& link) {
    const qulonglong number = link.path().toULongLong();
    if (link.scheme() == QLatin1String("design")) emit designWanted(number);
    if (link.scheme() == QLatin1String("worst")) emit worstWanted(number);
}

}  // namespace drillwave
