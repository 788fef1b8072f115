// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/accuracy/proof_picture.h"

#include <QLocale>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "ui/text/number_text.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

constexpr double leastError = 1e-17;  // below, e as a double tells nothing
constexpr double leastRatio = 1e-6;   // farther from a mark is all the same

bool isLattice(const AccuracyRow& row, LatticeWaves waves) {
    return row.choice.method == Method::lattice && row.choice.lattice.waves == waves;
}

// Decades and the paper's own choices.
QString segmentsLabel(const AccuracyRow& row, const QLocale& locale) {
    const int segments = row.choice.lattice.segments;
    const QString number = locale.toString(segments);
    if (segments == paperSegments && row.choice.lattice.waves == LatticeWaves::moved)
        return tr("%1, the paper's choice").arg(number);
    const bool isDecade = segments == 100 || segments == 1'000 || segments == 10'000;
    return isDecade ? number : QString();
}

template <class Belongs>
void addSeries(ProofPicture& picture, const Accuracy& accuracy, const QString& name,
               ProofSeries::Points points, const QLocale& locale, const Belongs& belongs) {
    ProofSeries series{.name = name, .points = points, .at = {}, .labels = {}, .rows = {}};
    for (std::size_t i = 0; i < accuracy.rows.size(); ++i) {
        const AccuracyRow& row = accuracy.rows[i];
        if (row.outcome != Outcome::rebounded || !belongs(row) || !(row.time.median > 0)) continue;
        series.at.append({row.time.median, std::max(row.corError, leastError)});
        series.labels.append(row.choice.method == Method::lattice ? segmentsLabel(row, locale) : QString());
        series.rows.append(static_cast<int>(i));
    }
    if (!series.at.isEmpty()) picture.series.push_back(std::move(series));
}

const AccuracyRow* paperRow(const Accuracy& accuracy) {
    for (const AccuracyRow& row : accuracy.rows)
        if (isLattice(row, LatticeWaves::moved) && row.choice.lattice.segments == paperSegments &&
            row.outcome == Outcome::rebounded)
            return &row;
    return nullptr;
}

}  // namespace

QString rowName(const AccuracyRow& row) {
    if (row.choice.method == Method::exact) return tr("exact");
    if (row.choice.method == Method::closedForm) return tr("closed form");
    return (row.choice.lattice.waves == LatticeWaves::moved ? tr("lattice, moved waves, %1")
                                                            : tr("lattice, ring buffer, %1"))
        .arg(row.choice.lattice.segments);
}

ProofPicture accuracyPicture(const Accuracy& accuracy, const QLocale& locale) {
    using Points = ProofSeries::Points;
    ProofPicture picture;
    picture.xLabel = tr("processor time of a solve for e [s]");
    picture.yLabel = tr("error of e");
    picture.caption = accuracySentence(accuracy, locale);
    addSeries(picture, accuracy, tr("exact"), Points::star, locale,
              [](const AccuracyRow& row) { return row.choice.method == Method::exact; });
    addSeries(picture, accuracy, tr("lattice, moved waves"), Points::joined, locale,
              [](const AccuracyRow& row) { return isLattice(row, LatticeWaves::moved); });
    addSeries(picture, accuracy, tr("lattice, ring buffer"), Points::joined, locale,
              [](const AccuracyRow& row) { return isLattice(row, LatticeWaves::ring); });
    addSeries(picture, accuracy, tr("closed form"), Points::apart, locale,
              [](const AccuracyRow& row) { return row.choice.method == Method::closedForm; });
    return picture;
}

QString accuracySentence(const Accuracy& accuracy, const QLocale& locale) {
    if (accuracy.rows.empty()) return {};
    const AccuracyRow& exact = accuracy.rows.front();
    if (std::isnan(exact.corError))
        return tr("The exact solution has nothing to compare with: %1")
            .arg(translated(accuracy.extended.reason));
    QString text = tr("e is right to %1 in %2")
                       .arg(magnitudeText(exact.corError, locale), runTimeText(exact.time.median, locale));
    if (const AccuracyRow* paper = paperRow(accuracy))
        text += tr("; the paper's %1 segments give %2 in %3")
                    .arg(locale.toString(paperSegments), magnitudeText(paper->corError, locale),
                         runTimeText(paper->time.median, locale));
    return text;
}

QString rowName(const StringAccuracyRow& row) {
    switch (row.method) {
        case StringMethod::quick:
            return tr("polynomial cells (studies)");
        case StringMethod::sure:
            return tr("cut cells (a blow)");
        case StringMethod::plain:
            break;
    }
    return tr("plain lattice");
}

ProofPicture accuracyPicture(const StringAccuracy& accuracy, const QLocale& locale) {
    ProofPicture picture;
    picture.xLabel = tr("processor time of a solve [s]");
    picture.yLabel = tr("error of the efficiency");
    picture.caption = accuracySentence(accuracy, locale);
    for (std::size_t i = 0; i < accuracy.rows.size(); ++i) {
        const StringAccuracyRow& row = accuracy.rows[i];
        if (!(row.time.median > 0)) continue;
        if (picture.series.empty() || picture.series.back().name != rowName(row))
            picture.series.push_back({.name = rowName(row),
                                      .points = ProofSeries::Points::joined,
                                      .at = {},
                                      .labels = {},
                                      .rows = {}});
        ProofSeries& series = picture.series.back();
        series.at.append({row.time.median, std::max(row.error, leastError)});
        series.labels.append(tr("cells of %1").arg(runTimeText(row.cell, locale)));
        series.rows.append(static_cast<int>(i));
    }
    for (ProofSeries& series : picture.series)  // the finest: the table tells of the others
        for (qsizetype i = 0; i + 1 < series.labels.size(); ++i) series.labels[i].clear();
    return picture;
}

QString accuracySentence(const StringAccuracy& accuracy, const QLocale& locale) {
    const auto numbers = [&](const StringAccuracyRow& row, const QString& words) {
        return words.arg(magnitudeText(row.error, locale), runTimeText(row.time.median, locale));
    };
    const auto isOf = [](StringMethod method) {
        return [method](const StringAccuracyRow& row) { return row.method == method; };
    };
    // The cells that are usual come first of their method, the finest lattice last.
    const auto sure = std::ranges::find_if(accuracy.rows, isOf(StringMethod::sure));
    const auto quick = std::ranges::find_if(accuracy.rows, isOf(StringMethod::quick));
    if (sure == accuracy.rows.end()) return {};
    QString text = numbers(*sure, tr("efficiency right to %1 in %2"));
    if (quick != accuracy.rows.end()) text += numbers(*quick, tr(", in studies to %1 in %2"));
    if (const StringAccuracyRow& last = accuracy.rows.back(); last.method == StringMethod::plain)
        text += numbers(last, tr("; plain lattice %1 in %2"));
    return text;
}

ProofPicture stabilityPicture(const StabilityReport& report, const QLocale& locale) {
    ProofPicture picture;
    picture.xLabel = tr("stiffness over elasticity β/γ, the stiffest rate [1/t₀]");
    picture.yLabel = tr("worst check over its limit");
    picture.caption = stabilitySentence(report, locale);
    picture.mark = 1;
    picture.markName = tr("a case above has failed");
    constexpr std::array<std::string_view, 8> measures{
        QT_TRANSLATE_NOOP("core", "momentum"),     QT_TRANSLATE_NOOP("core", "energy"),
        QT_TRANSLATE_NOOP("core", "continuity"),   QT_TRANSLATE_NOOP("core", "limit"),
        QT_TRANSLATE_NOOP("core", "lattice"),      QT_TRANSLATE_NOOP("core", "pull"),
        QT_TRANSLATE_NOOP("core", "stated error"), QT_TRANSLATE_NOOP("core", "return")};
    for (const std::string_view measure : measures) {
        ProofSeries series{.name = coreText(measure),
                           .points = ProofSeries::Points::apart,
                           .at = {},
                           .labels = {},
                           .rows = {}};
        for (std::size_t i = 0; i < report.rows.size(); ++i) {
            const StabilityWorst worst = worstOf(report.rows[i]);
            if (worst.measure != measure) continue;
            const Groups& groups = report.rows[i].stabilityCase.groups;
            series.at.append({groups.beta / groups.gamma, std::max(worst.ratio, leastRatio)});
            series.rows.append(static_cast<int>(i));
        }
        if (!series.at.isEmpty()) picture.series.push_back(std::move(series));
    }
    return picture;
}

QString stabilitySentence(const StabilityReport& report, const QLocale& locale) {
    if (report.rows.empty()) return {};
    const auto bad = static_cast<qlonglong>(report.failed() + report.notSolved());
    const auto all = static_cast<qlonglong>(report.rows.size());
    const auto ratio = [](const StabilityRow& row) { return worstOf(row).ratio; };
    const StabilityRow& nearest = *std::ranges::max_element(report.rows, {}, ratio);
    const StabilityWorst worst = worstOf(nearest);
    const QString count = bad == 0
                              ? tr("%1 cases, all passed").arg(locale.toString(all))
                              : tr("%1 of %2 cases failed").arg(locale.toString(bad), locale.toString(all));
    if (!std::isfinite(worst.ratio))
        return count + tr("; not solved: %1").arg(QString::fromStdString(nearest.stabilityCase.name));
    return count + tr("; the worst: %1, %2 at %3 of its limit")
                       .arg(QString::fromStdString(nearest.stabilityCase.name), coreText(worst.measure),
                            numberText(worst.ratio, 2, locale));
}

}  // namespace drillwave
