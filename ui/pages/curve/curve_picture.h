// SPDX-License-Identifier: GPL-3.0-or-later
// Picture of a study along a parameter.
#pragma once

#include <QLocale>
#include <QString>
#include <QVector>
#include <optional>
#include <span>

#include "core/model/preset.h"
#include "ui/pages/curve/curve_study.h"
#include "ui/plot/curve_marks.h"
#include "ui/plot/graph_data.h"

namespace drillwave {

/// One curve.
struct DrawnCurve {
    enum class Kind { curve, reference, closedForm } kind = Kind::curve;
    QString name;
    GraphData points;
    int number = 0;       ///< of its value in the family: curves of one value look alike
    bool isHere = false;  ///< of the present scenario
};

/// A name on a part of the range.
struct PresetBand {
    QString name;
    double from = 0, to = 0;  ///< as shown
    double at = 0;            ///< the value itself
};

/// All in the units of `x` and `value`; never changed once built.
struct CurvePicture {
    QString xName;  ///< "stiffness k"
    ShownUnit x;
    double from = 0, to = 0;  ///< the range as shown
    bool logarithmic = false;
    QString aboveName;       ///< of a second axis above; empty for none
    double aboveFactor = 1;  ///< what it shows over what the axis below shows
    const Output* output = nullptr;
    ShownUnit value;
    double valueFactor = 1;  ///< what is shown over what the study has
    QVector<DrawnCurve> lines;
    int marked = -1;             ///< the line that the marks are of
    QVector<CurveMark> marks;    ///< by place
    QVector<QPointF> extremes;   ///< of the other lines
    std::optional<double> goal;  ///< as shown
    QVector<PresetBand> bands;
    QString summary;

    const DrawnCurve* markedLine() const { return marked < 0 ? nullptr : &lines[marked]; }
};

/// The first output of a line as drawn, with a gap where there is no answer; nullptr where there is none
/// anywhere.
GraphData linePoints(const CurveLine& line, double xFactor, double valueFactor);

/// `here` is the value of the family in the present scenario: its line is the one that is marked; without a
/// line of that value the last is. Presets are named where they set the parameter.
CurvePicture curvePicture(const CurvePageStudy& study, const ShownUnits& units, const Unit& xUnit,
                          std::optional<double> here, std::span<const Preset> presets, const QLocale& locale);

}  // namespace drillwave
