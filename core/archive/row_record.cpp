// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/archive/row_record.h"

#include <algorithm>

#include "core/model/version.h"
#include "core/text/text_input.h"
#include "core/yaml/scenario_text.h"

namespace drillwave {
namespace {

/// The text as the lines of a YAML block, to be read back as it is.
std::string block(std::string_view text) {
    text.remove_prefix(byteOrderMarkLength(text));
    std::string lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        if (line.ends_with('\r')) line.remove_suffix(1);
        if (!line.empty()) lines += "  ";
        lines += line;
        lines += '\n';
    }
    return lines;
}

std::string line(std::string_view key, std::string_view value) {
    return std::string(key) + ": " + std::string(value) + "\n";
}

}  // namespace

std::string recordText(const RowRecord& record) {
    return sealed(recordEntries(record));
}

std::string sumLines(std::string_view prefix, const FileSum& sum) {
    const std::string begin(prefix);
    return line(begin + "bytes", std::to_string(sum.bytes)) +
           line(begin + "crc32", "\"" + sum.checksum() + "\"");
}

std::string sealed(std::string entries) {
    entries += line(recordChecksumKey, "\"" + sumOf(entries).checksum() + "\"");
    return entries;
}

std::optional<std::string_view> unsealed(std::string_view record) {
    const std::size_t begin = record.rfind(recordChecksumKey);
    if (begin == std::string_view::npos) return std::nullopt;
    const std::string_view entries = record.substr(0, begin);
    return sealed(std::string(entries)) == record ? std::optional(entries) : std::nullopt;
}

std::string recordEntries(const RowRecord& record) {
    std::string text = std::string(rowRecordKey) + " " + std::to_string(rowRecordFormat) + "\n" +
                       line("version", versionText) + line("command", yamlScalar(record.command));
    if (record.method) text += line("method", name(record.method->method));
    if (record.method && record.method->method == Method::lattice)
        text += line("segments", std::to_string(record.method->lattice.segments));
    text += line("rows", std::to_string(record.rows));
    if (record.unsolved) text += line("unsolved", std::to_string(*record.unsolved));
    if (record.file) text += sumLines("", *record.file);
    if (record.shard.count > 1)
        text += line("part", std::to_string(record.shard.index) + "/" + std::to_string(record.shard.count));
    if (!record.cases.empty()) text += line("cases", yamlScalar(record.cases));
    if (record.casesFile) text += sumLines("cases_", *record.casesFile);
    if (!record.axes.empty()) text += "axes:\n";
    for (const RecordedAxis& axis : record.axes)
        text += "  - column: " + yamlScalar(axis.column) + "\n    values: " + yamlScalar(axis.values) +
                (axis.count > 0 ? "\n    count: " + std::to_string(axis.count) : std::string()) + "\n";
    text += "outputs:\n";
    for (const std::string& output : record.outputs) text += "  - " + yamlScalar(output) + "\n";
    return text + "scenario: |2\n" + block(record.scenario);
}

}  // namespace drillwave
