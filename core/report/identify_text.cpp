// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/identify_report.h"

#include <algorithm>
#include <cmath>

#include "core/report/report_text.h"

namespace drillwave {

namespace {

/// The blind check names a gain if the error with it is less than this share of the error without.
constexpr double mostAlike = 0.75;

class IdentifyWriter {
  public:
    IdentifyWriter(const IdentifyReport& report, const ReadingStyle& style)
        : m_report(report), m_style(style) {}

    std::string text() {
        const IdentifyFindings& findings = m_report.findings;
        const RecordAnswer& answer = findings.main();
        m_text = m_report.question.scenario.title;
        if (!m_text.empty()) m_text += ", ";
        const bool hasSeveral = findings.records.size() > 1;
        m_text += hasSeveral ? said({translatable("%1 records"), {std::to_string(findings.records.size())}})
                             : answer.file;
        m_text += "\n";
        if (hasSeveral) addRecords();
        const Message sentence = identifySentence(answer);
        const std::string name = recordName(answer, m_report.question.allBlows);
        m_text += paragraph(said(hasSeveral ? Message("%1: %2", {name, sentence}) : sentence));
        if (answer.refusal) return m_text;
        addParameters(answer);
        if (answer.model != ModelVerdict::rejected && answer.law != "file") addLimits(answer);
        addMatch(answer);
        for (const Message& remark : identifyRemarks(m_report, answer, m_style))
            line(said(translatable("remark")), said(remark));
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

    void addParameters(const RecordAnswer& answer) {
        TextGrid grid(CellAlignment::left);
        for (const IdentifyRow& row : identifyRows(answer, m_report.findings.nextBlow, m_style))
            grid.add({said(row.what), said(row.term), row.value, row.interval, said(row.verdict)});
        if (!grid.rows().empty()) m_text += "\n" + grid.text();
    }

    void addLimits(const RecordAnswer& answer) {
        TextGrid grid(CellAlignment::left);
        grid.add({said(translatable("Limits of the result")), said(translatable("stiffness")),
                  said(translatable("elasticity")), ""});
        for (const IdentifyLimit& limit : identifyLimits(answer, m_report.question.scenario, m_style))
            grid.add({"  " + said(limit.cause), said(limitWords(limit.onStiffness, m_style)),
                      said(limitWords(limit.onGamma, m_style)), said(limit.tolerance)});
        m_text += "\n" + grid.text();
        if (const Message next = identifyNext(answer, m_report.question.scenario, m_style); !next.isEmpty())
            m_text += "  " + said(next) + "\n";
        m_text += "\n";
    }

    void addMatch(const RecordAnswer& answer) {
        const MatchFigures& match = answer.match;
        if (answer.model == ModelVerdict::rejected || answer.law == "file") m_text += "\n";
        line(said(translatable("match")),
             said({translatable("beyond noise, the model leaves an rms of %1 of the peak; the noise is %2"),
                   {percent(match.misfit), percent(match.expected)}}));
        line(said(translatable("in quiet")),
             said({translatable("%1 of the peak where nothing should be (bending and the like)"),
                   {percent(match.quiet)}}));
        Message timing{translatable("reflection after %1, the file says %2"),
                       {m_style.quantity(match.roundTrip, Quantity::time, 4),
                        m_style.quantity(match.roundTripOfFile, Quantity::time, 4)}};
        if (answer.hasTwoGauges())
            timing = {translatable("%1; gain of the second gauge %2"),
                      {timing, m_style.number(match.gainOfSecond, 4)}};
        line(said(translatable("timing")), said(timing));
        if (!match.zero.empty())
            line(said(translatable("zero line")),
                 said({translatable("%1 of the peak, %2 in a millisecond"),
                       {m_style.signedPercent(std::round(1e4 * match.zero[0].offset) / 1e4),
                        m_style.signedPercent(std::round(1e4 * match.zero[0].slope) / 1e4)}}));
        if (answer.check) {
            line(said(translatable("check")),
                 said({answer.check->shift < 0
                           ? translatable(
                                 "the wave behind the specimen is predicted with an rms error of %1 of its "
                                 "peak; it was measured %2 earlier")
                           : translatable(
                                 "the wave behind the specimen is predicted with an rms error of %1 of its "
                                 "peak; it was measured %2 later"),
                       {percent(answer.check->error),
                        m_style.quantity(std::abs(answer.check->shift), Quantity::time, 2)}}));
            if (answer.check->scaledError < mostAlike * answer.check->error)
                line({}, said({translatable("a factor of %1 lowers this error to %2: the gain of that gauge "
                                            "or the bar there may differ"),
                               {m_style.number(answer.check->gain, 3), percent(answer.check->scaledError)}}));
        }
        if (answer.laws.size() > 1) {
            std::string laws;
            for (const TriedLaw& law : answer.laws)
                laws += (laws.empty() ? "" : ", ") + said(lawWords(law.law)) + " " + percent(law.misfit);
            line(said(translatable("laws tried")), laws);
        }
    }

    void addRecords() {
        m_text += paragraph(said(recordsSentence(m_report.findings, m_style))) + "\n";
        TextGrid grid(CellAlignment::left);
        grid.add({said(translatable("record")), said(translatable("stiffness")),
                  said(translatable("elasticity")), said(translatable("misfit")),
                  said(translatable("verdict"))});
        constexpr std::size_t most = 20;
        std::size_t count = 0;
        for (const RecordAnswer& record : m_report.findings.records) {
            if (++count > most) break;
            const auto value = [&](const char* key, Quantity quantity) {
                const IdentifiedParameter* parameter = record.find(key);
                return parameter ? m_style.quantity(parameter->value, quantity, 3) : std::string();
            };
            grid.add(
                {recordName(record, m_report.question.allBlows),
                 value("bit_rock.stiffness", Quantity::stiffness), value("bit_rock.gamma", Quantity::ratio),
                 record.refusal ? std::string() : percent(record.match.misfit), said(recordVerdict(record))});
        }
        m_text += grid.text() + "\n";
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
