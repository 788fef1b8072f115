// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/report_studies.h"

#include "core/report/design_report.h"
#include "core/report/design_words.h"
#include "core/report/drilling_report.h"
#include "core/report/html_text.h"
#include "core/report/sequence_words.h"
#include "core/text/printed_text.h"

namespace drillwave {

namespace {

/// Names of a design study as a page prints them.
class PrintedNames : public DesignNames {
  public:
    using DesignNames::DesignNames;

    std::string aimed(const DesignReport& report, const DesignAim& aim, std::size_t design) const override {
        return printedWords(DesignNames::aimed(report, aim, design));
    }
};

/// Returns the rows of a grid with the signs of print.
std::vector<std::vector<std::string>> printedRows(const TextGrid& grid) {
    std::vector<std::vector<std::string>> rows = grid.rows();
    for (std::vector<std::string>& row : rows)
        for (std::string& cell : row) cell = printedWords(cell);
    return rows;
}

std::string paragraphs(const std::vector<Message>& sentences, const ReportElements& page) {
    std::string html;
    for (const Message& sentence : sentences) html += page.paragraph(printedWords(page.said(sentence)));
    return html;
}

std::string drillingHtml(const DrillingResult& result, const ReportElements& page) {
    const ReadingStyle& style = page.style();
    std::string html = page.paragraph(sequenceText(result, style));
    if (result.statistics)
        html +=
            page.table("drilling", htmlRows(sequenceGrid(result, OutputUnits::si, style).rows())) +
            page.paragraph(asSentence(page.said(regimeWords(result, style)))) +
            page.paragraph({translatable("The first %1 of %2 blows are not counted. The rate is an upper "
                                         "limit: all rock under the bit breaks and cuttings are removed."),
                            {std::to_string(result.settings.settle), std::to_string(result.settings.blows)}});
    for (const Alert& alert : result.alerts) html += page.alert(alert);
    return html;
}

std::string scanHtml(const DrillingScan& scan, const DrillingResult* drilling, const ReportElements& page) {
    const std::optional<Sequence> present = drilling ? sequenceOf(*drilling) : std::nullopt;
    return paragraphs(scanSentences(scan, present, page.style()), page);
}

std::string designHtml(const DesignReport& report, const ReportElements& page) {
    const ReadingStyle& style = page.style();
    std::string html = page.heading(translatable("Design study"));
    if (const Message headline = headlineMessage(report, PrintedNames(report.study, style));
        !headline.isEmpty())
        html += page.paragraph(headline);
    return html + paragraphs(designQuestionSentences(report, style), page) +
           page.table("design", htmlRows(printedRows(designsGrid(report, style)))) +
           paragraphs(designAnswerSentences(report, style), page);
}

}  // namespace

std::string studiesHtml(const ReportStudies& studies, const ReportElements& page) {
    std::string html;
    if (studies.drilling || studies.scan) html += page.heading(translatable("Continuous drilling"));
    if (studies.drilling) html += drillingHtml(*studies.drilling, page);
    if (studies.scan) html += scanHtml(*studies.scan, studies.drilling.get(), page);
    if (studies.design) html += designHtml(*studies.design, page);
    return html;
}

}  // namespace drillwave
