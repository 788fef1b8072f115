// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/drill_options.h"
#include "app/axis_argument.h"
#include "app/command_error.h"
#include "app/input_text.h"
#include "app/scenario_argument.h"
#include "core/study/drilling/quick_march.h"
#include "core/text/decimal_text.h"

namespace drillwave {

double permittedDrillWork(const Arguments& arguments) {
    const std::optional<std::string> text = arguments.value("work-limit");
    if (!text) return mostDrillingWork;
    const std::optional<double> work = parseNumber(*text);
    if (!work || !(*work >= 1))
        throw CommandError(ExitCode::usage,
                           Message(translatable("--work-limit %1: must be at least 1"), {shortened(*text)}));
    return *work;
}

OutputUnits drillUnits(const Arguments& arguments) {
    if (arguments.has("si") && arguments.has("dimensionless"))
        throw CommandError(ExitCode::usage, translatable("--si and --dimensionless cannot be combined"));
    return arguments.has("dimensionless") ? OutputUnits::dimensionless : OutputUnits::si;
}

int drillCells(const Arguments& arguments, int usual) {
    const std::optional<std::string> text = arguments.value("cells");
    if (!text) return usual;
    const std::optional<int> cells = wholeNumberIn<int>(*text);
    if (!cells || *cells < leastDrillingCells || *cells > mostDrillingCells)
        throw CommandError(ExitCode::usage,
                           Message("%1 %2", {"--cells " + shortened(*text),
                                             wholeNumberProblem(leastDrillingCells, mostDrillingCells)}));
    return *cells;
}

std::optional<BlowRange> drillHistories(const Arguments& arguments, const std::optional<std::string>& out,
                                        const DrillingSettings& settings) {
    const std::optional<std::string> text = arguments.value("histories");
    if (!text) return std::nullopt;
    const auto wrong = [&](const char* pattern) {
        throw CommandError(ExitCode::usage,
                           Message(pattern, {shortened(*text), std::to_string(settings.blows)}));
    };
    if (!out || *out == "-" || out->ends_with(".csv"))
        wrong(translatable("--histories %1 needs a folder: add -o DIR"));
    const std::size_t colon = text->find(':');
    const std::optional<long> first = wholeNumberIn<long>(text->substr(0, colon));
    const std::optional<long> last =
        colon == std::string::npos ? first : wholeNumberIn<long>(text->substr(colon + 1));
    if (!first || !last || *first < 1 || *last < *first || *last > settings.blows)
        wrong(translatable("--histories %1 must be A:B, blows from 1 to %2"));
    return BlowRange{*first, *last};
}

void refuseDrill(const std::vector<Message>& problems, const std::string& path) {
    if (!problems.empty())
        throw CommandError(ExitCode::invalidScenario, eachAbout(inputName(path), problems));
}

void checkDrillWork(double work, const Arguments& arguments) {
    const double permitted = permittedDrillWork(arguments);
    const ReadingStyle& style = arguments.style();
    if (work <= permitted) return;
    throw CommandError(
        ExitCode::unsolvedOrFailed,
        Message(translatable("it takes %1 computing steps, more than the %2 permitted, about %3; fewer "
                             "blows or --cells take less, --work-limit permits more"),
                {style.number(work, 3), style.number(permitted, 3),
                 style.quantity(work / workOfSecond, Quantity::time, 2)}));
}

void remarkOnUnusedOfDrill(const Scenario& scenario, const std::string& path, const ReadingStyle& style) {
    const Drill& drill = scenario.drill;
    const std::string name = inputName(path);
    if (scenario.drillString.endTime)
        printRemark(about(name, translatable("end_time applies only to single blows, not here")), style);
    if (drill.machineMass.value_or(0) > 0 && drill.damperDamping.value_or(0) == 0 &&
        drill.damperStiffness.value_or(0) == 0)
        printRemark(
            about(name,
                  translatable("machine_mass without a damper: the machine presses with a constant force")),
            style);
}

}  // namespace drillwave
