// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/yaml/pulse_reader.h"

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "core/disk/file_bytes.h"
#include "core/model/parameter.h"
#include "core/model/parameter_text.h"
#include "core/model/pulse_force.h"
#include "core/signal/detected_table.h"
#include "core/signal/samples.h"
#include "core/signal/text_lines.h"
#include "core/text/decimal_text.h"
#include "core/text/units.h"

namespace drillwave {

namespace {

constexpr std::size_t maximumWrongPoints = 20;

/// The shape, or nullopt where it is missing or wrong, which is reported.
std::optional<PulseShape> readShape(SectionReader& reader, const YamlEntries& entries) {
    const auto found = entries.find("shape");
    if (found == entries.end()) {
        reader.requireShape(entries);
        return std::nullopt;
    }
    const YamlEntry& entry = found->second;
    const std::optional<PulseShape> shape = findPulseShape(entry.value->text);
    if (shape)
        reader.scenario().pulse.shape = *shape;
    else
        reader.problems().reportValue(entry.place(), pulseShapeKey, entry.value->text,
                                      {translatable("must be one of %1"), {pulseShapeList()}});
    return shape;
}

void refuseTableKeys(SectionReader& reader, const YamlEntries& entries, PulseShape shape) {
    for (const std::string_view key : {"file", "points"})
        if (const auto found = entries.find(key); found != entries.end())
            reader.problems().reportKey(
                found->second.key->offset, joinedKey("pulse", key),
                {translatable("only for a table; the shape is %1"), {std::string(name(shape))}});
}

bool readCoordinate(SectionReader& reader, const YamlNode& node, Quantity quantity, std::string_view unit,
                    double& value) {
    const Quantity expected = hasUnits(reader.scenario()) ? quantity : Quantity::ratio;
    const Unit* example = findUnit(expected, hasUnits(reader.scenario()) ? unit : "");
    const TypedQuantity typed = parseQuantity(node.text, expected, BareNumber::refused, example);
    if (!typed.valid()) reader.problems().reportValue(node.offset, "pulse.points", node.text, typed.problem);
    value = typed.si;
    return typed.valid();
}

bool readPoint(SectionReader& reader, const YamlNode& item, TablePoint& point) {
    const auto& parts = item.children;
    const bool pair = item.kind == YamlKind::sequence && parts.size() == 2 &&
                      parts[0].kind == YamlKind::scalar && parts[1].kind == YamlKind::scalar;
    if (!pair) {
        const std::string_view example = hasUnits(reader.scenario()) ? "[200 us, 255 kN]" : "[0.5, 1]";
        reader.problems().reportKey(
            item.offset, "pulse.points",
            {translatable("each point must be [time, force], as in %1"), {std::string(example)}});
        return false;
    }
    const bool time = readCoordinate(reader, parts[0], Quantity::time, "us", point.time);
    const bool force = readCoordinate(reader, parts[1], Quantity::force, "kN", point.force);
    return time && force;
}

void readPoints(SectionReader& reader, const YamlEntry& entry) {
    reader.setPlace("pulse.points", entry.place());
    if (entry.value->kind != YamlKind::sequence) {
        reader.problems().reportKey(entry.place(), "pulse.points",
                                    translatable("must be a list of [time, force]"));
        return;
    }
    std::vector<TablePoint> points;
    std::size_t wrong = 0;
    for (const YamlNode& item : entry.value->children) {
        TablePoint point;
        if (!readPoint(reader, item, point) && ++wrong >= maximumWrongPoints) break;
        points.push_back(point);
    }
    reader.scenario().pulse.tablePoints = std::move(points);
}

bool readTableFile(SectionReader& reader, const YamlEntry& entry, const TableSource& tables) {
    reader.setPlace("pulse.points", entry.place());
    const std::string& file = entry.value->text;
    if (entry.value->kind != YamlKind::scalar || file.empty()) {
        reader.problems().reportKey(entry.place(), "pulse.file",
                                    translatable("must be the name of a CSV file"));
        return false;
    }
    Pulse& pulse = reader.scenario().pulse;
    pulse.tableFile = file;
    if (tables.points) {
        pulse.tablePoints = *tables.points;
        return false;
    }
    const std::string path = (std::filesystem::path(tables.source).parent_path() / file).string();
    const bool alone = reader.problems().empty();
    PulseTable table = readPulseTable(path, path, reader.scenario().form);
    const bool unreadable = table.unreadable && alone;
    for (InputProblem& problem : table.problems) {
        if (problem.line == 0)
            reader.problems().reportValue(entry.place(), "pulse.file", file, problem.text);
        else
            reader.problems().report(std::move(problem));
    }
    pulse.tablePoints = std::move(table.points);
    return unreadable;
}

bool readTable(SectionReader& reader, const YamlEntries& entries, const TableSource& tables) {
    reader.requireOneOf(entries, "pulse", "file", "points");
    if (const auto points = entries.find("points"); points != entries.end())
        readPoints(reader, points->second);
    else if (const auto file = entries.find("file"); file != entries.end())
        return readTableFile(reader, file->second, tables);
    return false;
}

constexpr std::size_t maximumTableBytes = std::size_t{16} << 20;
constexpr std::size_t headLines = 2000;

class TableReader {
  public:
    TableReader(std::string source, ScenarioForm form) : m_source(std::move(source)), m_form(form) {}

    PulseTable read(const std::string& bytes) {
        std::istringstream in(bytes);
        const std::vector<std::string> lines = firstLines(in, headLines);
        if (std::ranges::all_of(lines, [](const std::string& line) { return isPassedOver(line, ','); })) {
            report(1, {translatable("holds no header `%1`"), {expectedHeader()}});
            return std::move(m_table);
        }
        const DetectedTable table = detectTable(lines);
        m_headerLine = static_cast<int>(std::max<std::size_t>(2, table.firstLine)) - 1;
        if (!table.hasSamples() || !chooseColumns(table)) {
            if (m_table.problems.empty()) refuse(bytes, lines.front());
            return std::move(m_table);
        }
        in.clear();
        in.seekg(0);
        takeSamples(readSamples(in, m_guess.source));
        return std::move(m_table);
    }

  private:
    bool dimensional() const { return m_form != ScenarioForm::dimensionless; }
    std::string expectedHeader() const { return dimensional() ? "time [us],force [kN]" : "time,force"; }

    void report(int line, const Message& reason) {
        m_table.problems.push_back({"pulse.file", reason, line, 1, m_source});
    }

    /// Says why no columns of samples are found.
    void refuse(const std::string& bytes, const std::string& firstLine) {
        if (bytes.find('\0') != std::string::npos)
            report(1, translatable("is not text"));
        else if (firstLine == expectedHeader())
            report(2, translatable("needs at least two rows of numbers below the header"));
        else
            report(m_headerLine, {translatable("the header must be %1"), {"`" + expectedHeader() + "`"}});
    }

    /// Returns whether both units are known; reports what is missing.
    bool chooseColumns(const DetectedTable& table) {
        m_guess = guessedSource(table);
        if (table.hasRows) {
            report(1, translatable(
                          "each channel is a row; run `drillwave signal FILE -o blow.csv` and use blow.csv"));
            return false;
        }
        if (table.isDecimalOpen) {
            report(m_headerLine, translatable("1,234 can be a decimal number or a thousand: write one number "
                                              "with another count of decimals, such as 0,5 or 0.5"));
            return false;
        }
        if (!m_guess.source.timeColumn && !(m_guess.hasRate && dimensional())) return false;
        const TableColumn& force = table.columns[m_guess.source.valueColumn];
        const TableColumn time =
            m_guess.source.timeColumn ? table.columns[*m_guess.source.timeColumn] : TableColumn{};
        if (time.name.empty() && time.unit.empty() && force.name.empty() && force.unit.empty() &&
            !time.isStamp)
            return false;
        if (m_guess.rivals > 0 && force.name != "force") {
            report(m_headerLine,
                   {translatable("several columns could be the force, %1 is one; leave the others out"),
                    {"`" + shortened(force.name) + "`"}});
            return false;
        }
        return dimensional() ? takeUnits(time, force) : refuseUnits(time, force);
    }

    static std::string heading(const TableColumn& column) {
        return "`" + shortened(column.unit.empty() ? column.name : column.name + " [" + column.unit + "]") +
               "`";
    }

    bool takeUnits(const TableColumn& time, const TableColumn& force) {
        if (m_guess.source.timeColumn && !m_guess.hasTimeUnit) needUnit(time, unitList(Quantity::time));
        if (!m_guess.unit)
            needUnit(force, unitList(Quantity::force));
        else if (m_guess.unit->kind != SignalKind::force)
            report(
                m_headerLine,
                {translatable("%1 is not a force; `--signal FILE` and the import convert strains and volts"),
                 {heading(force)}});
        if (!m_table.problems.empty()) return false;
        m_forceUnit = m_guess.unit->unit.factor;
        return true;
    }

    void needUnit(const TableColumn& column, const std::string& units) {
        report(m_headerLine,
               {translatable("%1 (needs a unit in brackets, one of %2)"), {heading(column), units}});
    }

    bool refuseUnits(const TableColumn& time, const TableColumn& force) {
        for (const TableColumn& column : {time, force})
            if (!column.unit.empty())
                report(m_headerLine, {translatable("%1 (must have no unit in a dimensionless scenario)"),
                                      {heading(column)}});
        m_guess.source.timeUnit = 1;
        return m_table.problems.empty();
    }

    void takeSamples(const Samples& samples) {
        if (!samples.problem.empty()) {
            report(samples.problemLine > 0 ? static_cast<int>(samples.problemLine) : m_headerLine + 1,
                   Message(samples.problem));
            return;
        }
        for (std::size_t i = 0; i < samples.time.size(); ++i) {
            m_table.points.push_back({samples.time[i], samples.value[i] * m_forceUnit});
            if (m_table.points.size() > static_cast<std::size_t>(maximumPulseSegments)) break;
        }
        const PointProblem problem = pointProblem(m_table.points);
        // Lines are counted without those that are passed over: most often there are none.
        if (!problem.reason.isEmpty())
            report(m_headerLine + 1 + static_cast<int>(std::min(problem.index, samples.time.size() - 1)),
                   problem.reason);
    }

    std::string m_source;
    ScenarioForm m_form;
    int m_headerLine = 1;
    SampleGuess m_guess;
    double m_forceUnit = 1;
    PulseTable m_table;
};

}  // namespace

bool readPulse(SectionReader& reader, const YamlEntries& file, const TableSource& tables) {
    const std::optional<YamlEntries> entries =
        reader.section(file, "pulse", "pulse", {"shape", "file", "points"});
    if (!entries) return false;
    const std::optional<PulseShape> shape = readShape(reader, *entries);
    using Applicability = SectionReader::Applicability;
    reader.readParameters(*entries, "pulse", shape ? Applicability::checked : Applicability::ignored);
    if (!shape) return false;
    reader.requireParameters(*entries, "pulse");
    if (shape == PulseShape::table) return readTable(reader, *entries, tables);
    refuseTableKeys(reader, *entries, *shape);
    return false;
}

PulseTable readPulseTable(const std::string& path, const std::string& source, ScenarioForm form) {
    const FileBytes file = readFile(path, maximumTableBytes);
    PulseTable table;
    table.unreadable = true;
    if (!file.problem.isEmpty()) {
        table.problems.push_back(
            {"pulse.file", {translatable("the pulse table %1"), {file.problem}}, 0, 0, source});
        return table;
    }
    if (const std::string_view what = knownFormat(file.bytes); !what.empty()) {
        table.problems.push_back({"pulse.file",
                                  {translatable("this is not a table: it is %1"), {Message::ofTable(what)}},
                                  1,
                                  1,
                                  source});
        return table;
    }
    return TableReader(source, form).read(file.bytes);
}

}  // namespace drillwave
