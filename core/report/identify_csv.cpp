// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/identify_report.h"

#include <utility>

#include "core/model/parameter.h"
#include "core/report/report_table.h"
#include "core/text/units.h"

namespace drillwave {

namespace {

/// Rows of the curves of all records that have any.
std::vector<std::pair<std::size_t, std::size_t>> curveRows(const IdentifyFindings& findings) {
    std::vector<std::pair<std::size_t, std::size_t>> rows;
    for (std::size_t r = 0; r < findings.records.size(); ++r)
        for (std::size_t i = 0; i < findings.records[r].curves.time.size(); ++i) rows.emplace_back(r, i);
    return rows;
}

std::string headingOfKey(const std::string& key) {
    return withUnit(key, &unitsOf(findParameter(key)->quantity).front());
}

template <class CellsOf>
std::string curvesCsv(const IdentifyReport& report, std::vector<std::string> headers, CellsOf cellsOf) {
    const IdentifyFindings& findings = report.findings;
    const bool isSeveral = findings.records.size() > 1;
    if (isSeveral) headers.insert(headers.begin(), "record");
    const auto rows = curveRows(findings);
    return csvText({std::move(headers), rows.size(), [&](std::size_t row) {
                        const auto [r, i] = rows[row];
                        Cells cells;
                        if (isSeveral) cells.emplace_back(r + 1);
                        for (const double value : cellsOf(findings.records[r].curves, i))
                            cells.emplace_back(value);
                        return cells;
                    }});
}

}  // namespace

std::string matchCsv(const IdentifyReport& report) {
    return curvesCsv(report, {"time [s]", "incident [N]", "measured [N]", "model [N]", "residual [N]"},
                     [](const MatchCurves& curves, std::size_t i) {
                         return std::vector{curves.time[i], curves.incident[i], curves.measured[i],
                                            curves.model[i], curves.residual[i]};
                     });
}

std::string forcePenetrationCsv(const IdentifyReport& report) {
    return curvesCsv(
        report, {"time [s]", "penetration [m]", "force [N]", "model_force [N]"},
        [](const MatchCurves& curves, std::size_t i) {
            return std::vector{curves.time[i], curves.penetration[i], curves.force[i], curves.modelForce[i]};
        });
}

std::string posteriorCsv(const IdentifyReport& report) {
    const PosteriorDraws draws = posteriorDraws(report.findings, posteriorRows, report.question.seed);
    if (draws.rows.empty()) return {};
    std::vector<std::string> headers;
    for (const std::string& key : draws.keys) headers.push_back(headingOfKey(key));
    return csvText({std::move(headers), draws.rows.size(), [&](std::size_t row) {
                        Cells cells;
                        for (const double value : draws.rows[row]) cells.emplace_back(value);
                        return cells;
                    }});
}

std::string recordsCsv(const IdentifyReport& report) {
    std::vector<std::string> keys{"bit_rock.stiffness", "bit_rock.gamma", "bit_rock.gap"};
    for (const RecordAnswer& record : report.findings.records)
        if (record.law == "corner" && keys.size() == 3) {
            keys.emplace_back("bit_rock.corner.1.force");
            keys.emplace_back("bit_rock.corner.1.slope");
        }
    std::vector<std::string> headers{"record", "file", "model"};
    for (const std::string& key : keys) {
        const std::string heading = headingOfKey(key);
        const std::string unit = heading.substr(key.size());
        headers.push_back(heading);
        headers.push_back(key + "_low" + unit);
        headers.push_back(key + "_high" + unit);
        headers.push_back(key + "_verdict");
    }
    headers.emplace_back("misfit");
    headers.emplace_back("unexplained");
    return csvText({std::move(headers), report.findings.records.size(), [&](std::size_t row) {
                        const RecordAnswer& record = report.findings.records[row];
                        Cells cells{row + 1, record.file, record.refusal ? "refused" : name(record.model)};
                        for (const std::string& key : keys) {
                            const IdentifiedParameter* parameter = record.find(key);
                            if (!parameter) {
                                cells.resize(cells.size() + 4);
                                continue;
                            }
                            cells.emplace_back(parameter->value);
                            cells.emplace_back(parameter->low);
                            cells.emplace_back(parameter->high);
                            cells.emplace_back(name(parameter->verdict));
                        }
                        if (!record.refusal) {
                            cells.emplace_back(record.match.misfit);
                            cells.emplace_back(record.match.unexplained);
                        }
                        return cells;
                    }});
}

std::string incidentCsv(const IdentifyReport& report) {
    const auto wave = report.findings.main().incidentWave();
    return csvText({{"time [us]", "force [kN]"}, wave.size(), [&](std::size_t row) {
                        return Cells{1e6 * wave[row].first, wave[row].second / 1000};
                    }});
}

}  // namespace drillwave
