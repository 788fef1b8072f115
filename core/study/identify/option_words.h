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

/// Value read from a word of the command line, or the reason why the word was refused.
template <class Value>
struct ReadWord {
    Value value;
    Message problem;            ///< empty if the word was read
    bool hasOtherForm = false;  ///< whether the word lacks the form of its option, such as KEY=+-TOLERANCE
};

/// Returns the strain gauge described by a word COLUMN@DISTANCE, or by A+B@DISTANCE for a pair of gauges with
/// two columns.
ReadWord<GaugeChoice> readGaugeWord(const std::string& word);
/// Returns a strain gauge as a word COLUMN@DISTANCE; the inverse of readGaugeWord().
std::string gaugeWord(const GaugeChoice& gauge);

/// Returns the tolerance described by a word KEY=+-TOLERANCE of option --known. A tolerance in per cent
/// refers to the value of that size in `scenario`.
ReadWord<KnownTolerance> readKnownWord(const std::string& word, const Scenario& scenario);
/// Returns a tolerance as a word KEY=+-TOLERANCE of option --known; the inverse of readKnownWord().
std::string knownWord(const KnownTolerance& known);

/// Returns a percentage such as "2%" as a share, 0.02; nothing for any other text.
std::optional<double> percentageOf(std::string_view text);

}  // namespace drillwave
