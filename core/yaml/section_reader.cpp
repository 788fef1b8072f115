// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/yaml/section_reader.h"

#include <algorithm>
#include <tuple>

#include "core/model/parameter.h"
#include "core/model/parameter_text.h"
#include "core/text/decimal_text.h"
#include "core/text/name_text.h"

namespace drillwave {

namespace {

constexpr std::size_t maximumProblems = 100;

std::string listOf(const std::vector<std::string_view>& names) {
    std::string text;
    for (const std::string_view name : names) text += (text.empty() ? "" : ", ") + std::string(name);
    return text;
}

/// The name by which messages call a parameter: its path in the file.
std::string pathOf(const Parameter& parameter) {
    return joinedKey(parameter.fileSection(), parameter.localKey());
}

/// ": write for example `length: 3.66 m`", where there is a usual value.
Message example(const Parameter& parameter) {
    const std::optional<double> value = parameter.value(Scenario());
    if (!value) return {};
    return {translatable(": write for example `%1`"),
            {std::string(parameter.localKey()) + ": " +
             formatQuantity(*value, parameter.quantity, parameter.displayUnit())}};
}

}  // namespace

void ProblemList::reportValue(std::size_t offset, std::string_view key, std::string_view value,
                              const Message& reason) {
    reportKey(offset, key, "");
    if (m_leftOut == 0)
        m_problems.back().text = {"%1 (%2)", {std::string(key) + " = " + shortened(trimmed(value)), reason}};
}

void ProblemList::reportKey(std::size_t offset, std::string_view key, const Message& reason) {
    // Finding the place costs a walk through the text: not for problems nobody will see.
    const bool full = m_problems.size() >= maximumProblems;
    const TextPosition at = full ? TextPosition{} : position(offset);
    report({std::string(key), {"%1 (%2)", {shortened(key), reason}}, at.line, at.column});
}

void ProblemList::reportAt(std::size_t offset, InputProblem problem) {
    const TextPosition at = position(offset);
    problem.line = at.line;
    problem.column = at.column;
    report(std::move(problem));
}

void ProblemList::report(InputProblem problem) {
    m_keys.insert(problem.key);
    if (m_problems.size() < maximumProblems)
        m_problems.push_back(std::move(problem));
    else
        ++m_leftOut;
}

std::vector<InputProblem> ProblemList::take() {
    const auto place = [](const InputProblem& p) { return std::tuple(!p.source.empty(), p.line, p.column); };
    std::ranges::stable_sort(m_problems, {}, place);
    if (m_leftOut > 0) {
        const InputProblem& last = m_problems.back();
        m_problems.push_back({"",
                              {translatable("and %1 more problems"), {std::to_string(m_leftOut)}},
                              last.line,
                              last.column});
    }
    return std::move(m_problems);
}

std::size_t YamlEntry::place() const {
    return value->kind == YamlKind::null ? key->offset : value->offset;
}

std::string joinedKey(std::string_view section, std::string_view key) {
    return section.empty() ? std::string(key) : std::string(section) + "." + std::string(key);
}

YamlEntries SectionReader::entriesOf(const YamlNode& map, std::string_view section,
                                     const std::vector<std::string_view>& known) {
    YamlEntries entries;
    for (std::size_t i = 0; i + 1 < map.children.size(); i += 2) {
        const YamlNode& key = map.children[i];
        const std::string path = joinedKey(section, key.text);
        if (std::ranges::find(known, key.text) == known.end()) {
            const std::string_view near = nearestName(key.text, known);
            m_mistyped.insert(joinedKey(section, near));
            m_problems.reportKey(
                key.offset, path,
                near.empty()
                    ? Message(translatable("is not a known key; known here: %1"), {listOf(known)})
                    : Message(translatable("is not a known key, did you mean `%1`?"), {std::string(near)}));
        } else if (!entries.try_emplace(key.text, YamlEntry{&key, &map.children[i + 1]}).second) {
            m_problems.reportKey(key.offset, path, translatable("is given twice"));
        }
    }
    return entries;
}

std::optional<YamlEntries> SectionReader::section(const YamlEntries& file, std::string_view name,
                                                  std::string_view group,
                                                  std::vector<std::string_view> moreKeys) {
    const auto found = file.find(name);
    if (found == file.end()) {
        if (!m_mistyped.contains(name)) reportMissing("", name, translatable("is missing"));
        return std::nullopt;
    }
    const YamlEntry& entry = found->second;
    setPlace(name, entry.key->offset);
    if (entry.value->kind == YamlKind::null) return YamlEntries();
    if (entry.value->kind != YamlKind::map) {
        m_problems.reportKey(entry.place(), name, translatable("must be a section of `key: value` lines"));
        return std::nullopt;
    }
    for (const Parameter& parameter : parameters())
        if (parameter.section() == group) moreKeys.push_back(parameter.localKey());
    return entriesOf(*entry.value, name, moreKeys);
}

void SectionReader::readParameters(const YamlEntries& entries, std::string_view group,
                                   Applicability applicability) {
    for (const Parameter& parameter : parameters()) {
        const auto found = entries.find(parameter.localKey());
        if (parameter.section() != group || found == entries.end()) continue;
        setPlace(parameter.key, found->second.place());
        const Message reason =
            applicability == Applicability::checked ? whyNotApplicable(parameter, m_scenario) : Message();
        if (reason.isEmpty())
            readNumber(parameter, found->second);
        else
            m_problems.reportKey(found->second.key->offset, pathOf(parameter), reason);
    }
}

void SectionReader::readNumber(const Parameter& parameter, const YamlEntry& entry, std::string path) {
    const YamlNode& value = *entry.value;
    if (path.empty()) path = pathOf(parameter);
    setPlace(parameter.key, entry.place());
    if (value.kind != YamlKind::scalar) {
        m_problems.reportKey(entry.place(), path,
                             {value.kind == YamlKind::null ? translatable("has no value%1")
                                                           : translatable("must be one value%1"),
                              {example(parameter)}});
        return;
    }
    const TypedQuantity typed =
        parseQuantity(value.text, parameter.quantity, BareNumber::refused, &parameter.displayUnit());
    const Message reason = typed.valid() ? rangeProblem(parameter, typed.si) : typed.problem;
    if (reason.isEmpty())
        parameter.assign(m_scenario, typed.si);
    else
        m_problems.reportValue(entry.place(), path, value.text, reason);
}

void SectionReader::requireShape(const YamlEntries& entries) {
    if (!isThere(entries, "pulse", "shape"))
        reportMissing("pulse", "shape", {translatable("is missing, one of %1"), {pulseShapeList()}});
}

void SectionReader::require(const YamlEntries& entries, const Parameter& parameter) {
    if (!isThere(entries, parameter.fileSection(), parameter.localKey()))
        reportMissing(parameter.fileSection(), parameter.localKey(),
                      {translatable("is missing%1"), {example(parameter)}});
}

void SectionReader::requireParameters(const YamlEntries& entries, std::string_view group) {
    const auto every = [&](Presence presence, const auto& check) {
        for (const Parameter& parameter : parameters())
            if (parameter.section() == group && parameter.rules.presence == presence &&
                parameter.applies(m_scenario))
                check(parameter);
    };
    every(Presence::required, [&](const Parameter& parameter) { require(entries, parameter); });
    every(Presence::either, [&](const Parameter& parameter) {
        const Parameter& rival = *findParameter(parameter.rules.rival);
        requireOneOf(entries, parameter.fileSection(), parameter.localKey(), rival.localKey());
    });
}

void SectionReader::requireOneOf(const YamlEntries& entries, std::string_view section, std::string_view one,
                                 std::string_view other) {
    const auto second = entries.find(other);
    const bool both = entries.contains(one) && second != entries.end();
    if (!isThere(entries, section, one) && !isThere(entries, section, other))
        reportMissing(section, one, {translatable("is missing: give it or %1"), {joinedKey(section, other)}});
    if (both)
        m_problems.reportKey(
            second->second.key->offset, joinedKey(section, other),
            {translatable("cannot be combined with %1: give one or the other"), {joinedKey(section, one)}});
}

bool SectionReader::isThere(const YamlEntries& entries, std::string_view section,
                            std::string_view key) const {
    return entries.contains(key) || m_mistyped.contains(joinedKey(section, key));
}

void SectionReader::reportMissing(std::string_view section, std::string_view key, const Message& reason) {
    m_problems.reportKey(placeOf(section).value_or(0), joinedKey(section, key), reason);
}

std::optional<std::size_t> SectionReader::placeOf(std::string_view key) const {
    const auto found = m_places.find(key);
    return found == m_places.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace drillwave
