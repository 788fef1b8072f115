// SPDX-License-Identifier: GPL-3.0-or-later
// Gauges, tolerances and choices of an identification as words of the command line: reading and writing.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/study/identify/gauge_reading.h"
#include "core/study/identify/identify_question.h"
#include "core/text/enum_names.h"
#include "core/text/message.h"

namespace drillwave {

inline constexpr EnumNames<LawChoice> lawChoiceNames{{{LawChoice::automatic, "auto"},
                                                      {LawChoice::bilinear, "bilinear"},
                                                      {LawChoice::corner, "corner"},
                                                      {LawChoice::file, "file"}}};
inline constexpr EnumNames<DispersionChoice> dispersionChoiceNames{
    {{DispersionChoice::fit, "fit"}, {DispersionChoice::bar, "bar"}, {DispersionChoice::none, "none"}}};

/// Value read from a word, or why the word was refused.
template <class Value>
struct ReadWord {
    Value value;
    Message problem;            ///< empty if the word was read
    bool hasOtherForm = false;  ///< whether the word lacks the form of its option, such as KEY=+-TOLERANCE
};

/// Returns the gauge of a word COLUMN@DISTANCE or A+B@DISTANCE.
ReadWord<GaugeChoice> readGaugeWord(const std::string& word);
/// Returns the word that readGaugeWord() reads back as the same gauge.
std::string gaugeWord(const GaugeChoice& gauge);

/// Returns the tolerance of a word KEY=+-TOLERANCE. A percentage of a size is a share of its value in
/// `scenario`.
ReadWord<KnownTolerance> readKnownWord(const std::string& word, const Scenario& scenario);
/// Returns the word that readKnownWord() reads back as the same tolerance.
std::string knownWord(const KnownTolerance& known);

/// Returns a percentage such as "2%" as a share, 0.02; nothing for any other text.
std::optional<double> percentageOf(std::string_view text);

}  // namespace drillwave
