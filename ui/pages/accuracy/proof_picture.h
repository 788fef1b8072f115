// SPDX-License-Identifier: GPL-3.0-or-later
// Picture of the proofs: error against run time, and how near the extreme cases are to failing.
#pragma once

#include <QLocale>
#include <QPointF>
#include <QString>
#include <QStringList>
#include <QVector>
#include <optional>
#include <vector>

#include "core/study/proof/accuracy.h"
#include "core/study/proof/stability.h"
#include "core/study/proof/string_accuracy.h"

namespace drillwave {

/// Points of one kind.
struct ProofSeries {
    QString name;
    enum class Points { joined, apart, star } points = Points::apart;
    QVector<QPointF> at;  ///< both numbers positive
    QStringList
        labels;  ///< beside the points, one each, empty ones too; none at all where there are no labels
    QVector<int> rows;  ///< which row of the study each point is
};

/// Points on two logarithmic axes.
struct ProofPicture {
    QString xLabel;
    QString yLabel;
    QString caption;  ///< one sentence
    std::vector<ProofSeries> series;
    std::optional<double> mark;  ///< a level on the vertical axis that is not to be passed
    QString markName;
};

/// Error of e against run time, a line for each lattice, the exact solution as a star (theory §9). Errors
/// below the resolution of a double are shown there.
ProofPicture accuracyPicture(const Accuracy& accuracy, const QLocale& locale);

/// "e is right to 6·10⁻¹⁴ in 1 µs; the paper's 10 000 segments give 1·10⁻⁹ in 145 ms"; of what there is.
QString accuracySentence(const Accuracy& accuracy, const QLocale& locale);

/// Error of the efficiency of a drill string against run time: a line for each method (strings §11).
ProofPicture accuracyPicture(const StringAccuracy& accuracy, const QLocale& locale);

/// "efficiency right to 4·10⁻¹⁵ in 8 ms, in studies to 5·10⁻¹² in 0.4 ms; plain lattice 7·10⁻⁶ in 20 ms"; of
/// what there is.
QString accuracySentence(const StringAccuracy& accuracy, const QLocale& locale);

/// The worst measure of each case over its limit, against β/γ, the stiffest rate.
ProofPicture stabilityPicture(const StabilityReport& report, const QLocale& locale);

/// "4 631 cases, all passed; the nearest to its mark: …"; of what there is.
QString stabilitySentence(const StabilityReport& report, const QLocale& locale);

/// "lattice, moved waves, 10000".
QString rowName(const AccuracyRow& row);
/// "plain lattice".
QString rowName(const StringAccuracyRow& row);

}  // namespace drillwave
