// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/archive/row_record.h"

#include <algorithm>
#include <map>

#include "core/model/version.h"
#include "core/text/decimal_text.h"
#include "core/text/message.h"
#include "core/text/text_input.h"
#include "core/yaml/scenario_file.h"
#include "core/yaml/scenario_text.h"
#include "core/yaml/yaml_tree.h"

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

constexpr std::string_view itsOwn[] = {"rows", "unsolved", "bytes", "crc32", "part", "command"};

/// The lines of a key at the top, with those that belong to it.
struct Entry {
    std::string_view key;
    std::string_view lines;
};

std::vector<Entry> entriesOf(std::string_view record) {
    std::vector<Entry> entries;
    while (!record.empty()) {
        std::size_t end = std::min(record.find('\n'), record.size() - 1) + 1;
        while (end < record.size() && (record[end] == ' ' || record[end] == '\n'))
            end = std::min(record.find('\n', end), record.size() - 1) + 1;
        const std::string_view lines = record.substr(0, end);
        entries.push_back({lines.substr(0, std::min(lines.find(':'), lines.size())), lines});
        record.remove_prefix(end);
    }
    return entries;
}

[[noreturn]] void refusePart(const std::string& file, const Message& reason) {
    throw ScenarioError(
        ScenarioError::Kind::unreadable, file + ".yaml",
        {{"", {translatable("%1; joining needs the records written with the parts"), {reason}}}});
}

Message placeOf(const Shard& shard) {
    return {translatable("part %1 of %2"), {std::to_string(shard.index), std::to_string(shard.count)}};
}

/// "3", "3, 5 to 9", at most some of them.
Message rangesOf(const std::vector<std::uint64_t>& numbers) {
    constexpr int mostRanges = 20;
    Message text;
    int ranges = 0;
    for (std::size_t i = 0; i < numbers.size();) {
        std::size_t end = i;
        while (end + 1 < numbers.size() && numbers[end + 1] == numbers[end] + 1) ++end;
        if (ranges++ == mostRanges) return {"%1 …", {text}};
        Message range = std::to_string(numbers[i]);
        if (end > i)
            range = {end == i + 1 ? "%1, %2" : translatable("%1 to %2"),
                     {range, std::to_string(numbers[end])}};
        text = joined(std::move(text), "%1, %2", std::move(range));
        i = end + 1;
    }
    return text;
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

RowPart parseRowPart(std::string_view record, const std::string& file) {
    if (!record.starts_with(rowRecordKey)) refusePart(file, translatable("is not a record of rows"));
    const YamlTree tree = parseYaml(record);
    if (!tree.problem.text.isEmpty())
        refusePart(file, {translatable("cannot be read: %1"), {tree.problem.text}});
    const std::string* format = tree.root.textOf(rowRecordFormatKey);
    const std::string known = std::to_string(rowRecordFormat);
    if (!format || *format != known)
        refusePart(file, {translatable("is of another format than %1, from a newer program"), {known}});
    const std::optional<std::string_view> entries = unsealed(record);
    if (!entries) refusePart(file, translatable("has no checksum, or was changed after it was written"));
    const std::string* command = tree.root.textOf("command");
    const std::string* checksum = tree.root.textOf("crc32");
    const YamlNode* part = tree.root.valueOf("part");
    RowPart read;
    read.file = file;
    read.record = std::string(*entries);
    if (!command) refusePart(file, translatable("has no command"));
    const auto numberOf = [&](const char* key) {
        const std::string* text = tree.root.textOf(key);
        const auto number = text ? wholeNumberIn<std::uint64_t>(*text) : std::nullopt;
        if (!number) refusePart(file, {translatable("has no whole number `%1`"), {key}});
        return *number;
    };
    read.rows = numberOf("rows");
    read.unsolved = numberOf("unsolved");
    read.sum.bytes = numberOf("bytes");
    const std::optional<std::uint32_t> crc32 = checksum ? checksumOf(*checksum) : std::nullopt;
    if (!crc32) refusePart(file, {translatable("has no `%1`"), {"crc32"}});
    read.sum.crc32 = *crc32;
    if (part) {
        const std::optional<Shard> shard = parseShard(part->text);
        if (!shard) refusePart(file, {translatable("part: %1 is no part I/N"), {part->text}});
        read.shard = *shard;
    }
    read.command = *command;
    return read;
}

std::string differingKey(const RowPart& one, const RowPart& other) {
    std::map<std::string_view, std::string_view> left;
    for (const Entry& entry : entriesOf(other.record)) left[entry.key] = entry.lines;
    for (const Entry& entry : entriesOf(one.record)) {
        const auto same = left.find(entry.key);
        const bool isOwn = std::ranges::find(itsOwn, entry.key) != std::end(itsOwn);
        if (!isOwn && (same == left.end() || same->second != entry.lines)) return std::string(entry.key);
        if (same != left.end()) left.erase(same);
    }
    for (const std::string_view key : itsOwn) left.erase(key);
    return left.empty() ? std::string() : std::string(left.begin()->first);
}

std::vector<Message> wholeProblems(std::span<const RowPart> parts) {
    std::vector<Message> problems;
    const auto add = [&](const char* pattern, std::vector<Message> places) {
        problems.emplace_back(pattern, std::move(places));
    };
    std::map<std::uint64_t, const RowPart*> byIndex;
    std::uint64_t rows = 0;
    for (const RowPart& part : parts) {
        const auto [there, isNew] = byIndex.emplace(part.shard.index, &part);
        if (isNew)
            rows += part.rows;
        else
            add(translatable("%1: is %2, as %3 is; give each part once"),
                {part.file, placeOf(part.shard), there->second->file});
    }
    const std::uint64_t count = parts.front().shard.count;
    std::vector<std::uint64_t> missing;
    for (std::uint64_t index = 1; index <= count; ++index)
        if (!byIndex.contains(index)) missing.push_back(index);
    if (!missing.empty())
        add(missing.size() == 1 ? translatable("part %1 of %2 is missing; run it, or name its file")
                                : translatable("parts %1 of %2 are missing; run them, or name their files"),
            {rangesOf(missing), std::to_string(count)});
    if (!problems.empty()) return problems;
    for (const RowPart& part : parts)
        if (const std::uint64_t own = rowsOf(part.shard, rows).size(); part.rows != own)
            add(translatable("%1: has %2 rows, but %3 of all %4 has %5; it belongs to another run"),
                {part.file, std::to_string(part.rows), placeOf(part.shard), std::to_string(rows),
                 std::to_string(own)});
    return problems;
}

std::string wholeRecord(const RowPart& part, std::string_view command, const WholeRows& whole) {
    std::string record;
    for (const Entry& entry : entriesOf(part.record)) {
        if (entry.key == "command")
            record += "command: " + yamlScalar(command) + "\n";
        else if (entry.key == "rows")
            record += "rows: " + std::to_string(whole.rows) + "\n";
        else if (entry.key == "unsolved")
            record += "unsolved: " + std::to_string(whole.unsolved) + "\n";
        else if (entry.key == "bytes")
            record += sumLines("", whole.sum);
        else if (entry.key != "crc32" && entry.key != "part")
            record += entry.lines;
    }
    return sealed(std::move(record));
}

}  // namespace drillwave
