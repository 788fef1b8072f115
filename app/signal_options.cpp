// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/signal_options.h"

#include <algorithm>

#include "app/command_error.h"
#include "app/input_text.h"
#include "app/output_file.h"
#include "app/scenario_argument.h"
#include "core/blow/blow_waves.h"
#include "core/blow/thinned_blow.h"
#include "core/model/form_conversion.h"
#include "core/model/scales.h"
#include "core/signal/signal_option.h"
#include "core/text/decimal_text.h"
#include "core/text/name_text.h"
#include "core/yaml/recorder_file.h"

namespace drillwave {

namespace {

constexpr OptionSpec recorderOption{
    "recorder", "NAME",
    "read the record with the options that `drillwave signal --save-recorder NAME` has saved"};

/// Most points of a tabulated blow.
constexpr std::size_t mostPoints = 10'000;

[[noreturn]] void refuseUsage(const Message& message) {
    throw CommandError(ExitCode::usage, message);
}

std::vector<Recorder> recordersThere() {
    RecorderFile file = loadRecorders(recordersPath());
    if (!file.problems.empty())
        throw CommandError(file.isUnreadable ? ExitCode::unreadableInput : ExitCode::invalidScenario,
                           file.problems);
    return std::move(file.recorders);
}

const Recorder& recorderNamed(const std::vector<Recorder>& recorders, const std::string& wanted) {
    if (const Recorder* found = findRecorder(recorders, wanted)) return *found;
    std::vector<std::string_view> names;
    for (const Recorder& recorder : recorders) names.push_back(recorder.name);
    const std::string near(nearestName(wanted, names));
    if (!near.empty())
        refuseUsage(
            {translatable("--recorder %1: is not known; did you mean `%2`?"), {shortened(wanted), near}});
    refuseUsage({translatable("--recorder %1: is not known; --save-recorder %1 keeps options in %2"),
                 {shortened(wanted), recordersPath()}});
}

}  // namespace

std::vector<OptionSpec> signalOptionSpecs() {
    std::vector<OptionSpec> specs;
    for (const SignalOption& option : signalOptions())
        specs.push_back({option.name, option.value, option.help});
    specs.push_back(recorderOption);
    return specs;
}

std::vector<OptionSpec> recordOptionSpecs() {
    std::vector<OptionSpec> specs{
        {"signal", "FILE", "use this measured record as the blow; the options below say how to read it"},
        {"all-samples", "",
         "use all samples of --signal; by default samples are left out as long as this changes impulse and "
         "coefficient of restitution by less than 1e-4"}};
    for (const OptionSpec& option : signalOptionSpecs()) specs.push_back(option);
    return specs;
}

SignalOptions signalOptionsOf(const Arguments& arguments) {
    SignalOptions options;
    if (const std::optional<std::string> wanted = arguments.value("recorder")) {
        const std::vector<Recorder> recorders = recordersThere();
        const Recorder& recorder = recorderNamed(recorders, *wanted);
        if (const Message problem = applyRecorder(recorder, options); !problem.isEmpty())
            throw CommandError(ExitCode::invalidScenario, std::vector{about(recordersPath(), problem)});
    }
    for (const SignalOption& option : signalOptions()) {
        if (!arguments.has(option.name)) continue;
        const std::string text = arguments.value(option.name).value_or("");
        if (const Message problem = option.set(options, text); !problem.isEmpty())
            refuseUsage(about("--" + std::string(option.name) + " " + shortened(text), problem));
    }
    if (options.from && options.to && !(*options.from < *options.to))
        refuseUsage(translatable("--from must be before --to"));
    return options;
}

void saveRecorder(const Arguments& arguments) {
    const std::optional<std::string> name = arguments.value("save-recorder");
    if (!name) return;
    if (trimmed(*name).empty()) refuseUsage(translatable("--save-recorder needs a name, this one is empty"));
    Recorder recorder{std::string(trimmed(*name)), {}};
    std::vector<Recorder> recorders = recordersThere();
    if (const std::optional<std::string> base = arguments.value("recorder"))
        recorder.settings = recorderNamed(recorders, *base).settings;
    for (const SignalOption& option : signalOptions()) {
        if (!arguments.has(option.name)) continue;
        std::erase_if(recorder.settings, [&](const auto& setting) { return setting.first == option.name; });
        recorder.settings.emplace_back(
            option.name, option.value.empty() ? "true" : arguments.value(option.name).value_or(""));
    }
    if (const Message problem =
            saveRecorders(recordersPath(), withRecorder(std::move(recorders), std::move(recorder)));
        !problem.isEmpty())
        throw CommandError(ExitCode::unwritableOutput, problem);
}

void checkReading(const std::string& name, const Message& problem, bool isWrongOption,
                  const std::vector<std::string>& questions) {
    if (!problem.isEmpty())
        throw CommandError(isWrongOption ? ExitCode::invalidScenario : ExitCode::unreadableInput,
                           std::vector{about(name, problem)});
    std::vector<Message> lines;
    for (const std::string& question : questions)
        lines.push_back(
            about(name, {translatable("the table does not state: %1; give %2, see drillwave signal"),
                         {question, std::string(answerTo(question))}}));
    if (!lines.empty()) throw CommandError(ExitCode::invalidScenario, lines);
}

void applySignal(ScenarioDocument& document, const Arguments& arguments, const std::string& path) {
    Scenario& scenario = document.scenario;
    const std::optional<std::string> record = arguments.value("signal");
    if (!record) {
        if (arguments.has("signals")) return;  // `identify` reads records of gauges by the same options
        for (const OptionSpec& option : recordOptionSpecs())
            if (arguments.has(option.name))
                refuseUsage({translatable("%1 applies to a record; add --signal FILE"), {option.text()}});
        return;
    }
    if (!hasUnits(scenario))
        throw CommandError(
            ExitCode::invalidScenario,
            about(path, translatable("is given by its dimensionless groups; --signal needs physical units")));
    const SignalOptions options = signalOptionsOf(arguments);
    RereadableInput input(*record, RereadableInput::mostKept, arguments.style());
    const SignalBar struck = hasUnits(scenario) ? barAt(scenario, 0) : SignalBar();
    SignalReading reading = readSignal(input.stream(), options, struck);
    const std::string name = inputName(*record);
    checkReading(name, reading.problem, reading.isWrongOption, reading.questions);
    for (const SignalRemark& remark : reading.remarks) {
        printRemark({translatable("%1: warning: %2"), {name, remark.text}}, arguments.style());
        document.recordRemarks.push_back(about(name, remark.text));
    }
    scenario = withForce(scenario);
    SignalRecipe recipe = reading.recipe;
    recipe.points = mostPoints;
    ThinnedBlow blow;
    if (arguments.has("all-samples"))
        blow.signal = shapedSignal(reading.samples, recipe);
    else
        blow = thinnedBlow(scenario, reading.samples, recipe);
    Pulse pulse;
    pulse.shape = PulseShape::table;
    pulse.tablePoints = blow.signal.points;
    scenario.pulse = pulse;
    if (blow.isThinned)
        printRemark(
            {translatable(
                 "%1: note: %2 of %3 samples are kept, impulse and e to 1e-4; --all-samples keeps all"),
             {name, std::to_string(blow.signal.points.size()), std::to_string(blow.signal.samples)}},
            arguments.style());
}

}  // namespace drillwave
