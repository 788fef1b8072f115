// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/drill_options.h"

#include <cstdio>

#include "app/axis_argument.h"
#include "app/command_error.h"
#include "app/input_text.h"
#include "app/scenario_argument.h"
#include "core/text/decimal_text.h"
#include "core/text/name_text.h"

namespace drillwave {

namespace {

/// Cells times nodes that a march may take unless --work-limit permits more, and about how many a second has.
constexpr double mostWork = 4e9, workOfSecond = 2e7;

double permittedWork(const Arguments& arguments) {
    const std::optional<std::string> text = arguments.value("work-limit");
    if (!text) return mostWork;
    const std::optional<double> work = parseNumber(*text);
    if (!work || !(*work >= 1))
        throw CommandError(ExitCode::usage,
                           "--work-limit " + shortened(*text) + " must be a number of at least 1");
    return *work;
}

void printRemark(const std::string& text) {
    std::fprintf(stderr, "%s\n", printable(text).c_str());
}

}  // namespace

OutputUnits drillUnits(const Arguments& arguments) {
    if (arguments.has("si") && arguments.has("dimensionless"))
        throw CommandError(ExitCode::usage, "--si and --dimensionless exclude each other");
    return arguments.has("dimensionless") ? OutputUnits::dimensionless : OutputUnits::si;
}

int drillCells(const Arguments& arguments, int usual) {
    const std::optional<std::string> text = arguments.value("cells");
    if (!text) return usual;
    const std::optional<int> cells = wholeNumberIn<int>(*text);
    if (!cells || *cells < leastDrillingCells || *cells > mostDrillingCells)
        throw CommandError(ExitCode::usage, "--cells " + shortened(*text) + " " +
                                                wholeNumberProblem(leastDrillingCells, mostDrillingCells));
    return *cells;
}

std::optional<BlowRange> drillHistories(const Arguments& arguments, const std::optional<std::string>& out,
                                        const DrillingSettings& settings) {
    const std::optional<std::string> text = arguments.value("histories");
    if (!text) return std::nullopt;
    const auto wrong = [&](const std::string& reason) {
        throw CommandError(ExitCode::usage, "--histories " + shortened(*text) + " " + reason);
    };
    if (!out || *out == "-" || out->ends_with(".csv")) wrong("needs a folder: add -o DIR");
    const std::size_t colon = text->find(':');
    const std::optional<long> first = wholeNumberIn<long>(text->substr(0, colon));
    const std::optional<long> last =
        colon == std::string::npos ? first : wholeNumberIn<long>(text->substr(colon + 1));
    if (!first || !last || *first < 1 || *last < *first || *last > settings.blows)
        wrong("must be A:B, blows from 1 to " + std::to_string(settings.blows));
    return BlowRange{*first, *last};
}

void refuseDrill(const std::vector<std::string>& problems, const std::string& path) {
    if (problems.empty()) return;
    std::vector<std::string> lines;
    for (const std::string& problem : problems) lines.push_back(inputName(path) + ": " + problem);
    throw CommandError(ExitCode::invalidScenario, std::move(lines));
}

void checkDrillWork(double work, const Arguments& arguments) {
    const double permitted = permittedWork(arguments);
    if (work <= permitted) return;
    throw CommandError(ExitCode::unsolvedOrFailed,
                       "it takes " + rounded(work, 3) + " cells times nodes, more than the " +
                           rounded(permitted, 3) + " permitted, about " +
                           inHandyUnit(work / workOfSecond, Quantity::time, 2) +
                           "; fewer blows or --cells take less, --work-limit permits more");
}

void remarkOnUnusedOfDrill(const Scenario& scenario, const std::string& path) {
    const Drill& drill = scenario.drill;
    if (scenario.drillString.endTime)
        printRemark(inputName(path) + ": end_time counts for single blows, not here");
    if (drill.machineMass.value_or(0) > 0 && drill.damperDamping.value_or(0) == 0 &&
        drill.damperStiffness.value_or(0) == 0)
        printRemark(inputName(path) +
                    ": machine_mass without a damper: the machine presses with a constant force");
}

}  // namespace drillwave
