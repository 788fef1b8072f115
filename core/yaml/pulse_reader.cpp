// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/yaml/pulse_reader.h"

#include <filesystem>

#include "core/model/parameter.h"
#include "core/model/parameter_text.h"
#include "core/yaml/pulse_table.h"

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
                {translatable("only a table has it, the shape is %1"), {std::string(name(shape))}});
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

}  // namespace drillwave
