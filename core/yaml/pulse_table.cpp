// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/yaml/pulse_table.h"

#include <sstream>

#include "core/disk/file_bytes.h"
#include "core/model/pulse_force.h"
#include "core/text/csv.h"
#include "core/text/decimal_text.h"
#include "core/text/text_input.h"
#include "core/text/unit_heading.h"
#include "core/text/units.h"

namespace drillwave {
namespace {

constexpr std::size_t maximumTableBytes = std::size_t{16} << 20;
constexpr std::size_t maximumRecordBytes = 4096;
constexpr std::size_t mostWrongRows = 20;

class TableReader {
  public:
    TableReader(std::string source, ScenarioForm form) : m_source(std::move(source)), m_form(form) {}

    PulseTable read(const std::string& bytes) {
        std::istringstream in(bytes);
        CsvReader csv(in, maximumRecordBytes);
        CsvRecord record;
        if (!csv.next(record)) {
            report(1, "holds no header `" + expectedHeader() + "`");
            return std::move(m_table);
        }
        readHeader(record, csv.line());
        while (m_table.problems.size() < mostWrongRows && csv.next(record)) readPoint(record, csv.line());
        if (m_table.problems.empty()) checkPoints(csv.line());
        return std::move(m_table);
    }

  private:
    bool dimensional() const { return m_form != ScenarioForm::dimensionless; }
    std::string expectedHeader() const { return dimensional() ? "time [us],force [kN]" : "time,force"; }

    void report(int line, const Message& reason) {
        m_table.problems.push_back({"pulse.file", reason, line, 1, m_source});
    }

    const Unit* columnUnit(const std::string& cell, std::string_view name, Quantity quantity, int line) {
        const UnitHeading header = splitHeading(cell);
        const Quantity expected = dimensional() ? quantity : Quantity::ratio;
        const Unit* unit = findUnit(expected, header.unit);
        if (header.name != name)
            report(line, {translatable("drillwave::Message", "%1 (the header must be %2)"),
                          {"`" + shortened(cell) + "`", "`" + expectedHeader() + "`"}});
        else if (!unit)
            report(line, {dimensional()
                              ? translatable("drillwave::Message", "%1 (needs a unit in brackets, one of %2)")
                              : translatable("drillwave::Message",
                                             "%1 (must have no unit in a dimensionless scenario)"),
                          {"`" + shortened(cell) + "`", unitList(quantity)}});
        return unit;
    }

    void readHeader(const CsvRecord& record, int line) {
        const bool isHeader =
            record.problem.isEmpty() && record.cells.size() == 2 &&
            (splitHeading(record.cells[0]).name == "time" || splitHeading(record.cells[1]).name == "force");
        if (!isHeader) {
            report(line, record.problem.isEmpty()
                             ? Message(translatable("drillwave::Message", "the header must be %1"),
                                       {"`" + expectedHeader() + "`"})
                             : record.problem);
            return;
        }
        m_timeUnit = columnUnit(record.cells[0], "time", Quantity::time, line);
        m_forceUnit = columnUnit(record.cells[1], "force", Quantity::force, line);
    }

    double number(const std::string& cell, std::string_view column, Quantity quantity, const Unit* unit,
                  int line) {
        const Quantity expected = dimensional() ? quantity : Quantity::ratio;
        const TypedQuantity typed = parseQuantity(cell, expected, BareNumber::inDefaultUnit, unit);
        if (!typed.valid())
            report(line, {"%1 (%2)", {std::string(column) + " = " + shortened(cell), typed.problem}});
        return typed.si;
    }

    void readPoint(const CsvRecord& record, int line) {
        if (!m_timeUnit || !m_forceUnit) return;
        if (!record.problem.isEmpty() || record.cells.size() != 2) {
            report(line, record.problem.isEmpty()
                             ? Message(translatable("drillwave::Message", "a row must be a time and a force"))
                             : record.problem);
            return;
        }
        const double time = number(record.cells[0], "time", Quantity::time, m_timeUnit, line);
        const double force = number(record.cells[1], "force", Quantity::force, m_forceUnit, line);
        if (m_table.points.size() <= static_cast<std::size_t>(maximumPulseSegments))
            m_table.points.push_back({time, force});
        m_lines.push_back(line);
    }

    void checkPoints(int lastLine) {
        const PointProblem problem = pointProblem(m_table.points);
        if (problem.reason.isEmpty()) return;
        report(problem.index < m_lines.size() ? m_lines[problem.index] : lastLine, problem.reason);
    }

    std::string m_source;
    ScenarioForm m_form;
    const Unit* m_timeUnit = nullptr;
    const Unit* m_forceUnit = nullptr;
    std::vector<int> m_lines;
    PulseTable m_table;
};

}  // namespace

PulseTable readPulseTable(const std::string& path, const std::string& source, ScenarioForm form) {
    const FileBytes file = readFile(path, maximumTableBytes);
    PulseTable table;
    table.unreadable = true;
    if (!file.problem.isEmpty()) {
        table.problems.push_back({"pulse.file",
                                  {translatable("drillwave::Message", "the pulse table %1"), {file.problem}},
                                  0,
                                  0,
                                  source});
        return table;
    }
    const TextProblem text = checkText(file.bytes);
    if (!text.reason.empty()) {
        const TextPosition at = positionOf(file.bytes, text.offset);
        table.problems.push_back({"pulse.file",
                                  {translatable("drillwave::Message", "is not text: it holds %1"),
                                   {Message::ofTable(text.reason)}},
                                  at.line,
                                  at.column,
                                  source});
        return table;
    }
    return TableReader(source, form).read(file.bytes);
}

}  // namespace drillwave
