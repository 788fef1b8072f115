// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/design_options.h"

#include <algorithm>
#include <bit>

#include "app/input_text.h"
#include "app/row_options.h"
#include "core/study/design/design_check.h"
#include "core/text/decimal_text.h"
#include "core/text/nearest_name.h"

namespace drillwave {

namespace {

/// "thrust@q95" as its parts, with what is wrong.
struct OutputStatistic {
    const Output* output = nullptr;
    Statistic statistic;
    Message problem;
};

OutputStatistic readStatistic(std::string_view word) {
    const std::size_t at = word.find('@');
    if (at == std::string_view::npos)
        return {{},
                {},
                {translatable("drillwave::Message", "`%1` needs OUTPUT@STATISTIC, as efficiency@q05"),
                 {shortened(word)}}};
    const OutputChoice output = chooseOutputs(word.substr(0, at), OutputUnits::dimensionless);
    if (!output.problem.isEmpty()) return {{}, {}, output.problem};
    if (output.all)
        return {{}, {}, translatable("drillwave::Message", "`all` are several outputs; name one")};
    const std::string_view statistic = trimmed(word.substr(at + 1));
    const std::optional<Statistic> found = findStatistic(statistic);
    if (!found)
        return {{},
                {},
                {translatable("drillwave::Message",
                              "`%1` is not a statistic; choose from mean, q01 to q99, min, max, nominal"),
                 {shortened(statistic)}}};
    return {output.columns.front().output, *found, {}};
}

void addAim(DesignStudy& study, const std::string& word, DesignFaults& faults) {
    const auto refuse = [&](const Message& problem) {
        faults.add(ExitCode::usage, about("--aim " + shortened(word), problem));
    };
    if (!isAimWord(word))
        return refuse(
            translatable("drillwave::Message", "needs max:OUTPUT@STATISTIC or min:OUTPUT@STATISTIC"));
    const OutputStatistic read = readStatistic(std::string_view(word).substr(4));
    if (!read.problem.isEmpty()) return refuse(read.problem);
    study.aims.push_back(
        {word.starts_with("max") ? Sense::largest : Sense::least, read.output, read.statistic});
}

void readAims(const Arguments& arguments, DesignStudy& study, DesignFaults& faults) {
    std::vector<std::string> words = arguments.values("aim");
    const bool isGiven = !words.empty();
    for (const std::string& word : arguments.operands())
        if (isAimWord(word)) words.push_back(word);
    if (!words.empty() && !isGiven)
        return faults.add(ExitCode::usage, {translatable("drillwave::Message", "`%1`: write --aim before it"),
                                            {shortened(words.front())}});
    for (const std::string& word : words) addAim(study, word, faults);
    if (words.empty()) study.aims = customaryAims(study.base);
}

void addLimit(DesignStudy& study, const std::string& option, const std::string& word, DesignFaults& faults) {
    const auto refuse = [&](ExitCode code, const Message& problem) {
        faults.add(code, about("--" + option + " " + shortened(word), problem));
    };
    const std::size_t equals = word.find('=');
    if (equals == std::string::npos)
        return refuse(ExitCode::usage, translatable("drillwave::Message", "needs OUTPUT@STATISTIC=VALUE"));
    const OutputStatistic read = readStatistic(trimmed(std::string_view(word).substr(0, equals)));
    if (!read.problem.isEmpty()) return refuse(ExitCode::usage, read.problem);
    const bool inUnit = hasUnits(study.base) || read.output->isOnlySi();
    const TypedQuantity value =
        parseQuantity(std::string_view(word).substr(equals + 1),
                      inUnit ? read.output->quantity() : Quantity::ratio, BareNumber::refused);
    if (!value.valid()) return refuse(ExitCode::invalidScenario, value.problem);
    study.limits.push_back({option == "at-most", read.output, read.statistic, value.si});
}

/// In front of the sign of equality, empty without one.
std::string keyOfWord(const std::string& word) {
    const std::size_t equals = word.find('=');
    return equals == std::string::npos ? std::string() : word.substr(0, equals);
}

void readUncertain(const Arguments& arguments, DesignStudy& study, std::vector<NamedKey>& unread,
                   DesignFaults& faults) {
    for (const std::string& word : arguments.values("uncertain")) {
        ParsedUncertain parsed = parseUncertain(word);
        if (parsed.problem.isEmpty()) {
            study.uncertain.push_back(std::move(parsed.input));
            continue;
        }
        if (const std::string key = keyOfWord(word); findParameter(key))
            unread.push_back({key, false, word.find('%') != std::string::npos});
        faults.add(parsed.isMistyped ? ExitCode::usage : ExitCode::invalidScenario,
                   about("--uncertain", parsed.problem));
    }
}

void readChoices(const Arguments& arguments, DesignStudy& study, std::vector<NamedKey>& unread,
                 DesignFaults& faults) {
    for (const std::string& word : arguments.values("choose")) {
        ParsedAxis parsed = parseAxis(word);
        if (parsed.problem.isEmpty()) {
            study.choices.push_back(std::move(parsed.axis));
            continue;
        }
        const std::string key = keyOfWord(word);
        const bool isUnknown = !key.empty() && key != pulseShapeKey && !findParameter(key);
        if (findParameter(key)) unread.push_back({key, true});
        faults.add(parsed.kind == ParsedAxis::Kind::badValue || isUnknown ? ExitCode::invalidScenario
                                                                          : ExitCode::usage,
                   about("--choose", parsed.problem));
    }
}

void readDrawsOf(const Arguments& arguments, DesignStudy& study, DesignFaults& faults) {
    const std::vector<std::string> files = arguments.values("draws");
    if (files.empty()) return;
    RereadableInput input(files.front(), RereadableInput::mostKept, arguments.style());
    ReadDraws read = readDraws(input.stream(), inputName(files.front()));
    for (const Message& line : read.unreadable) faults.add(ExitCode::unreadableInput, line);
    for (const Message& line : read.invalid) faults.add(ExitCode::invalidScenario, line);
    if (read.unreadable.empty() && read.invalid.empty()) study.draws = std::move(read.draws);
}

}  // namespace

void DesignFaults::check() const {
    if (m_faults.empty()) return;
    ExitCode code = m_faults.front().first;
    std::vector<Message> lines;
    for (const auto& [of, line] : m_faults) {
        code = std::min(code, of);
        lines.push_back(line);
    }
    throw CommandError(code, std::move(lines), CommandError::Begin::withOption);
}

bool isAimWord(const std::string& word) {
    return word.starts_with("max:") || word.starts_with("min:");
}

DesignStudy designStudyOf(const Arguments& arguments, const Scenario& base, DesignFaults& faults) {
    DesignStudy study;
    study.base = base;
    std::vector<NamedKey> unread;
    readUncertain(arguments, study, unread, faults);
    readDrawsOf(arguments, study, faults);
    readChoices(arguments, study, unread, faults);
    readAims(arguments, study, faults);
    for (const char* option : {"at-most", "at-least"})
        for (const std::string& word : arguments.values(option)) addLimit(study, option, word, faults);
    const long samples =
        arguments.number("samples", customarySamples(base), 1, static_cast<long>(mostDesignSamples));
    study.samples = std::max(leastDesignSamples, std::bit_ceil(static_cast<std::uint64_t>(samples)));
    study.seed = static_cast<std::uint64_t>(arguments.number("seed", 1, 0, std::numeric_limits<long>::max()));
    study.keepsEnergy = arguments.has("keep-energy");
    study.workLimit = workLimitOf(arguments);
    // What could not be read is missing there: it is not told a second time that nothing is given.
    const bool hasWords = arguments.has("uncertain") || arguments.has("draws");
    for (const DesignProblemLine& line : problemsOf(study, {}, unread)) {
        if (hasWords && study.dimensions() == 0 && line.isUsage) continue;
        faults.add(line.isUsage ? ExitCode::usage : ExitCode::invalidScenario, line.text);
    }
    return study;
}

}  // namespace drillwave
