// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/design_options.h"

#include <algorithm>
#include <bit>

#include "app/input_text.h"
#include "app/preset_options.h"
#include "app/row_options.h"
#include "core/study/design/design_check.h"
#include "core/study/design/design_texts.h"
#include "core/study/rows/study_plan.h"
#include "core/text/decimal_text.h"
#include "core/text/name_text.h"

namespace drillwave {

namespace {

/// The words of one option, or of the file where the option is not given.
struct Wanted {
    std::vector<std::string> words;
    std::string name;  ///< for messages: "--choose", "design.choose"
};

Wanted wantedOf(const Arguments& arguments, const std::string& option, const std::string& key,
                const std::vector<std::string>& ofFile) {
    if (arguments.has(option)) return {arguments.values(option), "--" + option};
    return {ofFile, "design." + key};
}

void readAims(const Arguments& arguments, const DesignSetup& setup, DesignStudy& study,
              DesignFaults& faults) {
    Wanted wanted = wantedOf(arguments, "aim", "aims", setup.aims);
    for (const std::string& word : arguments.operands()) {
        if (!isAimWord(word)) continue;
        if (!arguments.has("aim"))
            return faults.add(ExitCode::usage,
                              {translatable("`%1`: write --aim before it"), {shortened(word)}});
        wanted.words.push_back(word);
    }
    for (const std::string& word : wanted.words) {
        ParsedAim parsed = parseAim(word);
        if (parsed.problem.isEmpty())
            study.aims.push_back(parsed.aim);
        else
            faults.add(ExitCode::usage, about(wanted.name + " " + shortened(word), parsed.problem));
    }
    if (wanted.words.empty()) study.aims = customaryAims(study.base);
}

void readLimits(const Wanted& wanted, bool atMost, DesignStudy& study, DesignFaults& faults) {
    for (const std::string& word : wanted.words) {
        const ParsedLimit parsed = parseLimit(word, atMost, study.base);
        if (parsed.problem.isEmpty())
            study.limits.push_back(parsed.limit);
        else
            faults.add(parsed.isMistyped ? ExitCode::usage : ExitCode::invalidScenario,
                       about(wanted.name + " " + shortened(word), parsed.problem));
    }
}

/// Returns the part before the equals sign, empty without one.
std::string keyOfWord(const std::string& word) {
    const std::size_t equals = word.find('=');
    return equals == std::string::npos ? std::string() : word.substr(0, equals);
}

void readUncertain(const Wanted& wanted, DesignStudy& study, std::vector<NamedKey>& unread,
                   DesignFaults& faults) {
    for (const std::string& word : wanted.words) {
        ParsedUncertain parsed = parseUncertain(word);
        if (parsed.problem.isEmpty()) {
            study.uncertain.push_back(std::move(parsed.input));
            continue;
        }
        if (const std::string key = keyOfWord(word); findParameter(key))
            unread.push_back({key, false, word.find('%') != std::string::npos});
        faults.add(parsed.isMistyped ? ExitCode::usage : ExitCode::invalidScenario,
                   about(wanted.name, parsed.problem));
    }
}

void readChoices(const Wanted& wanted, const PresetLookup& lookup, DesignStudy& study,
                 std::vector<NamedKey>& unread, DesignFaults& faults) {
    for (const std::string& word : wanted.words) {
        ParsedAxis parsed = parseChoice(word, study.base, lookup);
        if (parsed.problem.isEmpty()) {
            study.choices.push_back(std::move(parsed.axis));
            continue;
        }
        const std::string key = keyOfWord(word);
        const bool isUnknown =
            !key.empty() && key != pulseShapeKey && !findParameter(key) && !choosesPresets(word);
        if (findParameter(key)) unread.push_back({key, true});
        faults.add(parsed.kind == ParsedAxis::Kind::badValue || isUnknown ? ExitCode::invalidScenario
                                                                          : ExitCode::usage,
                   about(wanted.name, parsed.problem));
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
    return beginsAsAim(word);
}

DesignStudy designStudyOf(const Arguments& arguments, const Scenario& base, const DesignSetup& setup,
                          DesignFaults& faults) {
    DesignStudy study;
    study.base = base;
    std::vector<NamedKey> unread;
    Wanted uncertain = wantedOf(arguments, "uncertain", "uncertain", setup.uncertain);
    if (!arguments.has("uncertain") && arguments.has("draws")) uncertain.words.clear();
    readUncertain(uncertain, study, unread, faults);
    readDrawsOf(arguments, study, faults);
    readChoices(wantedOf(arguments, "choose", "choose", setup.choose), presetLookup(arguments), study, unread,
                faults);
    readAims(arguments, setup, study, faults);
    readLimits(wantedOf(arguments, "at-most", "at_most", setup.atMost), true, study, faults);
    readLimits(wantedOf(arguments, "at-least", "at_least", setup.atLeast), false, study, faults);
    const std::uint64_t ofFile =
        setup.samples.value_or(static_cast<std::uint64_t>(studyPlan(base).designSamples));
    const long samples =
        arguments.number("samples", static_cast<long>(ofFile), 1, static_cast<long>(mostDesignSamples));
    study.samples = std::max(leastDesignSamples, std::bit_ceil(static_cast<std::uint64_t>(samples)));
    study.seed = static_cast<std::uint64_t>(arguments.number(
        "seed", static_cast<long>(setup.seed.value_or(1)), 0, std::numeric_limits<long>::max()));
    study.keepsEnergy =
        !arguments.has("no-keep-energy") && (arguments.has("keep-energy") || setup.keepEnergy);
    study.workLimit = workLimitOf(arguments);
    // Words that could not be read are missing in the study: do not report missing input as well.
    const bool hasWords = !uncertain.words.empty() || arguments.has("draws");
    for (const DesignProblemLine& line : problemsOf(study, {}, unread)) {
        if (hasWords && study.dimensions() == 0 && line.isUsage) continue;
        faults.add(line.isUsage ? ExitCode::usage : ExitCode::invalidScenario, line.text);
    }
    return study;
}

}  // namespace drillwave
