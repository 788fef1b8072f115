// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/identify_report.h"

#include "core/model/parameter.h"
#include "core/model/version.h"
#include "core/text/units.h"

namespace drillwave {

namespace {

std::string_view unitOfIdentified(const std::string& key) {
    const std::string_view unit = unitsOf(findParameter(key)->quantity).front().name;
    return unit.empty() ? "1" : unit;
}

JsonArray budgetJson(const IdentifiedParameter& parameter) {
    JsonArray rows;
    for (const BudgetRow& row : parameter.budget)
        rows.emplace_back(JsonObject{{"source", row.source},
                                     {"key", row.key},
                                     {"tolerance", row.tolerance},
                                     {"unit", row.unit},
                                     {"assumed", row.isAssumed},
                                     {"effect", row.effect}});
    return rows;
}

JsonArray parametersJson(const RecordAnswer& answer, const IdentifyFindings* several) {
    JsonArray array;
    for (const IdentifiedParameter& parameter : answer.parameters) {
        JsonObject object{{"key", parameter.key},           {"unit", unitOfIdentified(parameter.key)},
                          {"value", parameter.value},       {"low", Json(parameter.low)},
                          {"high", Json(parameter.high)},   {"verdict", name(parameter.verdict)},
                          {"reason", parameter.reason},     {"noise", parameter.noise},
                          {"budget", budgetJson(parameter)}};
        if (several)
            for (const NextBlowParameter& next : several->nextBlow) {
                if (next.key != parameter.key) continue;
                object["value"] = next.value;
                object["low"] = next.low;
                object["high"] = next.high;
                object["scatter"] = next.scatter;
            }
        array.emplace_back(std::move(object));
    }
    return array;
}

JsonObject matchJson(const RecordAnswer& answer) {
    const MatchFigures& match = answer.match;
    JsonArray zero;
    for (const ZeroLine95& line : match.zero)
        zero.emplace_back(JsonObject{{"offset", line.offset}, {"slope", line.slope}});
    JsonObject object{{"misfit", match.misfit},
                      {"noise", match.noise},
                      {"expected", match.expected},
                      {"ratio", match.ratio},
                      {"autocorrelation", match.autocorrelation},
                      {"samples", match.samples},
                      {"from", match.from},
                      {"to", match.to},
                      {"round_trip", match.roundTrip},
                      {"round_trip_of_file", match.roundTripOfFile},
                      {"shift_of_second", match.shiftOfSecond},
                      {"gain_of_second", match.gainOfSecond},
                      {"quiet", match.quiet},
                      {"unexplained", match.unexplained},
                      {"before", match.before},
                      {"bending", match.bending},
                      {"clipped", match.isClipped},
                      {"step", match.step},
                      {"zero", std::move(zero)},
                      {"droop", match.droop},
                      {"gain_of_return", match.gainOfReturn}};
    if (match.dispersion)
        object["dispersion"] =
            JsonObject{{"share", *match.dispersion}, {"half_width", Json(match.dispersionHalfWidth)}};
    if (match.jumpTime) object["zero_jump"] = *match.jumpTime;
    return object;
}

JsonArray lawsJson(const RecordAnswer& answer) {
    JsonArray array;
    for (const TriedLaw& law : answer.laws) {
        JsonObject parameters;
        for (const auto& [key, value] : law.parameters) parameters[key] = value;
        array.emplace_back(JsonObject{{"law", law.law},
                                      {"misfit", law.misfit},
                                      {"ratio", law.ratio},
                                      {"parameters", std::move(parameters)}});
    }
    return array;
}

Json checkJson(const RecordAnswer& answer) {
    if (!answer.check) return {};
    const BlindCheck& check = *answer.check;
    return Json(JsonObject{{"error", check.error},
                           {"gain", check.gain},
                           {"scaled_error", check.scaledError},
                           {"shift", check.shift}});
}

JsonArray remarksJson(const RecordAnswer& answer, const std::vector<std::string>& further,
                      const Scenario& scenario) {
    JsonArray array;
    const auto add = [&](const std::string& code) {
        array.emplace_back(JsonObject{{"level", isRemarkShown(code) ? "warning" : "information"},
                                      {"code", code},
                                      {"parameter", ""},
                                      {"text", identifyRemark(code, answer, scenario, plainStyle()).text()}});
    };
    for (const std::string& code : answer.remarks) add(code);
    for (const std::string& code : further) add(code);
    return array;
}

JsonObject recordJson(const RecordAnswer& answer, const Scenario& scenario) {
    JsonObject object{{"file", answer.file}, {"blow", answer.blow + 1}};
    if (answer.refusal) {
        object["model"] = "refused";
        object["refusal"] = JsonObject{{"code", answer.refusal->code}, {"text", answer.refusal->text.text()}};
        return object;
    }
    object["model"] = name(answer.model);
    object["law"] = answer.law;
    object["parameters"] = parametersJson(answer, nullptr);
    object["match"] = matchJson(answer);
    object["remarks"] = remarksJson(answer, {}, scenario);
    return object;
}

}  // namespace

std::string identifyJson(const IdentifyReport& report) {
    const IdentifyFindings& findings = report.findings;
    const RecordAnswer& answer = findings.main();
    const bool isSeveral = findings.records.size() > 1;
    JsonObject object{{"version", versionText},
                      {"title", report.question.scenario.title},
                      {"model", answer.refusal ? "rejected" : name(answer.model)},
                      {"law", answer.law},
                      {"parameters", parametersJson(answer, isSeveral ? &findings : nullptr)},
                      {"match", matchJson(answer)},
                      {"laws", lawsJson(answer)},
                      {"check", checkJson(answer)},
                      {"sign", answer.sign},
                      {"scenario", report.identifiedText},
                      {"remarks", remarksJson(answer, findings.remarks, report.question.scenario)}};
    if (const auto next = nextMeasurement(answer))
        object["next"] = JsonObject{{"source", next->source},       {"key", next->key},
                                    {"tolerance", next->tolerance}, {"unit", next->unit},
                                    {"parameter", next->parameter}, {"half_width", next->halfWidth}};
    else
        object["next"] = Json();
    if (isSeveral) {
        JsonArray records;
        for (const RecordAnswer& record : findings.records)
            records.emplace_back(recordJson(record, report.question.scenario));
        object["records"] = std::move(records);
    }
    return Json(std::move(object)).text();
}

}  // namespace drillwave
