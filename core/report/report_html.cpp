// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/report_html.h"

#include <algorithm>
#include <ranges>

#include "core/blow/blow.h"
#include "core/model/chain_words.h"
#include "core/model/section_field.h"
#include "core/model/version.h"
#include "core/report/feed_words.h"
#include "core/report/gap_report.h"
#include "core/report/html_text.h"
#include "core/report/paper_text.h"
#include "core/report/report_elements.h"
#include "core/report/report_numbers.h"
#include "core/report/report_studies.h"
#include "core/report/section_grid.h"
#include "core/report/strength_words.h"
#include "core/text/json.h"
#include "core/text/name_text.h"
#include "core/text/printed_text.h"

namespace drillwave {

namespace {

constexpr std::string_view screenStyle =
    "body{font-family:sans-serif;max-width:60em;margin:2em auto;padding:0 1em;line-height:1.35;color:#111;"
    "background:#fff}h1{font-size:1.6em}h2{font-size:1.15em;margin:1.6em 0 .4em}"
    "table{border-collapse:collapse;font-size:.9em}"
    "td,th{border-bottom:1px solid #bbb;padding:.15em .7em .15em 0;text-align:left;vertical-align:top}"
    "th{font-weight:600}td[data-value]{white-space:nowrap}.warning{border-left:.3em solid "
    "#b4231f;padding-left:.6em}"
    ".note{border-left:.3em solid "
    "#777;padding-left:.6em}.decision{font-size:1.15em;font-weight:600}pre{font-size:.8em;background:#f4f4f4;"
    "padding:.8em;"
    "overflow-x:auto}figure{margin:1.2em 0;break-inside:avoid}"
    "img{max-width:100%}figcaption{font-size:.9em;color:#333}"
    "@media print{body{margin:0;max-width:none;font-size:9.5pt}h2{break-after:avoid}"
    "tr{break-inside:avoid}pre{white-space:pre-wrap}}@page{size:A4;margin:15mm}";

// QTextDocument knows lengths only in pixels.
constexpr std::string_view paperStyle =
    "h1{font-size:15pt;margin-top:0;margin-bottom:3px}h2{font-size:10pt;margin-top:10px;margin-bottom:3px}"
    "p{margin-top:0;margin-bottom:4px}td,th{padding-right:12px;"
    "text-align:left}table.ruled{border-collapse:collapse;margin-bottom:3px}"
    "table.ruled td{border-bottom:0.5px solid #bbbbbb}table.ruled th{border-bottom:1px solid "
    "#555555}th.whole,td.whole{white-space:nowrap}p.decision{font-weight:600;margin-top:4px;margin-bottom:"
    "4px}p."
    "caption{font-size:7.5pt;margin-bottom:8px}pre{font-size:6.5pt;white-space:pre-"
    "wrap}table.dense td,table.dense th{padding-right:5px;font-size:7pt}";

constexpr std::string_view recordBegin = "<script type=\"application/json\" id=\"drillwave-record\">\n";

/// Longest texts on paper: lines of the scenario (180 mm at 6.5 pt), titles, cells and lists of gaps.
constexpr std::size_t paperColumns = 120;
constexpr std::size_t mostSectionsOnPaper = 20;
constexpr std::size_t mostTitleColumns = 160, mostCellColumns = 120, mostListColumns = 800;

class Page {
  public:
    Page(const BlowReport& report, ReportMedium medium, const ReadingStyle& style, std::size_t paperLines)
        : m_report(report), m_style(style), m_elements(medium, m_style), m_paperLines(paperLines) {}

    std::string body(const std::vector<ReportPicture>& pictures) const {
        return htmlElement("h1", bounded(reportTitle(m_report, m_style), mostTitleColumns)) + "\n" + head() +
               decision() + lead(pictures) + feed() + alerts() + results() + others() + misfits() +
               energies() + stresses() + thrust() + gap() + studiesHtml(m_report.studies, m_elements) +
               inputs() + sections() + scales() + plots(pictures) + scenario() + solver();
    }

  private:
    bool isScreen() const { return m_elements.isScreen(); }
    const Blow& blow() const { return m_report.blow; }
    const ChainWords& words() const { return chainWords(blow().scenario); }

    std::string said(const Message& message) const { return m_style.said(message); }
    std::string paragraph(const Message& text) const { return m_elements.paragraph(text); }
    std::string heading(const Message& text) const { return m_elements.heading(text); }

    /// A text that may be of any length.
    std::string bounded(std::string_view text, std::size_t mostColumns = mostCellColumns) const {
        return isScreen() ? std::string(text) : cellOnPaper(text, mostColumns);
    }

    /// Returns the names on the title page, each over its description.
    std::string head() const {
        const ReportHead& head = m_report.head;
        std::string names, values;
        const auto add = [&](const char* key, const char* english, const std::string& value) {
            if (value.empty()) return;
            const std::string name = said(english);
            const std::string shown = bounded(value, mostTitleColumns);
            if (isScreen())
                names += row(key, htmlElement("th", name) + htmlElement("td", shown));
            else
                names += htmlElement("th", name), values += htmlElement("td", shown);
        };
        add("project", translatable("Project"), head.project);
        add("author", translatable("Author"), head.author);
        add("customer", translatable("Customer"), head.customer);
        add("date", translatable("Date"), head.date);
        if (head.isEmpty()) return {};
        if (isScreen()) return tableOf("head", names);
        return tableOf("head", "<tr>" + names + "</tr>\n<tr>" + values + "</tr>\n");
    }

    /// The picture that stands for all: what the decision is about, hammer and string, or the rock.
    static std::string_view leadName(const std::vector<ReportPicture>& pictures) {
        for (const std::string_view name :
             {stringPicture, std::string_view("thrust"), std::string_view("rock")})
            if (std::ranges::find(pictures, name, &ReportPicture::name) != pictures.end()) return name;
        return {};
    }

    std::string lead(const std::vector<ReportPicture>& pictures) const {
        const auto found = std::ranges::find(pictures, leadName(pictures), &ReportPicture::name);
        if (found == pictures.end()) return {};
        return isScreen() ? figure(*found) : printed(*found);
    }

    std::string about() const {
        return said({translatable("Report on one blow of a percussive drill, written by Drillwave %1, solved "
                                  "by %2. Tension is positive. %3"),
                     {std::string(versionText), solverWords(blow()).asked, words().assumptions}});
    }

    /// Returns the required feed by the study of the feed, or otherwise by the single blow.
    std::string decision() const {
        const std::string words = estimateText(blow().scenario, blow().feed, m_style);
        return "<p class=\"decision\">" + escapedHtml(words) + "</p>\n";
    }

    /// Returns the numbers that support the statement at the top.
    std::string feed() const {
        std::string html = heading(translatable("Required feed"));
        if (m_report.thrust) {
            const std::vector<Message> sentences = thrustSentences(
                blow().scenario, m_report.thrust->study.feed, m_report.thrust->study.shareFull, m_style);
            // The estimate and its note stand at the top.
            const std::vector<Message> atTop = estimateSentences(blow().scenario, blow().feed, m_style);
            for (const Message& sentence : sentences)
                if (std::ranges::find(atTop, sentence) == atTop.end()) html += paragraph(sentence);
            return html;
        }
        return html + paragraph(asSentence(said(m_report.thrustProblem)));
    }

    std::string alerts() const {
        std::string html = heading(translatable("Alerts and remarks"));
        for (const Alert& alert : blow().alerts) html += m_elements.alert(alert);
        for (const Message& remark : m_report.recordRemarks)
            html += "<p class=\"warning\"><b>" + escapedHtml(said(translatable("Record:"))) + "</b> " +
                    escapedHtml(said(remark)) + "</p>\n";
        return blow().alerts.empty() && m_report.recordRemarks.empty()
                   ? html + paragraph(translatable("Nothing unusual."))
                   : html;
    }

    /// With the whole number behind the text on the screen, where there is one.
    std::string cell(const std::string& text, const std::optional<double>& number) const {
        if (!number || !isScreen()) return htmlElement("td", text);
        return "<td data-value=\"" + formatNumber(*number) + "\">" + escapedHtml(text) + "</td>";
    }

    std::string tableOf(const std::string& id, const std::string& rows) const {
        return m_elements.table(id, rows);
    }

    std::string table(const std::string& id, const std::vector<Message>& titles,
                      const std::string& rows) const {
        std::vector<std::string> heads;
        for (const Message& title : titles) heads.push_back(said(title));
        return tableOf(id, htmlHeads(heads) + rows);
    }

    std::string row(const std::string& key, const std::string& cells) const {
        return (isScreen() ? "<tr data-key=\"" + escapedHtml(key) + "\">" : "<tr>") + cells + "</tr>\n";
    }

    /// As the file has it, unless the reader has units of his own, and with the signs of print.
    std::string given(const ReportInput& input, const std::optional<Quantity>& quantity) const {
        constexpr int digits = 6;
        if (!input.word.isEmpty()) return said(input.word);
        if (input.si && m_style.keepsUnitsOfFile()) return bounded(printedNumber(printedUnit(input.value)));
        const bool isRead = input.si && quantity;
        return bounded(isRead ? m_style.quantity(*input.si, *quantity, digits) : input.value);
    }

    std::string inputs() const {
        std::string rows;
        for (const ReportInput& input : m_report.inputs)
            rows += row(input.key, htmlElement("td", input.key) + htmlElement("td", said(input.label)) +
                                       cell(given(input, input.quantity), input.si) +
                                       htmlElement("td", bounded(said(input.source))));
        return heading(translatable("Inputs")) + table("inputs",
                                                       {translatable("key"), translatable("what"),
                                                        translatable("value"), translatable("source")},
                                                       rows);
    }

    /// Hammer and string as the file has them.
    std::string sections() const {
        if (m_report.sections.empty()) return {};
        std::vector<Message> titles{translatable("place"), translatable("section"), translatable("times")};
        std::vector<const SectionField*> fields;
        for (const SectionField& field : sectionFields()) {
            const auto gives = [&](const ReportSection& section) { return valueOf(section, field); };
            if (std::ranges::none_of(m_report.sections, gives)) continue;
            fields.push_back(&field);
            titles.push_back(Message::ofTable(field.label));
        }
        titles.emplace_back(translatable("source"));
        std::string rows;
        const std::size_t shown = isScreen() ? m_report.sections.size() : mostSectionsOnPaper;
        for (const ReportSection& section : m_report.sections | std::views::take(shown)) {
            std::string cells = htmlElement("td", said(section.place)) +
                                htmlElement("td", bounded(section.name)) +
                                htmlElement("td", std::to_string(section.times));
            for (const SectionField* field : fields) {
                const ReportInput* value = valueOf(section, *field);
                cells += value ? cell(given(*value, field->quantity), value->si) : htmlElement("td", "");
            }
            rows += row(section.key, cells + htmlElement("td", bounded(said(section.source))));
        }
        return heading(translatable("Hammer and string")) + table("sections", titles, rows) +
               rest(m_report.sections.size());
    }

    static const ReportInput* valueOf(const ReportSection& section, const SectionField& field) {
        const auto found = std::ranges::find(section.values, field.key, &ReportInput::key);
        return found == section.values.end() ? nullptr : &*found;
    }

    /// Where a table of so many sections is not all of them.
    std::string rest(std::size_t sections) const {
        return isScreen() || sections <= mostSectionsOnPaper
                   ? std::string()
                   : paragraph({translatable("The other %1 sections are in the report as HTML."),
                                {std::to_string(sections - mostSectionsOnPaper)}});
    }

    std::string numbers(const std::vector<ReportRow>& lines, bool tellsKey) const {
        std::string rows;
        for (const ReportRow& line : lines) {
            std::string cells = htmlElement("td", line.label);
            if (tellsKey) cells = htmlElement("td", line.key) + cells;
            for (const ReportCell& each : line.cells) cells += cell(each.text, each.number);
            rows += row(line.key, cells);
        }
        return rows;
    }

    /// On paper in two halves beside each other.
    std::string scales() const {
        const std::vector<Message> titles{translatable("symbol"), translatable("what"),
                                          translatable("value")};
        const std::vector<ReportRow> rows = scaleRows(blow(), m_style);
        const std::string title = heading(translatable("Groups and scales"));
        if (isScreen()) return title + table("scales", titles, numbers(rows, true));
        const auto middle = rows.begin() + static_cast<std::ptrdiff_t>(rows.size() + 1) / 2;
        return title + beside(table("", titles, numbers({rows.begin(), middle}, true)),
                              table("", titles, numbers({middle, rows.end()}, true)));
    }

    /// On paper, which knows no other way.
    static std::string beside(const std::string& left, const std::string& right) {
        return "<table cellspacing=\"0\"><tr><td>" + left + "</td><td>" + right + "</td></tr></table>\n";
    }

    std::string results() const {
        std::vector<Message> titles{translatable("result"), translatable("scaled")};
        if (hasUnits(blow().scenario)) titles.push_back(m_style.unitsTitle());
        titles.emplace_back(translatable("place and time"));
        return heading(translatable("Results")) +
               table("results", titles, numbers(resultRows(blow(), m_style), false)) +
               paragraph(words().references);
    }

    std::string others() const {
        if (m_report.others.rows.empty()) return {};
        return heading(translatable("Comparison with other runs")) +
               comparison("runs", translatable("quantity"), m_report.others);
    }

    std::string misfits() const {
        if (m_report.misfits.rows.empty()) return {};
        return heading(translatable("Comparison with measurements")) +
               comparison("measured", translatable("signal"), m_report.misfits) +
               paragraph(
                   translatable("Over the common time: root mean square of the difference, measured minus "
                                "computed peak force, and delay of the measured signal from the best fit."));
    }

    std::string comparison(const char* key, const char* first, const ReportComparison& compared) const {
        std::vector<Message> titles{first};
        for (const std::string& title : compared.titles) titles.emplace_back(bounded(title));
        std::string rows;
        for (const ReportRow& each : compared.rows) {
            std::string cells = htmlElement("td", bounded(each.label));
            for (const ReportCell& value : each.cells) cells += cell(value.text, value.number);
            rows += row(each.key, cells);
        }
        return table(key, titles, rows);
    }

    /// Returns the errors of the numbers; none of them is a result.
    std::string solver() const {
        return heading(translatable("Numerical error")) + paragraph(about()) +
               table("solver", {translatable("error"), translatable("size")},
                     numbers(solverRows(blow(), m_style), false)) +
               paragraph(words().errors);
    }

    std::string energies() const {
        const TextGrid grid = energyGrid(blow(), m_style);
        if (grid.rows().empty()) return {};
        return heading(translatable("Energy balance")) +
               tableOf("energies",
                       htmlRows(titled({"", said(translatable("share of E₀")), said(translatable("energy"))},
                                       grid.rows())));
    }

    static std::vector<std::vector<std::string>> titled(std::vector<std::string> titles,
                                                        std::vector<std::vector<std::string>> rows) {
        rows.insert(rows.begin(), std::move(titles));
        return rows;
    }

    std::string stresses() const {
        if (blow().impact.sections.empty()) return {};
        std::vector<std::vector<std::string>> rows = sectionGrid(blow(), m_style).rows();
        const std::size_t sections = rows.size() - 1;
        if (!isScreen()) rows.resize(std::min(sections, mostSectionsOnPaper) + 1);
        return heading(translatable("Largest stresses of every section")) +
               paragraph(strengthSentence(blow().scenario, sectionStresses(blow().scenario, blow().impact),
                                          m_style)) +
               tableOf("stresses", htmlRows(rows)) + rest(sections) +
               paragraph(translatable("Places are from the rear end of a section. Reflected at a joint: the "
                                      "energy that the far end of the section reflects of the waves from the "
                                      "hammer, as a share of the hammer energy."));
    }

    std::string thrust() const {
        if (!m_report.thrust) return {};
        return heading(translatable("Required feed force")) +
               tableOf("thrust", htmlRows(needsGrid(*m_report.thrust, m_style).rows()));
    }

    std::string gap() const {
        if (!m_report.gap && m_report.gapProblem.isEmpty()) return {};
        std::string html = heading(translatable("All gaps between bit and rock"));
        if (!m_report.gap) return html + paragraph(asSentence(said(m_report.gapProblem)));
        if (const Message remark = periodRemark(*m_report.gap, m_style); !remark.isEmpty())
            html += paragraph(remark);
        html += tableOf("gap", htmlRows(gapGrid(*m_report.gap, m_style).rows()));
        for (const std::string& remark : gapRemarks(*m_report.gap, m_style))
            html += paragraph(bounded(asSentence(remark), mostListColumns));
        return html;
    }

    std::string scenario() const {
        const std::string title = heading(translatable("Scenario"));
        if (isScreen())
            return title + "<pre id=\"scenario\">\n" + escapedHtml(m_report.scenarioText) + "</pre>\n";
        const PaperLines paper = linesOnPaper(m_report.scenarioText, m_paperLines, paperColumns);
        std::string html = title + "<pre>" + escapedHtml(paper.text) + "</pre>\n";
        if (!paper.isWhole)
            html += paragraph(translatable("The rest of the scenario is in the file attached to the PDF."));
        return html;
    }

    /// But for the one that stands at the top. A page without any says why.
    std::string plots(const std::vector<ReportPicture>& pictures) const {
        std::string html;
        if (pictures.empty() && isScreen())
            html =
                paragraph(translatable("This report was written with --no-plots, so it has no plots. Write "
                                       "it again without that option to get them."));
        for (const ReportPicture& picture : pictures)
            if (picture.name != leadName(pictures)) html += isScreen() ? figure(picture) : printed(picture);
        return html.empty() ? html : heading(translatable("Plots")) + html;
    }

    static std::string image(const ReportPicture& picture) {
        return "<img src=\"" + picture.source + "\" alt=\"" + escapedHtml(picture.caption) + "\">";
    }
    static std::string figure(const ReportPicture& picture) {
        return "<figure id=\"" + picture.name + "\">\n" + image(picture) + "\n" +
               htmlElement("figcaption", picture.caption) + "\n</figure>\n";
    }
    static std::string printed(const ReportPicture& picture) {
        return "<p>" + image(picture) + "</p>\n<p class=\"caption\">" + escapedHtml(picture.caption) +
               "</p>\n";
    }

    const BlowReport& m_report;
    PrintedStyle m_style;
    ReportElements m_elements;
    std::size_t m_paperLines;
};

/// Read as the JSON of a command is; nothing in it can end the <script>.
std::string recordText(const BlowReport& report) {
    const std::string json = Json(JsonObject{{"version", versionText},
                                             {"outputs", outputsVersion},
                                             {"method", solverWords(report.blow).key},
                                             {"title", report.blow.scenario.title},
                                             {"scenario", report.scenarioText}})
                                 .text();
    std::string safe;
    for (const char c : json) safe += c == '<' ? std::string("\\u003c") : std::string(1, c);
    return safe;
}

}  // namespace

std::string reportTitle(const BlowReport& report, const ReadingStyle& style) {
    std::string title = printableLine(report.blow.scenario.title);
    return title.empty() ? style.said(translatable("Untitled scenario")) : title;
}

// No `<` stands in the record.
std::string_view reportRecord(std::string_view html) {
    const std::size_t begin = html.find(recordBegin);
    if (begin == std::string_view::npos) return {};
    const std::string_view record = html.substr(begin + recordBegin.size());
    return record.substr(0, record.find('<'));
}

std::string reportHtml(const BlowReport& report, const std::vector<ReportPicture>& pictures,
                       ReportMedium medium, const ReadingStyle& style, std::size_t paperLines) {
    const bool isScreen = medium == ReportMedium::screen;
    std::string page = "<!DOCTYPE html>\n<html lang=\"" + style.language() +
                       "\">\n<head>\n<meta charset=\"utf-8\">\n<title>" +
                       escapedHtml(reportTitle(report, style)) + "</title>\n";
    if (isScreen)
        page += std::string("<meta name=\"generator\" content=\"Drillwave ") + versionText + "\">\n" +
                std::string(recordBegin) + recordText(report) + "</script>\n";
    page += "<style>" + std::string(isScreen ? screenStyle : paperStyle) + "</style>\n</head>\n<body>\n";
    return page + Page(report, medium, style, paperLines).body(pictures) + "</body>\n</html>\n";
}

}  // namespace drillwave
