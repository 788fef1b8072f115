#include "core/study/table_header.h"

#include <algorithm>

#include "core/model/decimal_text.h"
#include "core/study/output_column.h"

namespace drillwave {

namespace {

/// "rod.length [mm]" in its parts; `unit` is empty without brackets.
struct NameAndUnit {
    std::string_view name;
    std::string_view unit;
};

NameAndUnit split(std::string_view cell) {
    cell = trimmed(cell);
    const std::size_t bracket = cell.find('[');
    if (bracket == std::string_view::npos || !cell.ends_with(']')) return {cell, {}};
    return {trimmed(cell.substr(0, bracket)), trimmed(cell.substr(bracket + 1, cell.size() - bracket - 2))};
}

bool isOutput(std::string_view name) {
    const auto names = outputNames();
    return std::ranges::find(names, name) != names.end();
}

std::string passedThrough(std::size_t number, std::string_view name) {
    const std::string near = nearestKey(name);
    return "column " + std::to_string(number) + " `" + shortened(name) +
           "` is not a parameter and only passed through" +
           (near.empty() ? "" : "; did you mean `" + near + "`?");
}

void readUnit(TableColumn& column, std::string_view unit, std::size_t number, TableHeader& header) {
    if (unit.empty()) return;
    const Quantity quantity = column.parameter->quantity;
    column.unit = findUnit(quantity, unit);
    if (column.unit) return;
    const std::string which = "column " + std::to_string(number) + " " + std::string(column.key());
    header.problems.push_back(quantity == Quantity::ratio
                                  ? which + " has no unit; write it without `[" + shortened(unit) + "]`"
                                  : which + ": unit `" + shortened(unit) +
                                        "` is not known here; units that would do: " + unitList(quantity));
}

void checkTwice(const TableColumn& column, std::size_t number, TableHeader& header) {
    const auto earlier = std::ranges::find(header.columns, column.key(), &TableColumn::key);
    if (earlier == header.columns.end()) return;
    header.problems.push_back("column " + std::to_string(number) + " sets " + std::string(column.key()) +
                              " again, column " + std::to_string(earlier - header.columns.begin() + 1) +
                              " does already; keep one of them");
}

}  // namespace

std::string_view TableColumn::key() const {
    if (kind == Kind::shape) return "pulse.shape";
    return kind == Kind::parameter ? parameter->key : std::string_view();
}

std::vector<std::size_t> TableHeader::assignmentOrder() const {
    // The parameter table has the groups last; the shape, which is not in it, has a null pointer.
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < columns.size(); ++i)
        if (columns[i].kind != TableColumn::Kind::other) order.push_back(i);
    std::ranges::sort(order, {}, [this](std::size_t i) { return columns[i].parameter; });
    return order;
}

TableHeader readTableHeader(std::span<const std::string> cells) {
    TableHeader header;
    for (const std::string& cell : cells) {
        const std::size_t number = header.columns.size() + 1;
        const auto [name, unit] = split(cell);
        TableColumn column{.text = cell};
        column.parameter = findParameter(name);
        if (column.parameter)
            column.kind = TableColumn::Kind::parameter;
        else if (name == "pulse.shape")
            column.kind = TableColumn::Kind::shape;
        else if (!isOutput(name))
            header.warnings.push_back(passedThrough(number, name));
        if (column.parameter) readUnit(column, unit, number, header);
        if (column.kind != TableColumn::Kind::other) checkTwice(column, number, header);
        header.columns.push_back(std::move(column));
    }
    return header;
}

}  // namespace drillwave
