// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/identify_options.h"

#include <algorithm>
#include <optional>
#include <span>
#include <utility>

#include "app/command_error.h"
#include "app/input_text.h"
#include "app/output_file.h"
#include "app/scenario_argument.h"
#include "app/signal_options.h"
#include "app/study_plots.h"
#include "core/study/identify/gauge_reading.h"
#include "core/study/identify/identify_study.h"
#include "core/study/identify/option_words.h"
#include "core/text/decimal_text.h"
#include "core/text/enum_names.h"
#include "core/text/units.h"

namespace drillwave {

namespace {

/// Options of a blow read by --signal that have no meaning for gauges.
constexpr std::string_view optionsOfOneSignal[] = {"signal", "all-samples", "signal-column",
                                                   "zero",   "from",        "to"};

[[noreturn]] void refuseIdentifyUsage(const Message& message) {
    throw CommandError(ExitCode::usage, message);
}

[[noreturn]] void refuseIdentifyValue(const std::string& option, const Message& reason) {
    throw CommandError(ExitCode::invalidScenario,
                       std::vector{Message(translatable("%1: %2"), {shortened(option), reason})},
                       CommandError::Begin::withOption);
}

/// The value of a word; `option` is the option with the word, for messages.
template <class Value>
Value valueOf(const std::string& option, ReadWord<Value> read) {
    if (read.hasOtherForm) refuseIdentifyUsage({translatable("%1: %2"), {option, read.problem}});
    if (!read.problem.isEmpty()) refuseIdentifyValue(option, read.problem);
    return std::move(read.value);
}

/// The index of the name that an option gives; 0 without the option.
std::size_t choiceOf(const Arguments& arguments, const char* option,
                     std::span<const std::string_view> names) {
    const std::optional<std::string> word = arguments.value(option);
    if (!word) return 0;
    if (const auto found = std::ranges::find(names, *word); found != names.end())
        return static_cast<std::size_t>(found - names.begin());
    std::string list;
    for (const std::string_view name : names) list.append(list.empty() ? "" : ", ").append(name);
    refuseIdentifyUsage(
        {translatable("--%1 %2: must be one of %3"), {std::string(option), shortened(*word), list}});
}

template <class Choice>
Choice choiceOf(const Arguments& arguments, const char* option, const EnumNames<Choice>& names) {
    return allValues<Choice>[choiceOf(arguments, option, names.all())];
}

}  // namespace

GaugeChoice gaugeChoiceOf(const std::string& name, const std::string& word) {
    return valueOf("--" + name + " " + word, readGaugeWord(word));
}

std::vector<OptionSpec> identifyOptionSpecs() {
    using Times = OptionSpec::Times;
    std::vector<OptionSpec> specs{
        {"signals", "REC.csv …",
         "read these records of strain gauges; give several records in the order of hole depth, the "
         "shallowest first",
         Times::repeated},
        {"gauge", "COLUMN@DISTANCE",
         "column of a gauge and its distance from the bit face; give one or two gauges. A+B@… takes the mean "
         "of two gauges on opposite sides",
         Times::repeated},
        {"law", "LAW",
         "rock law to fit: bilinear (straight loading curve), corner (one corner in it) or auto (either); "
         "file checks the law given in FILE without a fit (default: auto)"},
        {"known", "KEY=+-TOL",
         "95 % tolerance of a known input: KEY (gain, zero, gauge or a dimension) is within +-TOL of its "
         "value; see the description of the command",
         Times::list},
        {"backing", "KIND",
         "support behind the rock or specimen: rigid, or bar if the specimen is between two equal bars "
         "(default: rigid)"},
        {"check", "COLUMN@DISTANCE",
         "predict the wave at a gauge on the bar behind the specimen, DISTANCE away from the specimen, and "
         "print the error; needs --backing bar"},
        {"dispersion", "KIND",
         "correction for the dispersion of waves between gauge and bit: fit (estimated from the record), bar "
         "(theory of a round bar) or none (default: fit)"},
        {"end", "TIME", "use the record only up to this time after the reflected wave reaches the gauge"},
        {"blows", "WHICH", "blows of a record to evaluate: first, or all (default: first)"},
        {"seed", "S", "seed of the random numbers for noise and samples (default: 1)"},
        {"j", "N", "number of threads (default: all)"},
        {"json", "", "print one JSON object instead of the table"},
        {"o", "DIR",
         "also write tables, random samples of the rock, and the scenario with the rock that was found, into "
         "DIR"},
        plotsOptionSpec(),
        {"force", "", "overwrite existing files"}};
    std::vector<OptionSpec> all = scenarioOptions();
    std::erase_if(all, [](const OptionSpec& option) {
        return std::find(std::begin(optionsOfOneSignal), std::end(optionsOfOneSignal), option.name) !=
               std::end(optionsOfOneSignal);
    });
    specs.insert(specs.begin(), all.begin(), all.end());
    specs.push_back(decimalCommaSpec());
    return specs;
}

IdentifyFiles identifyFiles(const Arguments& arguments) {
    IdentifyFiles files;
    files.records = arguments.values("signals");
    std::vector<std::string> operands = arguments.operands();
    const auto isScenario = [](const std::string& word) {
        return word.ends_with(".yaml") || word.ends_with(".yml");
    };
    auto scenario = std::find_if(operands.begin(), operands.end(), isScenario);
    if (scenario == operands.end()) scenario = operands.begin();
    files.scenario = *scenario;
    operands.erase(scenario);
    // A shell puts all names of a pattern behind --signals.
    files.records.insert(files.records.end(), operands.begin(), operands.end());
    if (files.records.empty()) refuseIdentifyUsage(translatable("needs --signals REC.csv"));
    for (std::size_t i = 0; i < files.records.size(); ++i)
        for (std::size_t k = 0; k < i; ++k)
            if (files.records[i] == files.records[k])
                refuseIdentifyUsage(
                    {translatable("%1 is given twice; give each record once"), {files.records[i]}});
    return files;
}

IdentifyQuestion identifyQuestionOf(const Arguments& arguments, const Scenario& scenario,
                                    const std::string& path, const std::vector<std::string>& records,
                                    const std::stop_token& stop) {
    const std::vector<std::string> words = arguments.values("gauge");
    if (words.empty()) refuseIdentifyUsage(translatable("needs --gauge COLUMN@DISTANCE"));
    if (words.size() > 2) refuseIdentifyUsage(translatable("takes one or two gauges"));
    std::vector<GaugeChoice> gauges;
    for (const std::string& word : words) gauges.push_back(gaugeChoiceOf("gauge", word));
    IdentifyQuestion question;
    question.scenario = scenario;
    constexpr std::string_view backings[] = {"rigid", "bar"}, blows[] = {"first", "all"};
    question.law = choiceOf(arguments, "law", lawChoiceNames);
    question.dispersion = choiceOf(arguments, "dispersion", dispersionChoiceNames);
    question.barBehind = choiceOf(arguments, "backing", backings) == 1;
    question.allBlows = choiceOf(arguments, "blows", blows) == 1;
    std::string behind;
    if (const std::optional<std::string> word = arguments.value("check")) {
        if (!question.barBehind) refuseIdentifyUsage(translatable("--check needs --backing bar"));
        const GaugeChoice check = gaugeChoiceOf("check", *word);
        if (!check.opposite.empty()) refuseIdentifyUsage(translatable("--check takes one column"));
        behind = check.column;
        question.checkDistance = check.distance;
    }
    question.seed = static_cast<std::uint64_t>(arguments.number("seed", 1, 0, 2'000'000'000));
    if (const std::optional<std::string> end = arguments.value("end")) {
        const TypedQuantity typed = parseQuantity(*end, Quantity::time);
        if (!typed.valid()) refuseIdentifyValue("--end " + *end, typed.problem);
        if (!(typed.si > 0)) refuseIdentifyValue("--end " + *end, translatable("must be positive"));
        question.end = typed.si;
    }
    if (!hasUnits(scenario))
        throw CommandError(
            ExitCode::invalidScenario,
            about(path, translatable("is given by its dimensionless groups; identify needs physical units")));
    std::vector<GaugePlace> places;
    for (std::size_t g = 0; g < gauges.size(); ++g) {
        auto place = gaugePlace(scenario, gauges[g].distance);
        if (!place)
            refuseIdentifyValue("--gauge " + words[g],
                                translatable("is not on a uniform section of the rod or string"));
        places.push_back(std::move(*place));
    }
    if (const Message problem = gaugePairProblem(gauges, places); !problem.isEmpty())
        refuseIdentifyValue("--gauge", problem);
    for (const std::string& word : arguments.values("known"))
        question.known.push_back(valueOf("--known " + word, readKnownWord(word, scenario)));
    const SignalOptions options = signalOptionsOf(arguments);
    for (const std::string& record : records) {
        RereadableInput input(record, RereadableInput::mostKept, arguments.style());
        const std::string name = inputName(record);
        GaugeReading reading = readGauges(input.stream(), options, gauges, places, stop, behind);
        checkReading(name, reading.problem, reading.isWrongOption, reading.questions);
        reading.record.file = name;
        question.records.push_back(std::move(reading.record));
    }
    if (const std::vector<Message> problems = identifyProblems(question); !problems.empty())
        throw CommandError(ExitCode::invalidScenario, problems, CommandError::Begin::withOption);
    return question;
}

}  // namespace drillwave
