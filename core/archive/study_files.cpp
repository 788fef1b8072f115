// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/archive/study_files.h"

#include <algorithm>
#include <filesystem>

#include "core/archive/picture_formats.h"
#include "core/archive/row_record.h"
#include "core/disk/file_bytes.h"
#include "core/disk/whole_folder.h"
#include "core/report/goal_report.h"
#include "core/report/map_report.h"
#include "core/report/report_html.h"

namespace drillwave {
namespace {

constexpr std::string_view rowsEnding = ".csv";
constexpr std::size_t startBytes = 8192;  // PNG, SVG and PDF say within these who made them

std::string startOf(const std::string& path) {
    return readStart(path, startBytes).bytes;
}

/// PDF has its words in UTF-16.
std::string inTwoBytes(std::string_view ascii) {
    std::string text;
    for (const char c : ascii) {
        text += '\0';
        text += c;
    }
    return text;
}

bool bears(const std::string& path, std::string_view mark) {
    const std::string start = startOf(path);
    return start.find(mark) != std::string::npos || start.find(inTwoBytes(mark)) != std::string::npos;
}

/// Returns whether CSV begins with these headers, whatever its separator is.
bool beginsAs(const std::string& path, std::string_view headers) {
    std::string start = startOf(path).substr(0, headers.size());
    std::ranges::replace(start, ';', ',');
    return start == headers;
}

bool isReportPage(const std::string& path) {
    return !reportRecord(startOf(path)).empty();
}

}  // namespace

std::string studyStem(std::string_view file) {
    if (file.size() > rowsEnding.size() && file.ends_with(rowsEnding)) file.remove_suffix(rowsEnding.size());
    return std::string(file);
}

std::string recordName(std::string_view file) {
    return std::string(file) + ".yaml";
}

std::string contoursName(std::string_view file) {
    return studyStem(file) + "_contours.csv";
}

std::string goalName(std::string_view file) {
    return studyStem(file) + "_goal.csv";
}

std::vector<std::string> studyFilesThere(const std::string& folder, const std::string& file) {
    std::vector<std::string> names;
    const auto add = [&](const std::string& name, const auto& isOurs) {
        const std::string path = pathInside(folder, name);
        if (isThere(path) && isOurs(path)) names.push_back(name);
    };
    add(recordName(file), [](const std::string& path) { return startOf(path).starts_with(rowRecordKey); });
    add(contoursName(file), [](const std::string& path) { return beginsAs(path, contoursCsvBegin); });
    add(goalName(file), [](const std::string& path) { return beginsAs(path, goalCsvBegin); });
    const std::vector<std::string> pictures = picturesThere(folder, studyStem(file), studyPictureMark);
    names.insert(names.end(), pictures.begin(), pictures.end());
    return names;
}

std::vector<std::string> picturesThere(const std::string& folder, const std::string& stem,
                                       std::string_view mark) {
    std::vector<std::string> names;
    for (const std::string_view format : pictureFormats) {
        const std::string name = stem + "." + std::string(format);
        const std::string path = pathInside(folder, name);
        if (isThere(path) && bears(path, mark)) names.push_back(name);
    }
    return names;
}

std::vector<std::string> reportFilesThere(const std::string& folder, const std::string& file) {
    if (!isThere(pathInside(folder, file))) return {};
    const std::string stem = std::filesystem::path(file).stem();
    const bool isPage = std::filesystem::path(file).extension() != ".pdf";
    const std::string other = stem + (isPage ? ".pdf" : ".html");
    const std::string path = pathInside(folder, other);
    if (!isThere(path)) return {};
    const bool isOurs = isPage ? bears(path, reportMark) : isReportPage(path);
    return isOurs ? std::vector{other} : std::vector<std::string>();
}

}  // namespace drillwave
