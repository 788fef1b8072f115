// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/curve_csv.h"

#include "core/text/number_text.h"

namespace drillwave {

std::uint64_t rowCount(const CurveStudy& study) {
    std::uint64_t rows = 0;
    for (const CurveLine& line : study.lines) rows += line.points.size();
    return rows;
}

std::string curveCsv(const CurveStudy& study) {
    const CurveQuestion& question = study.question;
    const RowColumn along = question.along.column();
    std::string csv;
    if (question.family) csv += question.family->column().header + ",";
    csv += along.header;
    for (const OutputColumn& column : question.columns) csv += "," + column.header();
    csv += '\n';
    for (const CurveLine& line : study.lines) {
        std::string family;
        if (line.family) {
            question.family->column().appendText(family, *line.family);
            family += ',';
        }
        for (std::size_t i = 0; i < line.points.size(); ++i) {
            csv += family;
            along.appendText(csv, line.points[i]);
            for (const std::vector<double>& values : line.values) {
                csv += ',';
                appendNumber(csv, values[i]);
            }
            csv += '\n';
        }
    }
    return csv;
}

}  // namespace drillwave
