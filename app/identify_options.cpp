// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/identify_options.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "app/command_error.h"
#include "app/input_text.h"
#include "app/output_file.h"
#include "app/scenario_argument.h"
#include "app/signal_options.h"
#include "app/study_plots.h"
#include "core/model/parameter.h"
#include "core/signal/signal_option.h"
#include "core/study/identify/gauge_reading.h"
#include "core/study/identify/identify_study.h"
#include "core/text/decimal_text.h"
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

double lengthOf(const std::string& option, const std::string& text) {
    const TypedQuantity typed = parseQuantity(text, Quantity::length);
    if (!typed.valid()) refuseIdentifyValue(option, typed.problem);
    return typed.si;
}

}  // namespace

std::optional<double> percentageOf(std::string_view text) {
    if (!text.ends_with('%')) return std::nullopt;
    const std::optional<double> number = parseNumber(text.substr(0, text.size() - 1));
    return number ? std::optional(*number / 100) : std::nullopt;
}

GaugeChoice gaugeChoiceOf(const std::string& name, const std::string& word) {
    const std::string option = "--" + name + " " + word;
    const std::size_t at = word.rfind('@');
    if (at == std::string::npos || at == 0)
        refuseIdentifyUsage(
            {translatable("%1: give COLUMN@DISTANCE, the distance from the bit face"), {option}});
    GaugeChoice gauge;
    gauge.column = word.substr(0, at);
    if (const std::size_t plus = gauge.column.find('+'); plus != std::string::npos) {
        gauge.opposite = gauge.column.substr(plus + 1);
        gauge.column.resize(plus);
        if (gauge.column.empty() || gauge.opposite.empty())
            refuseIdentifyUsage({translatable("%1: two columns belong around the plus sign"), {option}});
    }
    gauge.distance = lengthOf(option, word.substr(at + 1));
    if (!(gauge.distance > 0)) refuseIdentifyValue(option, translatable("the distance must be positive"));
    return gauge;
}

namespace {

KnownTolerance knownOf(const std::string& word, const Scenario& scenario) {
    const std::string option = "--known " + word;
    const std::size_t sign = word.find('=');
    if (sign == std::string::npos || sign == 0)
        refuseIdentifyUsage({translatable("%1: give KEY=+-TOLERANCE"), {option}});
    KnownTolerance known;
    known.key = word.substr(0, sign);
    std::string text = word.substr(sign + 1);
    for (const std::string_view prefix : {"+-", "\u00b1", "+/-"})
        if (text.starts_with(prefix)) {
            text.erase(0, prefix.size());
            break;
        }
    const bool isPercent = !text.empty() && text.back() == '%';
    const bool isRelative = known.key == "gain" || known.key == "zero" ||
                            known.key.ends_with("youngs_modulus") || known.key.ends_with("density");
    if (isPercent || isRelative) {
        const std::optional<double> share = percentageOf(text);
        if (!share) refuseIdentifyValue(option, translatable("must be a percentage, such as +-2%"));
        known.tolerance = *share;
        if (!isRelative) {
            const KeptParameter parameter = findParameter(known.key);
            if (parameter && parameter->applies(scenario))
                known.tolerance *= std::abs(parameter->value(scenario).value_or(0));
        }
    } else {
        const Quantity quantity = known.key.ends_with(".area") ? Quantity::area : Quantity::length;
        const TypedQuantity typed = parseQuantity(text, quantity);
        if (!typed.valid()) refuseIdentifyValue(option, typed.problem);
        known.tolerance = typed.si;
    }
    if (!(known.tolerance > 0)) refuseIdentifyValue(option, translatable("the tolerance must be positive"));
    return known;
}

template <class Choice>
Choice choiceOf(const Arguments& arguments, const char* option,
                std::initializer_list<std::pair<const char*, Choice>> choices, Choice otherwise) {
    const std::optional<std::string> word = arguments.value(option);
    if (!word) return otherwise;
    std::string list;
    for (const auto& [name, choice] : choices) {
        if (*word == name) return choice;
        list += (list.empty() ? "" : ", ") + std::string(name);
    }
    refuseIdentifyUsage(
        {translatable("--%1 %2: must be one of %3"), {std::string(option), shortened(*word), list}});
}

}  // namespace

std::vector<OptionSpec> identifyOptionSpecs() {
    using Times = OptionSpec::Times;
    std::vector<OptionSpec> specs{
        {"signals", "REC.csv …",
         "read these records of strain gauges; give several in their order along the hole", Times::repeated},
        {"gauge", "COLUMN@DISTANCE",
         "column of a gauge and its distance from the bit face, once or twice; A+B@… takes the mean of two "
         "gauges on opposite sides",
         Times::repeated},
        {"law", "LAW",
         "rock law to fit to the record: auto, bilinear or corner; file checks the law given in FILE without "
         "a fit (default: auto)"},
        {"known", "KEY=+-TOL",
         "tolerance of an input that is known: KEY (gain, zero, gauge or a size) is within +-TOL of its "
         "value with 95 % probability; see the description of the command",
         Times::list},
        {"backing", "KIND",
         "support behind the rock or specimen: rigid, or bar if the specimen is between two equal bars "
         "(default: rigid)"},
        {"check", "COLUMN@DISTANCE",
         "predict the wave at a second gauge, DISTANCE behind the specimen on the bar there, and print the "
         "error; needs --backing bar"},
        {"dispersion", "KIND",
         "correction for the dispersion of waves between gauge and bit: fit (estimated from the record), bar "
         "(theory of a round bar) or none (default: fit)"},
        {"end", "TIME", "use the record only up to this time after the reflected wave reaches the gauge"},
        {"blows", "WHICH", "blows of a record to evaluate: first, or all (default: first)"},
        {"seed", "S", "seed of the random numbers for noise and samples (default: 1)"},
        {"j", "N", "number of threads (default: all)"},
        {"json", "", "print one JSON object instead of the table"},
        {"o", "DIR",
         "also write tables, random samples of the rock and the scenario with the identified rock into DIR"},
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
    question.law = choiceOf(arguments, "law",
                            {{"auto", LawChoice::automatic},
                             {"bilinear", LawChoice::bilinear},
                             {"corner", LawChoice::corner},
                             {"file", LawChoice::file}},
                            LawChoice::automatic);
    question.dispersion = choiceOf(
        arguments, "dispersion",
        {{"fit", DispersionChoice::fit}, {"bar", DispersionChoice::bar}, {"none", DispersionChoice::none}},
        DispersionChoice::fit);
    question.barBehind = choiceOf(arguments, "backing", {{"rigid", false}, {"bar", true}}, false);
    std::string behind;
    if (const std::optional<std::string> word = arguments.value("check")) {
        if (!question.barBehind) refuseIdentifyUsage(translatable("--check needs --backing bar"));
        const GaugeChoice check = gaugeChoiceOf("check", *word);
        if (!check.opposite.empty()) refuseIdentifyUsage(translatable("--check takes one column"));
        behind = check.column;
        question.checkDistance = check.distance;
    }
    question.allBlows = choiceOf(arguments, "blows", {{"first", false}, {"all", true}}, false);
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
        question.known.push_back(knownOf(word, scenario));
    const SignalOptions options = signalOptionsOf(arguments);
    for (const std::string& record : records) {
        RereadableInput input(record, RereadableInput::mostKept, arguments.style());
        const std::string name = inputName(record);
        GaugeReading reading = readGauges(input.stream(), options, gauges, places, stop, behind);
        if (!reading.problem.isEmpty())
            throw CommandError(reading.isWrongOption ? ExitCode::invalidScenario : ExitCode::unreadableInput,
                               std::vector{about(name, reading.problem)});
        if (!reading.questions.empty()) {
            std::vector<Message> questions;
            for (const std::string& open : reading.questions)
                questions.push_back(
                    about(name, {translatable("the table does not state: %1; give %2, see drillwave signal"),
                                 {open, std::string(answerTo(open))}}));
            throw CommandError(ExitCode::invalidScenario, questions);
        }
        reading.record.file = name;
        question.records.push_back(std::move(reading.record));
    }
    if (const std::vector<Message> problems = identifyProblems(question); !problems.empty())
        throw CommandError(ExitCode::invalidScenario, problems, CommandError::Begin::withOption);
    return question;
}

}  // namespace drillwave
