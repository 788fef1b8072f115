// SPDX-License-Identifier: GPL-3.0-or-later
// Texts of the core library that the window translates by coreText(), which the catalogues must contain.
#pragma once

#include <set>
#include <string>
#include <string_view>

#include "core/blow/outputs.h"
#include "core/model/law_parameter.h"
#include "core/model/parameter.h"
#include "core/model/preset.h"
#include "core/model/section_field.h"
#include "core/model/section_words.h"
#include "core/report/accuracy_columns.h"
#include "core/report/feed_words.h"
#include "core/study/drilling/drilling_record.h"
#include "core/yaml/examples.h"
#include "core/yaml/preset_file.h"

namespace drillwave::test {

/// Returns labels, meanings and names from the tables of the core library, each once and none empty.
inline std::set<std::string> coreTexts() {
    std::set<std::string> texts;
    const auto add = [&](std::string_view text) { texts.emplace(text); };
    const auto addName = [&](std::string_view name) {
        std::string words(name);
        std::ranges::replace(words, '_', ' ');
        add(words);
    };
    const auto addParameter = [&](const Parameter& parameter) {
        // These have labels with a number in them, which ui/text/shown_text.cpp composes.
        if (cornerOf(parameter) == 0) add(parameter.label);
        add(parameter.rules.shortLabel);
        add(parameter.meaning);
    };
    for (const Parameter& parameter : parameters()) {
        addParameter(parameter);
        if (const KeptParameter byRatio = inScales(parameter)) addParameter(*byRatio);
    }
    for (const char* field : {"force", "slope"}) addParameter(*findParameter(cornerKey(1, field)));
    addParameter(*findParameter("string.repeat"));
    for (const SectionField& field : sectionFields()) {
        add(field.label);
        add(field.meaning);
    }
    for (const Output& output : outputs()) {
        add(output.label());
        add(output.title);
        add(output.note);
        add(output.meaning);
        if (output.label().empty()) addName(output.name);
    }
    for (const Output& output : drillOutputs()) {
        add(output.title);
        add(output.meaning);
    }
    for (const std::string_view name : customarySectionNames()) add(name);
    for (const PresetPart part : allValues<PresetPart>) add(name(part));
    for (const FeedState state : allValues<FeedState>) add(feedWord(state));
    for (const ThrustCase which : allValues<ThrustCase>) add(labelOf(which));
    for (const DrillingOutcome outcome : allValues<DrillingOutcome>) add(name(outcome));
    for (const PulseShape shape : allValues<PulseShape>) addName(name(shape));
    for (const RockLaw law : allValues<RockLaw>) add(phrase(law));
    for (const auto& column : accuracyColumns) add(column.title);
    for (const auto& column : stringAccuracyColumns) add(column.title);
    for (const Example& example : builtInExamples()) {
        add(example.title);
        add(example.explanation);
    }
    for (const Preset& preset : builtInPresets()) {
        add(preset.name);
        add(preset.shapeSource);
        add(preset.lawSource);
        for (const PresetValue& value : preset.values) add(value.source);
    }
    for (const SectionPreset& preset : builtInSectionPresets()) {
        add(preset.name);
        add(preset.source);
        if (!preset.strengthSource.empty()) add(preset.strengthSource);
    }
    texts.erase(std::string());
    return texts;
}

}  // namespace drillwave::test
