// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/identify_report.h"

#include <algorithm>
#include <span>
#include <utility>

namespace drillwave {

namespace {

/// Row of a table of sentences: a code and its words.
using CodeWords = std::pair<std::string_view, const char*>;

/// The words of a code, else the code.
Message wordsOf(std::string_view code, std::span<const CodeWords> table) {
    const auto found = std::ranges::find(table, code, &CodeWords::first);
    return found == table.end() ? Message(std::string(code)) : Message(found->second);
}

bool isKnownOnBothSides(const IdentifiedParameter* parameter) {
    return parameter && parameter->verdict == ParameterVerdict::identified;
}

bool isCornerSeen(const RecordAnswer& answer) {
    const IdentifiedParameter* slope = answer.find("bit_rock.corner.1.slope");
    return slope && slope->verdict != ParameterVerdict::notSeen;
}

}  // namespace

Message rejectionReason(const RecordAnswer& answer) {
    const MatchFigures& match = answer.match;
    if (answer.has("arrival_off") || answer.has("distance_off"))
        return translatable(
            "The reflection does not arrive at the time computed from the scenario file. Check the distance "
            "of the gauge from the bit, the wave speed, the sampling clock, and whether the file lacks a "
            "section.");
    const bool hasTwoGauges = answer.hasTwoGauges();
    if (answer.has("sizes_off"))
        return hasTwoGauges
                   ? translatable(
                         "The distance between the gauges, or a section between gauge and bit, differs from "
                         "the scenario file. Measure this distance, the bit head and the rod.")
                   : translatable(
                         "A section between gauge and bit differs from the scenario file. Measure the bit "
                         "head and the rod, and check whether the file lacks a section.");
    if (match.quiet > 0.02)
        return translatable(
            "The record shows waves at times when the rod should be at rest. Possible causes: bending (use "
            "gauges on opposite sides of the rod), the blow before, or couplings.");
    if (answer.has("zero_line"))
        return translatable(
            "The zero line of the record drifts by more than the tolerance of the amplifier. Check the zero "
            "and the drift of the amplifier, and whether it is AC or DC coupled.");
    if (answer.has("not_quiet_before"))
        return translatable(
            "The rod still rings from an earlier blow when this blow starts: measure a single blow.");
    return hasTwoGauges
               ? translatable(
                     "Either the rock follows another law, or the scenario file is wrong about a section "
                     "between gauge and bit or the distance between the gauges. Check the bit head and this "
                     "distance first, then see where the measured and the modelled wave differ.")
               : translatable(
                     "Either the rock follows another law, or the sections between gauge and bit differ from "
                     "the scenario file. Check the bit head first, then see where the measured and the "
                     "modelled wave differ.");
}

Message identifySentence(const RecordAnswer& answer) {
    if (answer.refusal) return answer.refusal->text;
    if (answer.model == ModelVerdict::rejected && answer.law == "file")
        return translatable("The record contradicts the rock of the scenario file.");
    if (answer.model == ModelVerdict::rejected)
        return {
            translatable("The model does not agree with the record, so nothing is known about the rock. %1"),
            {rejectionReason(answer)}};
    if (answer.law == "file")
        return answer.model == ModelVerdict::accepted
                   ? translatable("The record agrees with the rock of the scenario file.")
                   : translatable("The record agrees only roughly with the rock of the scenario file.");
    const Message agrees =
        answer.model == ModelVerdict::strained
            ? translatable("The record agrees only roughly with the model.")
        : answer.law == "corner" && isCornerSeen(answer)
            ? translatable(
                  "The record agrees with a rock that yields at one force: its loading curve has one corner.")
            : translatable(
                  "The record agrees with a rock whose force rises along one straight line while the bit "
                  "penetrates.");
    const bool hasStiffness = isKnownOnBothSides(answer.find("bit_rock.stiffness"));
    const bool hasGamma = isKnownOnBothSides(answer.find("bit_rock.gamma"));
    const bool hasGap = isKnownOnBothSides(answer.find("bit_rock.gap"));
    const char* known =
        hasStiffness && hasGamma && hasGap ? translatable(
                                                 "The record determines stiffness and elasticity (gamma) of "
                                                 "the rock, and the gap between bit and rock.")
        : hasStiffness && hasGamma ? translatable(
                                         "Stiffness and elasticity (gamma) of the rock are known, but the "
                                         "gap between bit and rock is not.")
        : hasStiffness
            ? translatable("The stiffness of the rock is known, but its elasticity (gamma) is not.")
        : hasGamma
            ? translatable("The elasticity (gamma) of the rock is known, but its stiffness is not.")
            : translatable("Neither stiffness nor elasticity (gamma) of the rock is known to within 20 %.");
    // The first sentence is the one that is remembered.
    const Message answered = !hasStiffness && !hasGamma
                                 ? Message(translatable("%1 %2"), {Message(known), agrees})
                                 : Message(translatable("%1 %2"), {agrees, Message(known)});
    if (!answer.has("distance_off")) return answered;
    return {
        translatable("%1 %2"),
        {answered,
         translatable(
             "The position of the gauge or the wave speed in the scenario file does not match the record.")}};
}

Message lawWords(std::string_view law) {
    constexpr CodeWords words[] = {
        {"bilinear", translatable("one line")},
        {"corner", translatable("one corner")},
        {"crater", translatable("crater of a blow before")},
        {"power", translatable("power law")},
        {"dashpot", translatable("dashpot")},
        {"overload", translatable("overload of the amplifier")},
        {"jump", translatable("jump of the zero level")},
        {"file", translatable("that of the scenario")},
    };
    return wordsOf(law, words);
}

Message recordsSentence(const IdentifyFindings& findings, const ReadingStyle& style) {
    if (findings.records.size() < 2) return {};
    const Message count{translatable("The model agrees with %1 of %2 records."),
                        {std::to_string(findings.agreeingCount()), std::to_string(findings.records.size())}};
    const auto next = std::ranges::find(findings.nextBlow, "bit_rock.stiffness", &NextBlowParameter::key);
    if (next == findings.nextBlow.end()) return count;
    const Message expected{
        next->hasChange
            ? translatable(
                  "The stiffness of the rock changes from blow to blow: at the next blow, it will be "
                  "between %1 and %2 (95 %).")
            : translatable(
                  "No change of the rock's stiffness is seen from blow to blow: at the next blow, it "
                  "will be between %1 and %2 (95 %)."),
        {style.quantity(next->low, Quantity::stiffness, 4),
         style.quantity(next->high, Quantity::stiffness, 4)}};
    return {"%1 %2", {count, expected}};
}

std::string recordName(const RecordAnswer& answer, bool hasBlows) {
    return hasBlows ? answer.file + ", " + std::to_string(answer.blow + 1) : answer.file;
}

Message recordVerdict(const RecordAnswer& answer) {
    if (answer.refusal) return {translatable("refused: %1"), {answer.refusal->text}};
    return answer.model == ModelVerdict::accepted   ? translatable("agrees")
           : answer.model == ModelVerdict::strained ? translatable("agrees roughly")
                                                    : translatable("does not agree");
}

Message identifyRemark(std::string_view code, const RecordAnswer& answer, const Scenario& scenario,
                       const ReadingStyle& style) {
    const MatchFigures& match = answer.match;
    const auto percent = [&](double share) { return style.number(100 * share, 2) + " %"; };
    const auto time = [&](double seconds) { return style.quantity(seconds, Quantity::time, 4); };
    if (code == "unexplained_wave")
        return {answer.model == ModelVerdict::rejected
                    ? translatable("waves of %1 of the peak are not explained by the model")
                    : translatable(
                          "waves of %1 of the peak are not explained by the model; they widen all intervals"),
                {percent(match.unexplained)}};
    if (code == "not_quiet_before")
        return {translatable("waves of %1 of the peak are there before the front; measure a single blow"),
                {percent(match.before)}};
    if (code == "distance_off")
        return {translatable(
                    "the reflection arrives after %1, the file says %2; a gauge %3 from the bit would fit: "
                    "measure its distance"),
                {time(match.roundTrip), time(match.roundTripOfFile),
                 style.quantity(answer.distanceThatFits, Quantity::length, 4)}};
    if (code == "arrival_off")
        return {translatable("the reflection arrives after %1 instead of %2; check distance, wave speed and "
                             "clock, and look for a section missing in the file"),
                {time(match.roundTrip), time(match.roundTripOfFile)}};
    if (code == "sizes_off" && answer.sizeOff)
        return {answer.hasTwoGauges()
                    ? translatable("%1 changed by %2, or another distance between the gauges, would explain "
                                   "the record; measure both")
                    : translatable("%1 changed by %2 would explain the record; measure it"),
                {sizeWords(answer.sizeOff->key, scenario, style),
                 answer.sizeOff->key.ends_with(".area")
                     ? style.quantity(answer.sizeOff->change, Quantity::area, 2)
                     : shortLength(answer.sizeOff->change, 2, style)}};
    if (code == "zero_jumps" && match.jumpTime)
        return {translatable("a jump of the zero level %1 after the front would explain the record; check "
                             "cable and amplifier"),
                {time(*match.jumpTime)}};
    if (code == "gain_changes")
        return {match.gainOfReturn < 1
                    ? translatable("the returning wave fits better with %1 less gain than the incident wave; "
                                   "check range, glue and cable of the gauge")
                    : translatable("the returning wave fits better with %1 more gain than the incident wave; "
                                   "check range, glue and cable of the gauge"),
                {percent(std::abs(match.gainOfReturn - 1))}};
    constexpr CodeWords sentences[] = {
        {"crater",
         translatable("the rock begins as steep as it springs back: the bit may stand in the crater of a "
                      "blow before, or be pressed into it")},
        {"assumed_tolerances",
         translatable("some tolerances are assumed; give measured ones by --known KEY=+-TOLERANCE")},
        {"zero_line", translatable("the zero line moves by more than its tolerance")},
        {"clipped", translatable("the returning wave is clipped; those samples are left out")},
        {"quiet_short",
         translatable("the quiet time between the blow and its reflection is short; put the gauge "
                      "further from the bit")},
        {"one_sided",
         translatable("there is no gauge on the opposite side of the rod; one would show bending")},
        {"dispersion_corrected", translatable("dispersion between gauge and bit is taken into account")},
        {"law_tried", translatable("other laws were tried because the bilinear law leaves more than noise")},
        {"law_open", translatable("another law explains the record as well; the intervals include it")},
        {"few_records", translatable("fewer than five records say little about how the rock changes")},
        {"further_blows", translatable("the record holds further blows; --blows all identifies each")},
        {"second_reversed", translatable("the second gauge has the other sign; it is reversed")},
        {"unit_doubtful", translatable("the peak stress is unlikely; check the unit of the record")},
        {"gap_or_bend",
         translatable("a rock that stiffens from the start explains the record as well as a gap")},
        {"sizes_off", translatable("a section differs from the file by more than its tolerance")},
        {"zero_jumps", translatable("the zero level jumps within the record")},
    };
    return wordsOf(code, sentences);
}

bool isRemarkShown(std::string_view code) {
    return code != "assumed_tolerances" && code != "dispersion_corrected" && code != "law_tried";
}

std::vector<Message> identifyRemarks(const IdentifyReport& report, const RecordAnswer& answer,
                                     const ReadingStyle& style) {
    std::vector<Message> remarks;
    for (const std::vector<std::string>* codes : {&answer.remarks, &report.findings.remarks})
        for (const std::string& code : *codes)
            if (isRemarkShown(code))
                remarks.push_back(identifyRemark(code, answer, report.question.scenario, style));
    return remarks;
}

}  // namespace drillwave
