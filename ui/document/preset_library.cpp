// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/preset_library.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QStandardPaths>
#include <algorithm>

#include "core/yaml/preset_file.h"
#include "ui/text/settings.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

QStringList addedFiles() {
    return Settings().value(presetFilesKey).toStringList();
}

PresetSource read(const QString& path) {
    PresetSource source;
    source.path = path;
    try {
        PresetFile file = loadPresets(QFile::encodeName(path).toStdString());
        source.presets = std::move(file.presets);
        source.sectionPresets = std::move(file.sectionPresets);
    } catch (const ScenarioError& error) {
        source.problem = translated(error);
    }
    return source;
}

}  // namespace

void PresetLibrary::reload() {
    const PresetFile& builtIn = builtInPresetFile();
    m_sources.clear();
    m_sources.push_back({{}, builtIn.presets, builtIn.sectionPresets, {}});
    const QString own = QDir(folder()).filePath(QStringLiteral("presets.yaml"));
    if (QFile::exists(own)) m_sources.push_back(read(own));
    for (const QString& path : addedFiles()) m_sources.push_back(read(path));
}

const Preset* PresetLibrary::matching(PresetKind kind, const Scenario& scenario) const {
    for (const PresetSource& source : m_sources) {
        const auto found = std::ranges::find_if(source.presets, [&](const Preset& preset) {
            return preset.kind == kind && matches(preset, scenario);
        });
        if (found != source.presets.end()) return &*found;
    }
    return nullptr;
}

QString PresetLibrary::add(const QString& path) {
    const QString absolute = QFileInfo(path).absoluteFilePath();
    const PresetSource source = read(absolute);
    if (!source.problem.isEmpty()) return source.problem;
    QStringList files = addedFiles();
    files.removeAll(absolute);
    files.append(absolute);
    Settings().setValue(presetFilesKey, files);
    reload();
    return {};
}

bool PresetLibrary::wasAdded(const QString& path) const {
    return addedFiles().contains(path);
}

void PresetLibrary::remove(const QString& path) {
    QStringList files = addedFiles();
    files.removeAll(path);
    Settings().setValue(presetFilesKey, files);
    reload();
}

QString PresetLibrary::folder() {
    return QDir(QStandardPaths::writableLocation(QStandardPaths::GenericConfigLocation))
        .filePath(QStringLiteral("drillwave"));
}

}  // namespace drillwave
