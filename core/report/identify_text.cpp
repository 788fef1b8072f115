// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/identify_report.h"

#include <algorithm>
#include <cmath>

#include "core/report/report_text.h"

namespace drillwave {

namespace {

constexpr std::size_t mostLimits = 6;  ///< causes of the error that are shown

class IdentifyWriter {
  public:
    IdentifyWriter(const IdentifyReport& report, const ReadingStyle& style)
        : m_report(report), m_style(style) {}

    std::string text() {
        const IdentifyFindings& findings = m_report.findings;
        const RecordAnswer& answer = findings.main();
        m_text = m_report.question.scenario.title;
        if (!m_text.empty()) m_text += ", ";
        m_text += findings.records.size() > 1
                      ? said({translatable("%1 records"), {std::to_string(findings.records.size())}})
                      : answer.file;
        m_text += "\n";
        m_text += paragraph(m_style.said(identifySentence(answer)));
        if (findings.records.size() > 1) addRecords();
        if (answer.refusal) return m_text;
        addParameters(answer);
        if (answer.model != ModelVerdict::rejected && answer.law != "file") addLimits(answer);
        addMatch(answer);
        for (const std::string& code : answer.remarks)
            if (code != "assumed_tolerances" && code != "dispersion_corrected" && code != "law_tried")
                line(said(translatable("remark")), said(identifyRemark(code, answer, m_style)));
        for (const std::string& code : findings.remarks)
            line(said(translatable("remark")), said(identifyRemark(code, answer, m_style)));
        return m_text;
    }

  private:
    std::string said(const Message& message) const { return m_style.said(message); }
    std::string percent(double share, int digits = 2) const {
        return m_style.number(100 * share, digits) + " %";
    }

    void line(const std::string& head, const std::string& words) {
        m_text += "  " + head + std::string(head.size() < 12 ? 12 - head.size() : 1, ' ') + words + "\n";
    }

    struct Names {
        const char *what, *term;
        Quantity quantity;
    };
    static Names namesOf(const std::string& key) {
        if (key == "bit_rock.stiffness")
            return {translatable("rock when it is first loaded"), translatable("stiffness"),
                    Quantity::stiffness};
        if (key == "bit_rock.gamma") return {translatable("springback"), "gamma", Quantity::ratio};
        if (key == "bit_rock.gap")
            return {translatable("bit not seated"), translatable("gap"), Quantity::length};
        if (key == "bit_rock.corner.1.force")
            return {translatable("force at which the rock yields"), translatable("corner"), Quantity::force};
        return {translatable("slope after yielding"), translatable("slope"), Quantity::ratio};
    }

    std::string verdictText(const IdentifiedParameter& parameter, const Names& names) const {
        const auto shown = [&](double value) { return m_style.quantity(value, names.quantity, 3); };
        switch (parameter.verdict) {
            case ParameterVerdict::identified:
                return said(translatable("known"));
            case ParameterVerdict::uncertain:
                return said(translatable("uncertain"));
            case ParameterVerdict::bounded:
                if (parameter.high) return said({translatable("less than %1"), {shown(*parameter.high)}});
                if (parameter.low) return said({translatable("more than %1"), {shown(*parameter.low)}});
                return said(translatable("bounded"));
            case ParameterVerdict::notSeen:
                if (parameter.reason == "no_contact") return said(translatable("not seen: no contact"));
                if (parameter.reason == "front") return said(translatable("not seen: the rock is too stiff"));
                return said(translatable("not seen: the record ends before the rock unloads"));
            case ParameterVerdict::rejected:
                break;
        }
        return said(translatable("not known"));
    }

    void addParameters(const RecordAnswer& answer) {
        TextGrid grid(CellAlignment::left);
        for (const IdentifiedParameter& parameter : answer.parameters) {
            const Names names = namesOf(parameter.key);
            const bool isRejected = answer.model == ModelVerdict::rejected;
            std::string interval;
            if (parameter.low && parameter.high)
                interval = m_style.quantity(*parameter.low, names.quantity, 4) + " … " +
                           m_style.quantity(*parameter.high, names.quantity, 4);
            grid.add({said(names.what), said(names.term),
                      m_style.quantity(parameter.value, names.quantity, 4), isRejected ? "" : interval,
                      verdictText(parameter, names)});
        }
        for (const NextBlowParameter& next : m_report.findings.nextBlow) {
            const Names names = namesOf(next.key);
            grid.add({said(translatable("next blow")), said(names.term),
                      m_style.quantity(next.value, names.quantity, 4),
                      m_style.quantity(next.low, names.quantity, 4) + " … " +
                          m_style.quantity(next.high, names.quantity, 4),
                      said(next.hasChange ? translatable("changes from blow to blow")
                                          : translatable("no change is seen"))});
        }
        if (!grid.rows().empty()) m_text += "\n" + grid.text();
    }

    std::string causeText(const std::string& source, const std::string& key) const {
        if (!key.empty() && key != "gauge" && key != "gain" && key != "material") return key;
        if (source == "noise") return said(translatable("noise"));
        if (source == "tail") return said(translatable("tail of the blow"));
        if (source == "timing") return said(translatable("arrival of the reflection"));
        if (source == "material") return said(translatable("modulus and density"));
        if (source == "gain") return said(translatable("gain of the amplifier"));
        if (source == "place") return said(translatable("distance between the gauges"));
        if (source == "resolution") return said(translatable("steepness of the rock in noise"));
        if (source == "law") return said(translatable("law of the rock"));
        if (source == "step") return said(translatable("step of the recorder"));
        if (source == "unexplained_wave") return said(translatable("unexplained waves"));
        return source;
    }

    std::string toleranceText(const BudgetRow& row) const {
        if (row.tolerance <= 0 || row.source == "tail" || row.source == "unexplained_wave" ||
            row.source == "timing" || row.source == "resolution")
            return {};
        const std::string value = row.unit == "m"   ? m_style.quantity(row.tolerance, Quantity::length, 2)
                                  : row.unit == "N" ? m_style.quantity(row.tolerance, Quantity::force, 2)
                                                    : percent(row.tolerance);
        return row.isAssumed ? said({translatable("assumed +-%1"), {value}}) : "+-" + value;
    }

    void addLimits(const RecordAnswer& answer) {
        struct Limit {
            std::string cause, tolerance;
            double stiffness, gamma;
        };
        const IdentifiedParameter &stiffness = answer.parameters[0], &gamma = answer.parameters[1];
        std::vector<Limit> limits{{causeText("noise", ""), "", stiffness.noise, gamma.noise}};
        for (std::size_t i = 0; i < stiffness.budget.size(); ++i) {
            const BudgetRow& row = stiffness.budget[i];
            limits.push_back(
                {causeText(row.source, row.key), toleranceText(row), row.effect, gamma.budget[i].effect});
        }
        std::stable_sort(limits.begin(), limits.end(), [](const Limit& a, const Limit& b) {
            return std::hypot(a.stiffness, a.gamma) > std::hypot(b.stiffness, b.gamma);
        });
        limits.resize(std::min(limits.size(), mostLimits));
        TextGrid grid(CellAlignment::left);
        grid.add({said(translatable("Limits of the result")), said(translatable("stiffness")),
                  said(translatable("springback")), ""});
        for (const Limit& limit : limits)
            if (std::max(limit.stiffness, limit.gamma) > 5e-4)
                grid.add({"  " + limit.cause, percent(std::min(limit.stiffness, 99.0)),
                          percent(std::min(limit.gamma, 99.0)), limit.tolerance});
        m_text += "\n" + grid.text();
        if (const auto next = nextMeasurement(answer)) m_text += "  " + said(nextText(*next, answer)) + "\n";
        m_text += "\n";
    }

    Message nextText(const NextMeasurement& next, const RecordAnswer& answer) const {
        const Message gain = {translatable("%1 +-%2"),
                              {said(namesOf(next.parameter).term), percent(next.halfWidth)}};
        for (const IdentifiedParameter& parameter : answer.parameters)
            if (parameter.verdict == ParameterVerdict::notSeen && parameter.reason == "no_unloading")
                return translatable("To know more: record until the rock has unloaded.");
        if (next.source == "noise" || next.source == "law" || next.source == "resolution")
            return {translatable("To know more: average 4 blows: %1."), {gain}};
        if (next.source == "unexplained_wave" || next.source == "tail")
            return {translatable("To know more: use gauges on opposite sides, or a second gauge: %1."),
                    {gain}};
        if (next.source == "step")
            return {translatable("To know more: use a smaller range or more bits: %1."), {gain}};
        if (next.source == "timing")
            return {translatable("To know more: measure the distance of the gauge from the bit: %1."),
                    {gain}};
        const std::string tolerance = next.unit == "m" ? m_style.quantity(next.tolerance, Quantity::length, 2)
                                                       : percent(next.tolerance);
        return {translatable("To know more: measure %1 to %2: %3."),
                {causeText(next.source, next.key), tolerance, gain}};
    }

    void addMatch(const RecordAnswer& answer) {
        const MatchFigures& match = answer.match;
        if (answer.model == ModelVerdict::rejected || answer.law == "file") m_text += "\n";
        line(said(translatable("match")),
             said({translatable("the model leaves %1 of the peak, noise leaves %2"),
                   {percent(match.misfit), percent(match.expected)}}));
        line(said(translatable("in quiet")),
             said({translatable("%1 of the peak where nothing should be (bending and the like)"),
                   {percent(match.quiet)}}));
        Message timing{translatable("reflection after %1, the file says %2"),
                       {m_style.quantity(match.roundTrip, Quantity::time, 4),
                        m_style.quantity(match.roundTripOfFile, Quantity::time, 4)}};
        if (match.zero.size() > 1)
            timing = {translatable("%1; gain of the second gauge %2"),
                      {timing, m_style.number(match.gainOfSecond, 4)}};
        line(said(translatable("timing")), said(timing));
        if (!match.zero.empty())
            line(said(translatable("zero line")),
                 said({translatable("%1 of the peak, %2 in a millisecond"),
                       {m_style.signedPercent(std::round(1e4 * match.zero[0].offset) / 1e4),
                        m_style.signedPercent(std::round(1e4 * match.zero[0].slope) / 1e4)}}));
        if (answer.check)
            line(said(translatable("check")),
                 said({translatable(
                           "the wave behind the specimen is predicted within %1 of its peak, %2 late"),
                       {percent(answer.check->error),
                        m_style.quantity(answer.check->shift, Quantity::time, 2)}}));
        if (answer.laws.size() > 1) {
            std::string laws;
            for (const TriedLaw& law : answer.laws)
                laws += (laws.empty() ? "" : ", ") + law.law + " " + percent(law.misfit);
            line(said(translatable("laws tried")), laws);
        }
    }

    void addRecords() {
        TextGrid grid(CellAlignment::left);
        constexpr std::size_t most = 20;
        std::size_t count = 0;
        for (const RecordAnswer& record : m_report.findings.records) {
            if (++count > most) break;
            std::string name = record.file;
            if (m_report.question.allBlows) name += ", " + std::to_string(record.blow + 1);
            if (record.refusal) {
                grid.add({name, said(translatable("refused"))});
                continue;
            }
            const auto value = [&](const char* key, Quantity quantity) {
                const IdentifiedParameter* parameter = record.find(key);
                return parameter ? m_style.quantity(parameter->value, quantity, 3) : std::string();
            };
            grid.add({name, std::string(drillwave::name(record.model)),
                      value("bit_rock.stiffness", Quantity::stiffness),
                      value("bit_rock.gamma", Quantity::ratio), percent(record.match.misfit)});
        }
        m_text += grid.text();
    }

    const IdentifyReport& m_report;
    const ReadingStyle& m_style;
    std::string m_text;
};

}  // namespace

std::string identifyText(const IdentifyReport& report, const ReadingStyle& style) {
    return IdentifyWriter(report, style).text();
}

}  // namespace drillwave
