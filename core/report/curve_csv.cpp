// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/curve_csv.h"

#include "core/report/report_table.h"

namespace drillwave {

std::uint64_t rowCount(const CurveStudy& study) {
    std::uint64_t rows = 0;
    for (const CurveLine& line : study.lines) rows += line.points.size();
    return rows;
}

std::string curveCsv(const CurveStudy& study) {
    const CurveQuestion& question = study.question;
    const RowColumn along = question.along.column();
    std::vector<std::string> headers{along.header};
    if (question.family) headers.insert(headers.begin(), question.family->column().header);
    for (const OutputColumn& column : question.columns) headers.push_back(column.header());
    std::vector<std::pair<const CurveLine*, std::size_t>> points;
    for (const CurveLine& line : study.lines)
        for (std::size_t i = 0; i < line.points.size(); ++i) points.emplace_back(&line, i);
    return csvText({headers, points.size(), [&](std::size_t row) {
                        const auto [line, i] = points[row];
                        Cells cells;
                        if (question.family)
                            cells.push_back(line->family ? question.family->column().cell(*line->family)
                                                         : "");
                        cells.push_back(along.cell(line->points[i]));
                        for (const std::vector<double>& values : line->values) cells.push_back(values[i]);
                        return cells;
                    }});
}

}  // namespace drillwave
