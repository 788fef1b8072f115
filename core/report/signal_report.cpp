// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/signal_report.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/report/report_table.h"
#include "core/signal/signal_option.h"
#include "core/text/text_layout.h"
#include "core/text/units.h"

namespace drillwave {

namespace {

const char* separatorWord(char separator) {
    switch (separator) {
        case '\t':
            return translatable("tab");
        case ';':
            return translatable("semicolon");
        case '|':
            return translatable("bar");
        case ' ':
            return translatable("blanks");
        default:
            return translatable("comma");
    }
}

/// The name of a column, its number where it has none.
std::string columnName(const SignalReading& reading, std::size_t column) {
    const std::string& name = reading.table.columns[column].name;
    return name.empty() ? std::to_string(column + 1) : name;
}

std::string timeUnitText(const SignalReading& reading) {
    if (!reading.isTimeKnown() || !reading.source.timeColumn) return {};
    for (const Unit& unit : unitsOf(Quantity::time))
        if (unit.factor() == reading.source.timeUnit) return std::string(unit.name);
    return {};
}

const char* fromWord(FactSource source) {
    switch (source) {
        case FactSource::header:
            return translatable("from the table");
        case FactSource::option:
            return translatable("from the option");
        case FactSource::estimated:
            return translatable("an estimate");
        case FactSource::assumed:
            return translatable("not stated");
    }
    return "";
}

double stepOf(const Samples& samples) {
    return (samples.time.back() - samples.time.front()) / static_cast<double>(samples.time.size() - 1);
}

const char* questionPattern(const std::string& question) {
    constexpr std::pair<std::string_view, const char*> patterns[] = {
        {"unit", translatable("Which unit has the signal? Volts also need --scale 50kN/V, or --excitation, "
                              "--gain, --bridge and --gauge-factor")},
        {"rate", translatable("What is the sampling rate?")},
        {"time_unit", translatable("Which unit have the times?")},
        {"column", translatable("Which column is the signal? Several are possible")},
        {"decimal", translatable("Is the comma in 1,234 a decimal sign or a thousands separator?")},
        {"area", translatable("What is the area of the bar at the gauge?")},
        {"modulus", translatable("What is Young's modulus of the bar?")},
        {"bridge", translatable("How many gauges of the bridge are active?")},
        {"gauge_factor", translatable("What is the gauge factor?")},
        {"impedance", translatable("What is the impedance of the bar? Give it as 18kN s/m")}};
    for (const auto& [name, pattern] : patterns)
        if (name == question) return pattern;
    return "";
}

/// Lines "name   value".
class FactLines {
  public:
    explicit FactLines(const ReadingStyle& style) : m_style(style) {}

    void add(const char* name, const Message& fact) {
        constexpr std::size_t nameColumns = 12;
        m_text += "  " + leftAligned(m_style.said(Message(name)), nameColumns) + m_style.said(fact) + "\n";
    }
    void line(const Message& fact) { m_text += "  " + m_style.said(fact) + "\n"; }
    const std::string& text() const { return m_text; }

  private:
    const ReadingStyle& m_style;
    std::string m_text;
};

std::string timeText(double seconds) {
    return inHandyUnit(seconds, Quantity::time, 6);
}

std::string joinedWords(const std::vector<std::string>& words) {
    std::string all;
    for (const std::string& word : words) all += (all.empty() ? "" : " ") + word;
    return all;
}

std::vector<std::string> codesOf(const SignalReading& reading) {
    std::vector<std::string> codes;
    for (const SignalRemark& remark : reading.remarks)
        if (std::ranges::find(codes, remark.code) == codes.end()) codes.push_back(remark.code);
    return codes;
}

JsonArray jsonArray(const std::vector<std::string>& words) {
    JsonArray array;
    for (const std::string& word : words) array.emplace_back(word);
    return array;
}

Json textOrNull(std::string_view text) {
    return text.empty() ? Json() : Json(text);
}

void addTime(FactLines& lines, const SignalReading& reading) {
    const SampleSource& source = reading.source;
    if (source.timeColumn) {
        const std::string unit = timeUnitText(reading);
        const Message stamps = translatable("times of day, as s since the first");
        lines.add(translatable("time"), {translatable("column %1, %2, %3"),
                                         {columnName(reading, *source.timeColumn),
                                          reading.table.columns[*source.timeColumn].isStamp ? stamps
                                          : unit.empty() ? Message(translatable("no unit"))
                                                         : Message(unit),
                                          fromWord(reading.timeFrom)}});
        return;
    }
    lines.add(translatable("time"),
              {translatable("evenly spaced, %1, %2"),
               {reading.rate ? Message(rateText(*reading.rate)) : Message(translatable("no rate")),
                fromWord(reading.timeFrom)}});
}

}  // namespace

std::string signalText(const NamedReading& record, const ReadingStyle& style) {
    const SignalReading& reading = record.reading;
    FactLines lines(style);
    const RowFormat& format = reading.table.format;
    lines.add(translatable("format"),
              {translatable("%1, separator %2, decimal sign %3, samples from line %4"),
               {std::string(name(reading.encoding)), separatorWord(format.separator),
                std::string(format.decimal == DecimalSign::point ? "." : ","),
                std::to_string(reading.table.firstLine)}});
    addTime(lines, reading);
    lines.add(translatable("signal"), {translatable("column %1, %2, %3"),
                                       {columnName(reading, reading.source.valueColumn),
                                        reading.unit ? Message(std::string(reading.unit->unit.name))
                                                     : Message(translatable("no unit")),
                                        fromWord(reading.unitFrom)}});
    const Samples& samples = reading.samples;
    if (reading.isTimeKnown() || reading.rate)
        lines.add(translatable("samples"), {translatable("%1, one in %2, from %3 on"),
                                            {std::to_string(samples.value.size()), timeText(stepOf(samples)),
                                             timeText(samples.time.front())}});
    else
        lines.add(translatable("samples"), Message(std::to_string(samples.value.size())));
    const std::string unit(reading.peakUnit());
    lines.add(translatable("peak"), Message(rounded(reading.peak()) + (unit.empty() ? "" : " " + unit)));
    if (!reading.isOpen()) {
        lines.add(translatable("range"),
                  {translatable("%1 to %2"), {timeText(reading.range.from), timeText(reading.range.to)}});
        lines.add(translatable("impulse"), Message(rounded(reading.blow.impulse) + " N s"));
    }
    for (const SignalRemark& remark : reading.remarks) lines.add(translatable("remark"), remark.text);
    for (const std::string& question : reading.questions)
        lines.add(
            translatable("question"),
            {translatable("%1 (%2)"), {Message(questionPattern(question)), std::string(answerTo(question))}});
    return record.file + "\n" + lines.text();
}

std::string signalSeriesText(std::span<const NamedReading> records, const ReadingStyle& style) {
    using Row = std::array<std::string, 9>;
    const auto said = [&](const char* pattern) { return style.said(Message(pattern)); };
    std::vector<Row> rows{
        {said(translatable("record")), said(translatable("samples")), said(translatable("rate")),
         said(translatable("peak")), said(translatable("impulse")), said(translatable("offset")),
         said(translatable("noise")), said(translatable("remarks")), said(translatable("questions"))}};
    const auto share = [](double value) { return rounded(100 * value, 2) + " %"; };
    for (const NamedReading& record : records) {
        const SignalReading& reading = record.reading;
        Row& row = rows.emplace_back();
        row[0] = record.file;
        if (!reading.problem.isEmpty()) {
            row[7] = said(translatable("not read"));
            continue;
        }
        row[1] = std::to_string(reading.samples.value.size());
        if (reading.isTimeKnown()) row[2] = rateText(1 / stepOf(reading.samples));
        row[3] = rounded(reading.peak(), 4) + " " + std::string(reading.peakUnit());
        if (!reading.isOpen()) row[4] = rounded(reading.blow.impulse, 4) + " N s";
        if (reading.quality.offset) {
            row[5] = share(*reading.quality.offset);
            row[6] = share(reading.quality.noise);
        }
        row[7] = joinedWords(codesOf(reading));
        row[8] = joinedWords(reading.questions);
    }
    std::array<std::size_t, 9> widths{};
    for (const Row& row : rows)
        for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], columnsOf(row[i]));
    std::string text;
    for (const Row& row : rows) {
        std::string line;
        for (std::size_t i = 0; i < row.size(); ++i)
            if (widths[i] > 0) line += (i ? "  " : "") + leftAligned(row[i], widths[i]);
        line.erase(line.find_last_not_of(' ') + 1);
        text += line + "\n";
    }
    return text;
}

JsonObject signalJson(const NamedReading& record) {
    const SignalReading& reading = record.reading;
    const SampleSource& source = reading.source;
    const RowFormat& format = reading.table.format;
    const Samples& samples = reading.samples;
    const char decimal = format.decimal == DecimalSign::point ? '.' : ',';
    JsonObject time{{"from", name(reading.timeFrom)}};
    if (source.timeColumn) {
        time["column"] = columnName(reading, *source.timeColumn);
        time["unit"] = textOrNull(timeUnitText(reading));
    } else {
        time["rate_hz"] = Json(reading.rate);
    }
    JsonArray columns;
    for (const TableColumn& column : reading.table.columns)
        columns.emplace_back(JsonObject{{"name", column.name}, {"unit", textOrNull(column.unit)}});
    const bool hasTime = reading.isTimeKnown() || reading.rate.has_value();
    const auto known = [&](double value) { return hasTime ? Json(value) : Json(); };
    return {
        {"file", record.file},
        {"format",
         JsonObject{{"encoding", name(reading.encoding)},
                    {"separator", std::string(1, format.separator)},
                    {"decimal", std::string(1, decimal)},
                    {"thousands", reading.table.groups ? Json(std::string(1, reading.table.groups)) : Json()},
                    {"first_line", reading.table.firstLine}}},
        {"time", time},
        {"signal", JsonObject{{"column", columnName(reading, source.valueColumn)},
                              {"unit", reading.unit ? Json(reading.unit->unit.name) : Json()},
                              {"from", name(reading.unitFrom)}}},
        {"columns", columns},
        {"samples", samples.value.size()},
        {"skipped_rows", samples.skipped},
        {"start_s", known(samples.time.front())},
        {"step_s", known(stepOf(samples))},
        {"range", JsonObject{{"from_s", known(reading.range.from)}, {"to_s", known(reading.range.to)}}},
        {"impulse_Ns", reading.isOpen() ? Json() : Json(reading.blow.impulse)},
        {"peak", reading.peak()},
        {"peak_unit", textOrNull(reading.peakUnit())},
        {"questions", jsonArray(reading.questions)},
        {"remarks", jsonArray(codesOf(reading))}};
}

std::string signalCsv(const SignalReading& reading) {
    const double start = reading.blow.start - reading.blow.points.front().time;
    const Unit& us = *findUnit(Quantity::time, "us");
    const Unit& kN = *findUnit(Quantity::force, "kN");
    constexpr int digits = 12;  // what shifting the times adds is rounded away
    const auto& points = reading.blow.points;
    return csvText({{"time [us]", "force [kN]"}, points.size(), [&](std::size_t row) {
                        return Cells{rounded(us.fromSi(start + points[row].time), digits),
                                     formatNumber(kN.fromSi(points[row].force))};
                    }});
}

}  // namespace drillwave
